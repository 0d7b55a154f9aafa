#pragma once
/// A double that knows how far it may be from the exact value: running error analysis (Higham, Accuracy and
/// Stability of Numerical Algorithms, 2nd ed., sec. 3.3). A predicate computed with it is either certain or
/// says that it is not, overflow and underflow included: then the error is infinite or NaN, and every
/// comparison with it fails.

#include <cmath>

namespace lode::raster::reference {

/// |exact − value| ≤ error.
struct Bounded {
  double value = 0.0;
  double error = 0.0;
};

/// An operation's rounding is at most 2^-53 of its result, or half the least denormal for a product. The
/// bounds are computed in double themselves: twice the need, and a little more, covers their own rounding.
inline constexpr double kRounding = 0x1p-52;
inline constexpr double kUnderflow = 0x1p-1072;
inline constexpr double kSlack = 1.0 + 0x1p-50;

[[nodiscard]] inline bool is_zero(const Bounded& a) { return a.value == 0.0 && a.error == 0.0; }

[[nodiscard]] inline Bounded operator-(const Bounded& a) { return {-a.value, a.error}; }

[[nodiscard]] inline Bounded operator+(const Bounded& a, const Bounded& b) {
  if (is_zero(a)) return b;
  if (is_zero(b)) return a;
  const double sum = a.value + b.value;
  return {sum, (a.error + b.error + kRounding * std::abs(sum)) * kSlack};
}

[[nodiscard]] inline Bounded operator-(const Bounded& a, const Bounded& b) { return a + -b; }

[[nodiscard]] inline Bounded operator*(const Bounded& a, const Bounded& b) {
  if (is_zero(a) || is_zero(b)) return {};
  const double product = a.value * b.value;
  const double carried = std::abs(a.value) * b.error + std::abs(b.value) * a.error + a.error * b.error;
  return {product, (carried + kRounding * std::abs(product) + kUnderflow) * kSlack};
}

/// a · 2^exponent.
[[nodiscard]] inline Bounded scaled(double a, int exponent) {
  const double value = std::ldexp(a, exponent);
  return {value, std::ldexp(value, -exponent) == a ? 0.0 : kUnderflow + kRounding * std::abs(value)};
}

[[nodiscard]] inline bool surely_positive(const Bounded& a) { return a.value > a.error; }
[[nodiscard]] inline bool surely_not_negative(const Bounded& a) { return a.value >= a.error; }
[[nodiscard]] inline bool surely_not_positive(const Bounded& a) { return a.value <= -a.error; }
[[nodiscard]] inline bool surely_negative(const Bounded& a) { return a.value < -a.error; }

}  // namespace lode::raster::reference
