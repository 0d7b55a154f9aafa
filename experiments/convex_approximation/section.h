#pragma once
/// The part of the report on Table 1.

#include <string>

#include "experiments/report/found_results.h"

namespace lode::experiments {

[[nodiscard]] std::string convex_approximation_section(const FoundResults& found);

}  // namespace lode::experiments
