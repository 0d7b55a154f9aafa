#pragma once
/// Depth (C5) and attributes (C7) of the samples of a picture against exact values. The oracle knows only what the
/// notes say: the snapped vertices, the vertices' depths and w, and
///
///   depth      Σ Eᵢ zᵢ / Σ Eᵢ                    Eᵢ: edge values at the sample, exact integers
///   attribute  Σ (Eᵢ/wᵢ) aᵢ / Σ (Eᵢ/wᵢ)
///
/// For a line, E₀ and E₁ are the squared length minus, and the projection of the sample onto it, held to the segment.
/// Two number types: 128-bit integers where the inputs are small enough (fast), GMP rationals for everything.

#include <gmpxx.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdint>
#include <glm/vec2.hpp>

namespace lode::raster::test {

__extension__ typedef __int128 Int128;

/// One interpolated sample: edge values ≥ 0 of its n vertices, unused ones 0.
using EdgeValues = std::array<std::int64_t, 3>;

/// Doubled area of (a, b, p).
inline std::int64_t cross(glm::ivec2 a, glm::ivec2 b, glm::ivec2 p) {
  return (std::int64_t(b.x) - a.x) * (std::int64_t(p.y) - a.y) - (std::int64_t(b.y) - a.y) * (std::int64_t(p.x) - a.x);
}

/// Of a triangle that has an area; all ≥ 0 if p is inside or on its outline.
inline EdgeValues triangle_edges(const std::array<glm::ivec2, 3>& v, glm::ivec2 p) {
  const std::int64_t sign = cross(v[0], v[1], v[2]) > 0 ? 1 : -1;
  return {sign * cross(v[1], v[2], p), sign * cross(v[2], v[0], p), sign * cross(v[0], v[1], p)};
}
inline EdgeValues line_edges(const std::array<glm::ivec2, 3>& v, glm::ivec2 p) {
  const std::int64_t dx = v[1].x - v[0].x, dy = v[1].y - v[0].y;
  const std::int64_t along = std::clamp(dx * (p.x - v[0].x) + dy * (p.y - v[0].y), std::int64_t(0), dx * dx + dy * dy);
  return {dx * dx + dy * dy - along, along, 0};
}

/// Exponent of the last place of a float of this size: 2^result is 1 ULP.
inline int ulp_exponent(double size) {
  int exponent = 0;
  std::frexp(size, &exponent);
  return std::max(exponent - 24, -149);
}

/// `value` · 2^shift as an integer. Digits below 1 are cut off; if there are any, `inexact` is set.
inline Int128 scaled(double value, int shift, bool* inexact = nullptr) {
  int exponent = 0;
  const double mantissa = std::frexp(value, &exponent);
  Int128 result = static_cast<std::int64_t>(std::ldexp(mantissa, 53));
  const int left = exponent - 53 + shift;
  if (left >= 0) return result * (Int128(1) << left);
  if (left < -120) {
    if (inexact && value != 0.0) *inexact = true;
    return 0;
  }
  const Int128 unit = Int128(1) << -left;
  if (inexact && result % unit != 0) *inexact = true;
  return result / unit;
}

/// Error of `got` as a depth, in ULP of the exact value. Exact for |E| ≤ 2^36, z multiples of 2^-73; or |E| ≤ 2^49,
/// z multiples of 2^-60.
inline double depth_error_ulp(float got, const EdgeValues& e, const std::array<double, 3>& z, int z_bits) {
  Int128 n = 0, d = 0;
  for (std::size_t i = 0; i < 3; ++i) {
    n += Int128(e[i]) * scaled(z[i], z_bits);
    d += e[i];
  }
  if (n == 0) return got == 0.0f && !std::signbit(got) ? 0.0 : 1e30;
  const int ulp = ulp_exponent(double(n) / double(d) * std::ldexp(1.0, -z_bits));
  const int up = std::max(0, -(ulp - 1 + z_bits));  // one more binary digit than got has
  n *= Int128(1) << up;
  bool inexact = false;
  const Int128 error = scaled(got, z_bits + up, &inexact) * d - n;
  if (inexact) return 1e30;  // got has digits below half a ULP: not even near
  return std::abs(double(error)) / (double(d) * std::ldexp(1.0, ulp + z_bits + up));
}

/// Error of `got` as an attribute, in ULP of the largest |a|, 2^10 ≤ |a| < 2^24. Exact but for digits of `got` below
/// 2^-20, for whole a, whole w ≤ 2^20 and |E| ≤ 2^36.
inline double attribute_error_ulp(float got, const EdgeValues& e, const std::array<std::int64_t, 3>& w,
                                  const std::array<float, 3>& a) {
  Int128 n = 0, d = 0;
  for (std::size_t i = 0; i < 3; ++i) {
    const Int128 q = Int128(e[i]) * (w[(i + 1) % 3] * w[(i + 2) % 3]);
    n += q * Int128(a[i]);
    d += q;
  }
  constexpr int kShift = 20;
  const Int128 error = scaled(got, kShift) * d - n * (Int128(1) << kShift);
  const double largest = std::max({std::abs(a[0]), std::abs(a[1]), std::abs(a[2])});
  return std::abs(double(error)) / double(d) / std::ldexp(1.0, ulp_exponent(largest) + kShift);
}

/// Σ qᵢ xᵢ / Σ qᵢ with qᵢ = Eᵢ/wᵢ, in rationals. For a depth, w = 1.
inline mpq_class exact_mean(const EdgeValues& e, const std::array<double, 3>& w, const std::array<double, 3>& x) {
  mpq_class n = 0, d = 0;
  for (std::size_t i = 0; i < 3; ++i) {
    if (e[i] == 0) continue;
    const mpq_class q = mpq_class(mpz_class(std::to_string(e[i]))) / mpq_class(w[i]);
    n += q * mpq_class(x[i]);
    d += q;
  }
  return n / d;
}

/// |got − exact| in units of 2^exponent.
inline double error_in(double got, const mpq_class& exact, int exponent) {
  mpq_class error = abs(mpq_class(got) - exact);
  if (exponent < 0) mpq_mul_2exp(error.get_mpq_t(), error.get_mpq_t(), static_cast<mp_bitcnt_t>(-exponent));
  if (exponent > 0) mpq_div_2exp(error.get_mpq_t(), error.get_mpq_t(), static_cast<mp_bitcnt_t>(exponent));
  return error.get_d();
}

/// Exponent of 1 ULP of a float at an exact value ≥ 0.
inline int ulp_exponent(const mpq_class& exact) {
  if (exact == 0) return -149;
  // 2^(k−1) < value < 2^(k+1) from the lengths; one comparison settles it.
  long k = long(mpz_sizeinbase(exact.get_num_mpz_t(), 2)) - long(mpz_sizeinbase(exact.get_den_mpz_t(), 2));
  mpq_class power = 1;
  if (k >= 0) mpq_mul_2exp(power.get_mpq_t(), power.get_mpq_t(), mp_bitcnt_t(k));
  if (k < 0) mpq_div_2exp(power.get_mpq_t(), power.get_mpq_t(), mp_bitcnt_t(-k));
  if (exact < power) --k;
  return std::max(int(k) - 23, -149);
}

}  // namespace lode::raster::test
