#pragma once
/// What was found about each method, as the report says it: rows for people, and sentences.

#include <string>
#include <vector>

#include "experiments/report/found_results.h"

namespace lode::experiments {

/// "convex_culling:mode=safe" as "convex culling, safe".
[[nodiscard]] std::string spoken_name(const std::string& method);

/// A row of add_summary for each method over all scenes and walks, and speedups: "0.9 – 1.3", the least and the
/// greatest of any walk.
[[nodiscard]] std::vector<Row> over_all_scenes(const FoundResults& found);

/// Rows of a summary without those of the renderer's skips, each with: name, spoken; speedup_with_skips; causes, "48 px
/// by slabs", of what it lost.
[[nodiscard]] std::vector<Row> with_skips_beside(const std::vector<Row>& summary);

/// What the rows of one walk (or of all) say, in a few sentences of HTML. `results`: the rows behind them.
[[nodiscard]] std::string findings(const std::vector<Row>& summary, const std::vector<Row>& results);

}  // namespace lode::experiments
