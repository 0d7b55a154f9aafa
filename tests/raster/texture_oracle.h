#pragma once
/// Texture coordinates as C10 defines them, in exact arithmetic, written without a look at raster/texture*: wrapping
/// in rationals, the linear filter as a tent over an endless row of texels.
///
/// Integer is mpz_class (any finite u) or Int128 (fast, |u| ≤ 2^20).

#include <gmpxx.h>

#include <cmath>
#include <cstdint>
#include <cstdlib>
#include <vector>

#include "raster/texture.h"

namespace lode::raster::test {

__extension__ typedef __int128 Int128;

/// numerator / denominator, denominator > 0.
template <class Integer>
struct Ratio {
  Integer numerator, denominator;
};

template <class Integer>
[[nodiscard]] Integer floor_quotient(const Integer& a, const Integer& b) {
  return Integer(a / b) - (Integer(a % b) < 0 ? 1 : 0);
}

[[nodiscard]] inline Ratio<mpz_class> exact_ratio(double u, mpz_class) {
  const mpq_class q(u);
  return {q.get_num(), q.get_den()};
}

/// Below 2^-47 only the sign matters: times 2^22 it is far from any tie and any other texel.
[[nodiscard]] inline Ratio<Int128> exact_ratio(double u, Int128) {
  int exponent = 0;
  const auto numerator = static_cast<std::int64_t>(std::ldexp(std::frexp(u, &exponent), 53));
  const int shift = 53 - exponent;
  if (shift > 100) return {Int128(numerator > 0) - Int128(numerator < 0), Int128(1) << 100};
  return {numerator, Int128(1) << shift};
}

/// u after wrapping: repeat [0, 1), mirror and clamp [0, 1], border as it is. Not finite is 0.
template <class Integer>
[[nodiscard]] Ratio<Integer> wrapped(double u, Wrap wrap) {
  auto [n, d] = exact_ratio(std::isfinite(u) ? u : 0.0, Integer());
  if (wrap == Wrap::repeat) n -= floor_quotient(n, d) * d;
  if (wrap == Wrap::mirror) {
    const Integer period = d * 2;
    n -= floor_quotient(n, period) * period;
    if (n > d) n = period - n;
  }
  if (wrap == Wrap::clamp) n = n < 0 ? Integer(0) : n > d ? d : n;
  return {n, d};
}

[[nodiscard]] inline std::int64_t small(const mpz_class& a) { return a.fits_slong_p() ? a.get_si() : 1L << 62; }
[[nodiscard]] inline std::int64_t small(Int128 a) { return static_cast<std::int64_t>(a); }

/// 256 · size · u, rounded half to even.
template <class Integer>
[[nodiscard]] std::int64_t coordinate_fx8(double u, int size_px, Wrap wrap) {
  const auto [n, d] = wrapped<Integer>(u, wrap);
  const Integer product = n * (256 * size_px);
  const Integer below = floor_quotient(product, d);
  const Integer twice_rest = (product - below * d) * 2;
  const bool odd = Integer(below % 2) != 0;
  return small(Integer(below + (twice_rest > d || (twice_rest == d && odd) ? 1 : 0)));
}

/// ⌊size · u⌋.
template <class Integer>
[[nodiscard]] std::int64_t texel_index(double u, int size_px, Wrap wrap) {
  const auto [n, d] = wrapped<Integer>(u, wrap);
  return small(floor_quotient(Integer(n * size_px), d));
}

/// The endless row of texels: which one stands at index j; −1 is the border.
[[nodiscard]] inline int texel_in_row(std::int64_t j, int size_px, Wrap wrap) {
  if (wrap == Wrap::border) return j < 0 || j >= size_px ? -1 : static_cast<int>(j);
  if (wrap == Wrap::clamp) return static_cast<int>(j < 0 ? 0 : j >= size_px ? size_px - 1 : j);
  const std::int64_t period = wrap == Wrap::repeat ? size_px : 2 * size_px;
  const std::int64_t phase = ((j % period) + period) % period;
  return static_cast<int>(phase < size_px ? phase : period - 1 - phase);
}

struct WeightedTexel {
  int texel;
  int weight;  ///< of 256, above 0
};

/// A tent of one texel's width on either side of the coordinate, over the centres 256·j + 128 of the texels.
template <class Integer>
[[nodiscard]] std::vector<WeightedTexel> tent(double u, int size_px, Wrap wrap) {
  const std::int64_t x_fx8 = coordinate_fx8<Integer>(u, size_px, wrap);
  const std::int64_t middle = floor_quotient<std::int64_t>(x_fx8, 256);
  std::vector<WeightedTexel> texels;
  for (std::int64_t j = middle - 1; j <= middle + 1; ++j) {
    const std::int64_t weight = 256 - std::abs(x_fx8 - (256 * j + 128));
    if (weight > 0) texels.push_back({texel_in_row(j, size_px, wrap), static_cast<int>(weight)});
  }
  return texels;
}

}  // namespace lode::raster::test
