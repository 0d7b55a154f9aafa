#pragma once
/// Exact rational numbers: the one door to GMP. A double becomes one without rounding; sums, products and quotients are
/// exact; reading one back as a double cuts it off towards zero.

#include <gmpxx.h>

namespace lode::experiments::truth {

using Rational = mpq_class;

/// A double that is at most, or at least, the number, and within 2 ULP of it. |number| < 2^1000.
[[nodiscard]] double rounded_down(const Rational& number);
[[nodiscard]] double rounded_up(const Rational& number);

}  // namespace lode::experiments::truth
