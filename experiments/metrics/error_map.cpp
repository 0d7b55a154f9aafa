#include "experiments/metrics/error_map.h"

#include <algorithm>
#include <cmath>

namespace lode::experiments {

double mean_error(std::span<const float> errors) {
  double sum = 0.0;
  for (const float error : errors) sum += double{error};
  return errors.empty() ? 0.0 : sum / double(errors.size());
}

float error_percentile(std::span<const float> errors, double p) {
  if (errors.empty()) return 0.0f;
  const double n = double(errors.size());
  const double rank = std::clamp(std::ceil(p * n), 1.0, n);
  std::vector<float> sorted(errors.begin(), errors.end());
  const auto at = sorted.begin() + std::ptrdiff_t(rank) - 1;
  std::nth_element(sorted.begin(), at, sorted.end());
  return *at;
}

}  // namespace lode::experiments
