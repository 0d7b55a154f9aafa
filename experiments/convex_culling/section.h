#pragma once
/// The part of the report on culling by convex hulls and its rivals.

#include <string>

#include "experiments/report/found_results.h"

namespace lode::experiments {

/// A row a method, over all scenes: for the top of the page.
[[nodiscard]] std::string convex_culling_headline(const FoundResults& found);

[[nodiscard]] std::string convex_culling_section(const FoundResults& found);

}  // namespace lode::experiments
