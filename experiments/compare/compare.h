#pragma once
/// What `lodestone compare` does: metrics of two pictures, a picture of their differences, a verdict.

#include <optional>
#include <string>
#include <vector>

#include "experiments/error.h"
#include "experiments/streams.h"

namespace lode::experiments {

struct CompareOptions {
  std::string a, b;  ///< paths
  std::string metrics = "all";
  std::optional<std::string> map;
  std::vector<std::string> fail_if;  ///< "METRIC<VALUE", "METRIC>VALUE"
};

/// Prints one JSON object; check_failed if any condition holds. The map is FLIP's (or HDR-FLIP's) in the colours of
/// magma if that is the only metric asked for, else one of differences by channel. `threads`: 0 is one per processor.
/// Throws Error or geometry::Error.
[[nodiscard]] Status compare(const CompareOptions& options, int threads, const Streams& streams);

}  // namespace lode::experiments
