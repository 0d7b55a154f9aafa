#include "experiments/metrics/depth_error.h"

#include <algorithm>
#include <bit>
#include <cmath>
#include <cstdlib>

#include "experiments/metrics/expect_size.h"

namespace lode::experiments {
namespace {

/// Floats in order, one step apart.
std::int64_t step_of(float x) {
  const auto bits = std::bit_cast<std::uint32_t>(x);
  const auto magnitude = std::int64_t(bits & 0x7FFFFFFFu);
  return bits >> 31 != 0 ? -magnitude : magnitude;
}

}  // namespace

std::uint32_t ulp_distance(float a, float b) { return std::uint32_t(std::abs(step_of(a) - step_of(b))); }

DepthError depth_error(std::span<const float> reference, std::span<const float> rendered,
                       std::span<const std::uint8_t> where) {
  expect_size("rendered depths", reference.size(), rendered.size());
  if (!where.empty()) expect_size("mask of depths", reference.size(), where.size());
  DepthError error;
  for (std::size_t i = 0; i < reference.size(); ++i) {
    const float a = reference[i], b = rendered[i];
    if (!where.empty() && where[i] == 0) continue;
    if (std::isnan(a) || std::isnan(b)) {
      error.not_a_number += 1;
    } else if (a == 0.0f || b == 0.0f) {
      error.one_sided += a != b;
    } else {
      const std::uint32_t ulp = ulp_distance(a, b);
      error.compared += 1;
      error.max_ulp = std::max(error.max_ulp, ulp);
      error.histogram[std::size_t(std::bit_width(ulp))] += 1;
    }
  }
  return error;
}

}  // namespace lode::experiments
