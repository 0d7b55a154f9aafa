#pragma once
/// Sine, cosine and tangent with the same bits everywhere: the C library's may differ from machine to machine, and what
/// they give reaches pixels. Only + − × ÷ are used. For |x| ≤ 2^20 the sine and the cosine are within 1 ULP of the
/// exact value, the tangent within 2.5 (tests hold them against MPFR).

namespace lode::geometry {

inline constexpr double kPi = 3.14159265358979323846;

struct SinCos {
  double sin;
  double cos;
};

/// Both at once. A NaN, an infinity or |x| > 2^20 gives NaN twice.
[[nodiscard]] SinCos sin_cos(double x_rad);
[[nodiscard]] double tangent(double x_rad);

}  // namespace lode::geometry
