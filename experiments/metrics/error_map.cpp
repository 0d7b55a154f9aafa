#include "experiments/metrics/error_map.h"

#include <algorithm>
#include <cstddef>
#include <stdexcept>
#include <string>

namespace lode::experiments {

double mean_error(std::span<const float> errors) {
  double sum = 0.0;
  for (const float error : errors) sum += double{error};
  return errors.empty() ? 0.0 : sum / double(errors.size());
}

float error_percentile(std::span<const float> errors, int percent) {
  if (percent < 1 || percent > 100) {
    throw std::logic_error("error_percentile: expected 1 to 100 percent, found " + std::to_string(percent));
  }
  if (errors.empty()) return 0.0f;
  const std::size_t rank = errors.size() - errors.size() * std::size_t(100 - percent) / 100;
  std::vector<float> sorted(errors.begin(), errors.end());
  const auto at = sorted.begin() + std::ptrdiff_t(rank) - 1;
  std::nth_element(sorted.begin(), at, sorted.end());
  return *at;
}

}  // namespace lode::experiments
