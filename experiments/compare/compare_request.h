#pragma once
/// The options of `compare`, understood.

#include <optional>
#include <string>
#include <vector>

#include "experiments/compare/compare.h"

namespace lode::experiments {

/// "METRIC<VALUE" or "METRIC>VALUE".
struct Condition {
  std::string metric;
  bool below = false;
  double value = 0.0;
};

struct CompareRequest {
  std::vector<std::string> metrics;      ///< to be printed, in order
  bool all = false;                      ///< those of them that the pictures have
  std::optional<std::string> shown_map;  ///< the metric whose map --map shows; nothing: differences by channel
  std::vector<Condition> conditions;
};

/// Throws Error (wrong_usage).
[[nodiscard]] CompareRequest read_compare_request(const CompareOptions& options);

}  // namespace lode::experiments
