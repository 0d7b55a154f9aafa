#pragma once
/// The experiment's part of the report.

#include <string>

#include "experiments/report/found_results.h"

namespace lode::experiments {

[[nodiscard]] std::string image_reuse_section(const FoundResults& found);
[[nodiscard]] std::string image_reuse_headline(const FoundResults& found);

}  // namespace lode::experiments
