#pragma once
/// All walks together: a row for each method, and what they say, in words.

#include <string>
#include <vector>

#include "experiments/harness/row.h"

namespace lode::experiments {

inline constexpr std::string_view kWithSkipsSuffix = " + skips";

/// A row for each method without the renderer's skips: `method`, `promise`, and over the walks with times: `speedup`,
/// `speedup_skips` (against frustum culling, mean frame times), `own_ms`; over all walks: `culled_percent`,
/// `least_culled_percent`, `false_percent` (means and the worst), `worst_false_percent`, `worst_walk`, `loses` (of
/// samples, as text).
[[nodiscard]] std::vector<Row> overview_of(const std::vector<Row>& summary);

/// Sentences for a reader who looks no further.
[[nodiscard]] std::string findings_of(const std::vector<Row>& overview);

}  // namespace lode::experiments
