#pragma once
/// The figures of one walk in the report.

#include <string>
#include <vector>

#include "experiments/report/found_results.h"

namespace lode::experiments {

/// Run time against error, a point a method, with the front of those that nothing beats in both.
[[nodiscard]] std::string time_against_error(const std::vector<Row>& summary);

/// Frame times of a few methods along the walk: the paper's Fig. 4.
[[nodiscard]] std::string times_along_the_walk(const std::vector<Row>& times);

/// Pictures that the run left for this walk, as write_case_pictures names them. Empty if there are none.
[[nodiscard]] std::string case_pictures(const FoundResults& found, const std::string& scene, const std::string& path);

}  // namespace lode::experiments
