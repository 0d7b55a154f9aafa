#pragma once
/// Where vertices land, in exact arithmetic (C1): the snap on the bits of a number, window coordinates in rationals.

#include <gmpxx.h>

#include <bit>
#include <cmath>
#include <cstdint>

#include "hashed_numbers.h"
#include "raster/reference/clip.h"

namespace lode::raster::test {

/// round-half-even(256 · value), value = ±m · 2^e given by its parts, limited to the guard band.
[[nodiscard]] inline std::int32_t snapped_bits(bool negative, std::uint64_t m, int e) {
  constexpr std::int64_t kGuard = reference::kGuard_fx8;
  std::int64_t n = 0;
  e += 8;
  if (m == 0 || e < -54) {
    n = 0;  // below a half: m < 2^53
  } else if (e >= 0) {
    n = e > 24 || (m << (e < 11 ? e : 0)) > std::uint64_t(kGuard) || e >= 11 ? kGuard : std::int64_t(m << e);
  } else {
    const int shift = -e;
    n = std::int64_t(m >> shift);
    const std::uint64_t rest = m & ((std::uint64_t(1) << shift) - 1), half = std::uint64_t(1) << (shift - 1);
    if (rest > half || (rest == half && (n & 1) != 0)) ++n;
  }
  n = n < kGuard ? n : kGuard;
  return std::int32_t(negative ? -n : n);
}

/// Of a float's bit pattern; NaN has no place.
[[nodiscard]] inline std::int32_t snapped_bits(std::uint32_t bits) {
  const std::uint32_t exponent = (bits >> 23) & 0xFF, fraction = bits & 0x7F'FFFF;
  const bool negative = bits >> 31;
  if (exponent == 0xFF) return negative ? -reference::kGuard_fx8 : reference::kGuard_fx8;
  if (exponent == 0) return snapped_bits(negative, fraction, -149);
  return snapped_bits(negative, fraction | 0x80'0000, int(exponent) - 150);
}

/// Of a finite double.
[[nodiscard]] inline std::int32_t snapped_bits(double value) {
  const auto bits = std::bit_cast<std::uint64_t>(value);
  const int exponent = int((bits >> 52) & 0x7FF);
  const std::uint64_t fraction = bits & ((std::uint64_t(1) << 52) - 1);
  if (exponent == 0) return snapped_bits(bits >> 63, fraction, -1074);
  return snapped_bits(bits >> 63, fraction | (std::uint64_t(1) << 52), exponent - 1075);
}

/// Window x and y in 1/256 px of a clip-space point given exactly.
struct ExactWindow {
  mpq_class x_fx8, y_fx8;
};
[[nodiscard]] inline ExactWindow exact_window(const Rect& viewport, const mpq_class& x, const mpq_class& y,
                                              const mpq_class& w) {
  const glm::ivec2 o = viewport.origin_px, s = viewport.size_px;
  return {256 * (o.x + s.x * (x / w + 1) / 2), 256 * (o.y + s.y * (1 - y / w) / 2)};
}

/// C1: half a sub-pixel for the snap and 2^-20 px for the arithmetic before it.
inline const mpq_class kSnapBound_fx8 = mpq_class(1, 2) + mpq_class(1, 1 << 12);

[[nodiscard]] inline bool within_bound(const ExactWindow& exact, glm::ivec2 snapped) {
  return abs(exact.x_fx8 - snapped.x) <= kSnapBound_fx8 && abs(exact.y_fx8 - snapped.y) <= kSnapBound_fx8;
}

/// A viewport of any size and place, often small and near the origin.
[[nodiscard]] inline Rect random_viewport(HashedNumbers& random) {
  const auto size = [&] { return random.below(2) == 0 ? random.between(1, 4096) : random.between(1, 65536); };
  const auto origin = [&] { return random.below(2) == 0 ? random.between(-64, 64) : random.between(-65536, 65536); };
  const std::int32_t x = origin(), y = origin(), width = size();
  return {{x, y}, {width, size()}};
}

/// ±m · 2^e, e from low to high.
[[nodiscard]] inline double random_number(HashedNumbers& random, int low, int high) {
  const double m = random.of_magnitude(low, high);
  return random.below(2) == 0 ? m : -m;
}

/// Inside all planes: w from 2^-100 to 2^100 or of the order of 1, the window position all over the guard band, at
/// times a tie or just beside one.
[[nodiscard]] inline glm::dvec4 random_inside(HashedNumbers& random, const reference::Viewport& v) {
  for (;;) {
    const int spread = random.below(2) == 0 ? 10 : 100;
    const double w = random.of_magnitude(-spread, spread);
    const auto coordinate = [&](double centre, double half) {
      const double place = 2.0 * random.unit() - 1.0;
      double window = random.below(2) == 0 ? reference::kGuard_fx8 * place : centre + 1.5 * half * place;
      if (random.below(4) == 0) window = std::floor(window) + 0.5;
      double x = (window - centre) / half * w;
      for (std::uint32_t ulps = random.below(3); ulps > 0; --ulps) x = std::nextafter(x, 0.0);
      return x;
    };
    const double x = coordinate(v.centre_fx8.x, v.half_fx8.x);
    const glm::dvec4 p{x, coordinate(v.centre_fx8.y, -v.half_fx8.y), w * random.unit(), w};
    if (reference::outside_planes(v, p) == 0) return p;
  }
}

}  // namespace lode::raster::test
