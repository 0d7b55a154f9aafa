#pragma once
/// Logarithms and powers with the same bits everywhere: the C library's differ from machine to machine. Only + − × ÷,
/// rint and the exact frexp and ldexp are used. Tests hold them against MPFR.

namespace lode::geometry {

/// Within 2 ULP of log₂ x, or 2^-52 near x = 1. 0 gives −∞, infinity itself, a negative number or a NaN gives NaN.
[[nodiscard]] double log2_of(double x);

/// 2^x within 2 ULP; beyond the range of doubles 0 or infinity (below 2^-1022 within 2 units of 2^-1074), NaN for NaN.
[[nodiscard]] double exp2_of(double x);

/// x^y, x ≥ 0, as exp2_of(y · log2_of(x)): a relative error of at most 2^-50 (1 + |y log₂ x|). x^0 is 1, also of 0;
/// 0^y is 0 for y > 0 and infinity for y < 0; NaN for x < 0 and for any NaN.
[[nodiscard]] double power(double x, double y);

}  // namespace lode::geometry
