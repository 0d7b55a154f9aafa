#pragma once
/// Textures, coordinates and footprints that are hard on a filter.

#include <cmath>
#include <limits>
#include <vector>

#include "hashed_numbers.h"
#include "raster/texture.h"

namespace lode::raster::test {

inline constexpr Wrap kWraps[] = {Wrap::repeat, Wrap::mirror, Wrap::clamp, Wrap::border};

/// Random bytes; about one texture in four is nearly black and white, where a rounding shows soonest.
[[nodiscard]] inline std::vector<glm::u8vec4> random_texels(HashedNumbers& random, glm::ivec2 size_px) {
  std::vector<glm::u8vec4> texels(std::size_t(size_px.x) * std::size_t(size_px.y));
  const bool harsh = random.below(4) == 0;
  for (glm::u8vec4& texel : texels) {
    for (int c = 0; c < 4; ++c) {
      const std::uint32_t value = random.below(256);
      texel[c] = static_cast<std::uint8_t>(harsh ? (value < 128 ? value & 1 : 254 + (value & 1)) : value);
    }
  }
  return texels;
}

/// Floats below 1 of many magnitudes; alpha is negative.
[[nodiscard]] inline std::vector<glm::vec4> random_linear_texels(HashedNumbers& random, glm::ivec2 size_px) {
  std::vector<glm::vec4> texels(std::size_t(size_px.x) * std::size_t(size_px.y));
  for (glm::vec4& texel : texels) {
    for (int c = 0; c < 4; ++c) texel[c] = static_cast<float>(random.of_magnitude(-40, -1));
    texel.a = -texel.a;
  }
  return texels;
}

/// 1×1, rows, columns, powers of two and others; at most `most` a side.
[[nodiscard]] inline glm::ivec2 random_size_px(HashedNumbers& random, int most) {
  const auto side = [&] {
    const std::uint32_t kind = random.below(4);
    if (kind == 0) return 1;
    if (kind == 1) return std::min(most, 1 << random.below(8));
    return random.between(1, most);
  };
  const int width_px = side();
  return {width_px, side()};
}

/// |u| ≤ 2^20: anywhere, and within three ulps of ties, texel bounds, whole numbers and 0 (denormals, too).
[[nodiscard]] inline double random_coordinate(HashedNumbers& random, int size_px) {
  const double size = size_px;
  const double whole = random.between(-3, 3);
  double u = 0.0;
  switch (random.below(8)) {
    case 0:
      return whole + random.unit();
    case 1:
      return (random.unit() - 0.5) * 0x1p21;
    case 2:
      return static_cast<double>(static_cast<float>(whole * random.unit()));
    case 3:
      u = (random.between(-1024, 256 * size_px + 1024) + 0.5) / (256.0 * size);
      break;
    case 4:
      u = whole + (random.between(0, 256 * size_px) + 0.5) / (256.0 * size);
      break;
    case 5:
      u = random.between(-2 * size_px - 1, 2 * size_px + 1) / size;
      break;
    case 6:
      u = whole;
      break;
    default:
      u = random.of_magnitude(-1073, -2) * (random.below(2) == 0 ? 1.0 : -1.0);
      break;
  }
  const double towards = random.below(2) == 0 ? -1e9 : 1e9;
  for (std::uint32_t ulps = random.below(4); ulps > 0; --ulps) u = std::nextafter(u, towards);
  return u;
}

/// Derivatives of 2^-8 to 2^8 texels in any direction, the two lengths up to 1:32 apart, at times 0, at times in an
/// exact whole-number ratio (1, too). Lengths that are equal but for a rounding are left out: the number of probes is
/// defined on the squared lengths in double.
[[nodiscard]] inline Footprint random_footprint(HashedNumbers& random, glm::ivec2 size_px) {
  Footprint footprint;
  footprint.uv = {random_coordinate(random, size_px.x), random_coordinate(random, size_px.y)};
  const double length_px = std::exp2(16.0 * random.unit() - 8.0);
  const double other_px = length_px * std::exp2(10.0 * random.unit() - 5.0);
  const double angle_rad = 6.3 * random.unit(), turn_rad = 6.3 * random.unit();
  footprint.duv_dx = {length_px * std::cos(angle_rad) / size_px.x, length_px * std::sin(angle_rad) / size_px.y};
  footprint.duv_dy = {other_px * std::cos(turn_rad) / size_px.x, other_px * std::sin(turn_rad) / size_px.y};
  if (random.below(16) == 0) footprint.duv_dx = {0.0, 0.0};
  if (random.below(16) == 0) footprint.duv_dy = {0.0, 0.0};
  if (random.below(8) == 0) {  // small fractions, so that every square is exact in double
    footprint.duv_dx = glm::dvec2{random.between(-8, 8), random.between(-8, 8)} / 64.0;
    footprint.duv_dy = footprint.duv_dx * static_cast<double>(random.between(0, 20));
  }
  return footprint;
}

[[nodiscard]] inline Sampler random_sampler(HashedNumbers& random, Filter filter) {
  Sampler sampler{.filter = filter, .wrap_u = kWraps[random.below(4)], .wrap_v = kWraps[random.below(4)]};
  sampler.max_anisotropy = random.between(1, 16);
  for (int c = 0; c < 4; ++c) sampler.border[c] = static_cast<float>(random.below(256));
  return sampler;
}

}  // namespace lode::raster::test
