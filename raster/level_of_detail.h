#pragma once
/// Which mip levels a footprint reads, and how many probes an anisotropic filter takes (C10). Lengths are in
/// texels of level 0, from the derivatives, squared, in double; the logarithm is found by table.

#include <algorithm>
#include <array>
#include <bit>
#include <cstdint>
#include <glm/vec2.hpp>

#include "raster/level_of_detail_table.h"
#include "raster/texture.h"

namespace lode::raster {

/// How many thresholds are at or below 1 + k/256: of m in [1, 2), at most one more is below m than at the multiple of
/// 1/256 below it, as they are 1.0054 and more apart from factor to factor.
inline constexpr std::array<std::uint8_t, 256> kFirstThreshold = [] {
  std::array<std::uint8_t, 256> first{};
  for (std::size_t k = 0, n = 0; k < 256; ++k) {
    while (n < 128 && kLog2Threshold[n] <= 1.0 + double(k) / 256.0) ++n;
    first[k] = std::uint8_t(n);
  }
  return first;
}();

/// λ of a length of 0, and of an infinite one.
inline constexpr std::int32_t kMinLambda_fx8 = -128 * 1024;
inline constexpr std::int32_t kMaxLambda_fx8 = 128 * 1024;

/// log2(ρ) in 1/256, rounded to nearest: round(128 · log2(ρ²)). Within 2⁻⁹ + 2⁻⁴⁰ of log2(ρ).
///   rho_squared   any double; 0, denormal, negative and NaN give kMinLambda_fx8, Inf gives kMaxLambda_fx8
[[nodiscard]] inline std::int32_t lambda_fx8(double rho_squared) {
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

/// No ρ² up to here has a λ above 0.
inline constexpr double kFirstLevelAlone = 1.0 + 0x1p-9;

/// x² + y² of a derivative in texels: (duv.x · width)² + (duv.y · height)². NaN is made 0.
[[nodiscard]] double squared_length_px(const glm::dvec2& duv, const glm::ivec2& size_px);

/// Level `level` with weight 256 − f and level + 1 with weight f, of 256. f > 0 only if level + 1 exists.
struct LevelPair {
  std::int32_t level = 0;
  std::int32_t second_weight_fx8 = 0;
};

/// λ clamped to [0, n_levels − 1], n_levels ≥ 1, and split.
[[nodiscard]] inline LevelPair mip_levels(std::int32_t lambda_fx8, std::int32_t n_levels) {
  const std::int32_t clamped_fx8 = std::clamp(lambda_fx8, 0, (n_levels - 1) * 256);
  return {clamped_fx8 >> 8, clamped_fx8 & 255};
}

/// Where an anisotropic filter reads: n trilinear probes, all at one λ, along the longer of the two derivatives.
struct Probes {
  std::int32_t n = 1;
  glm::dvec2 major_duv{0.0, 0.0};
  std::int32_t lambda_fx8 = kMinLambda_fx8;

  /// Coordinate of probe i = 1…n: uv + (i/(n+1) − ½) · major, with the factor as (2i − (n+1)) / (2(n+1)) in
  /// double, so that the probes are symmetric. One probe is at uv, whatever the derivative (even infinite).
  [[nodiscard]] glm::dvec2 at(const glm::dvec2& uv, std::int32_t i) const {
    if (n == 1) return uv;
    const double along = static_cast<double>(2 * i - (n + 1)) / static_cast<double>(2 * (n + 1));
    return {uv.x + along * major_duv.x, uv.y + along * major_duv.y};
  }
};

/// n = min(⌈ρmax/ρmin⌉, max_anisotropy), λ = log2(ρmax/n). n is the smallest with n² · ρmin² ≥ ρmax²: the maximum
/// where only ρmin is 0, 1 where both are. Of two equal lengths, x is the major one. Both are decided on the squares
/// as double has them.
///   max_anisotropy   clamped to 1…16
[[nodiscard]] Probes anisotropic_probes(const Footprint& footprint, const glm::ivec2& size_px, int max_anisotropy);

/// λ = log2(max(|∂x|, |∂y|)): one probe.
[[nodiscard]] Probes isotropic_probe(const Footprint& footprint, const glm::ivec2& size_px);

}  // namespace lode::raster
