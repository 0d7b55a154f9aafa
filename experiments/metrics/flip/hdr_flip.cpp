#include "experiments/metrics/flip/hdr_flip.h"

#include <algorithm>
#include <cmath>

#include "experiments/metrics/expect_size.h"
#include "geometry/exponential.h"

namespace lode::experiments {
namespace {

/// Narkowicz's curve (a·x² + b·x) / (c·x² + d·x + e), with the exposure of 0.6 that it was fitted with inside.
constexpr double kA = 0.6 * 0.6 * 2.51, kB = 0.6 * 0.03, kC = 0.6 * 0.6 * 2.43, kD = 0.6 * 0.59, kE = 0.14;

double tone_mapped(double x) {
  // The curve has reached 1 long before: no overflow.
  const double v = std::clamp(x, 0.0, 1e6);
  return std::min((v * (kA * v + kB)) / (v * (kC * v + kD) + kE), 1.0);
}

/// The x that the curve takes to 0.85.
double bright() {
  constexpr double kTarget = 0.85;
  constexpr double kQuadratic = kA - kTarget * kC, kLinear = kB - kTarget * kD, kConstant = -kTarget * kE;
  const double half = -0.5 * (kLinear / kQuadratic);
  return half + std::sqrt(half * half - kConstant / kQuadratic);
}

double luminance(const glm::vec4& c) {
  const glm::dvec3 v = glm::max(glm::dvec3(c), 0.0);
  return 0.2126 * v.r + 0.7152 * v.g + 0.0722 * v.b;
}

/// Of [n] > 0, the upper one of two.
double median(std::vector<double>& values) {
  const auto middle = values.begin() + std::ptrdiff_t(values.size() / 2);
  std::nth_element(values.begin(), middle, values.end());
  return *middle;
}

LinearColors exposed(std::span<const glm::vec4> colors, double exposure) {
  const double factor = geometry::exp2_of(exposure);
  return [colors, factor](std::size_t i) {
    const glm::dvec3 c = glm::dvec3(colors[i]) * factor;
    return glm::dvec3(tone_mapped(c.r), tone_mapped(c.g), tone_mapped(c.b));
  };
}

bool all_finite(std::span<const glm::vec4> colors) {
  return std::all_of(colors.begin(), colors.end(),
                     [](const glm::vec4& c) { return std::isfinite(c.r) && std::isfinite(c.g) && std::isfinite(c.b); });
}

}  // namespace

Exposures exposures_of(std::span<const glm::vec4> reference) {
  std::vector<double> luminances;
  luminances.reserve(reference.size());
  for (const glm::vec4& c : reference) luminances.push_back(luminance(c));
  double largest = 0.0;
  for (const double y : luminances) largest = std::max(largest, y);
  if (largest == 0.0) return {};
  double middle = median(luminances);
  if (middle == 0.0) {
    std::erase(luminances, 0.0);
    middle = median(luminances);
  }
  Exposures exposures{.start = geometry::log2_of(bright() / largest), .stop = geometry::log2_of(bright() / middle)};
  exposures.n = std::max(2, int(std::ceil(geometry::log2_of(largest / middle))));
  return exposures;
}

std::optional<ErrorMap> hdr_flip_map(const LinearPair& pair, const FlipParams& params) {
  expect_size("HDR-FLIP's reference", pixel_count(pair.size_px), pair.reference.size());
  expect_size("HDR-FLIP's test", pixel_count(pair.size_px), pair.test.size());
  if (!all_finite(pair.reference) || !all_finite(pair.test)) return std::nullopt;
  const Exposures exposures = exposures_of(pair.reference);
  ErrorMap largest{pair.size_px, std::vector<float>(pair.reference.size())};
  for (int i = 0; i < exposures.n; ++i) {
    const double exposure = exposures.at(i);
    const ErrorMap map =
        flip_map(pair.size_px, exposed(pair.reference, exposure), exposed(pair.test, exposure), params);
    for (std::size_t p = 0; p < map.errors.size(); ++p) largest.errors[p] = std::max(largest.errors[p], map.errors[p]);
  }
  return largest;
}

}  // namespace lode::experiments
