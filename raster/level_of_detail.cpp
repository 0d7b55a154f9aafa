#include "raster/level_of_detail.h"

#include <algorithm>
#include <bit>
#include <cmath>

#include "raster/level_of_detail_table.h"

namespace lode::raster {
namespace {

constexpr int kMaxAnisotropy = 16;

}  // namespace

std::int32_t lambda_fx8(double rho_squared) {
  if (!(rho_squared > 0.0)) return kMinLambda_fx8;  // NaN, too
  // ρ² = m · 2^e with m in [1, 2): 128 · log2(ρ²) = 128·e + 128·log2(m), and the second term rounds to the number
  // of thresholds at or below m.
  const auto bits = std::bit_cast<std::uint64_t>(rho_squared);
  const auto biased_exponent = static_cast<std::int32_t>(bits >> 52);
  if (biased_exponent == 0) return kMinLambda_fx8;
  if (biased_exponent == 2047) return kMaxLambda_fx8;
  const auto m = std::bit_cast<double>((bits & 0x000F'FFFF'FFFF'FFFF) | 0x3FF0'0000'0000'0000);
  const double* above = std::upper_bound(std::begin(kLog2Threshold), std::end(kLog2Threshold), m);
  return 128 * (biased_exponent - 1023) + static_cast<std::int32_t>(above - kLog2Threshold);
}

double squared_length_px(const glm::dvec2& duv, const glm::ivec2& size_px) {
  const double x_px = duv.x * size_px.x;
  const double y_px = duv.y * size_px.y;
  const double squared = x_px * x_px + y_px * y_px;
  return std::isnan(squared) ? 0.0 : squared;
}

LevelPair mip_levels(std::int32_t lambda_fx8, std::int32_t n_levels) {
  const std::int32_t clamped_fx8 = std::clamp(lambda_fx8, 0, (n_levels - 1) * 256);
  return {clamped_fx8 >> 8, clamped_fx8 & 255};
}

Probes isotropic_probe(const Footprint& footprint, const glm::ivec2& size_px) {
  const double x_squared = squared_length_px(footprint.duv_dx, size_px);
  const double y_squared = squared_length_px(footprint.duv_dy, size_px);
  return {.n = 1, .major_duv = {0.0, 0.0}, .lambda_fx8 = lambda_fx8(std::max(x_squared, y_squared))};
}

Probes anisotropic_probes(const Footprint& footprint, const glm::ivec2& size_px, int max_anisotropy) {
  const double x_squared = squared_length_px(footprint.duv_dx, size_px);
  const double y_squared = squared_length_px(footprint.duv_dy, size_px);
  const bool x_is_major = x_squared >= y_squared;
  const double max_squared = x_is_major ? x_squared : y_squared;
  const double min_squared = x_is_major ? y_squared : x_squared;

  const int most = std::clamp(max_anisotropy, 1, kMaxAnisotropy);
  int n = 1;
  while (n < most && n * n * min_squared < max_squared) ++n;
  return {.n = n,
          .major_duv = x_is_major ? footprint.duv_dx : footprint.duv_dy,
          .lambda_fx8 = lambda_fx8(max_squared / (n * n))};
}

}  // namespace lode::raster
