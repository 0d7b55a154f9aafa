#include "raster/level_of_detail.h"

#include <algorithm>
#include <array>
#include <bit>
#include <cmath>

#include "raster/level_of_detail_table.h"

namespace lode::raster {
namespace {

constexpr int kMaxAnisotropy = 16;

/// How many thresholds are at or below 1 + k/256: of m in [1, 2), at most one more is below m than at the multiple of
/// 1/256 below it, as they are 1.0054 and more apart from factor to factor.
constexpr std::array<std::uint8_t, 256> kFirstThreshold = [] {
  std::array<std::uint8_t, 256> first{};
  for (std::size_t k = 0, n = 0; k < 256; ++k) {
    while (n < 128 && kLog2Threshold[n] <= 1.0 + double(k) / 256.0) ++n;
    first[k] = std::uint8_t(n);
  }
  return first;
}();

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
  std::int32_t n = kFirstThreshold[bits >> 44 & 255];
  if (n < 128 && kLog2Threshold[n] <= m) ++n;
  return 128 * (biased_exponent - 1023) + n;
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
