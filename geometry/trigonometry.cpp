#include "geometry/trigonometry.h"

#include <cmath>
#include <initializer_list>
#include <limits>

namespace lode::geometry {
namespace {

/// x = quarter·π/2 + high + low, |high| ≤ π/4 (a little more by rounding), |low| ≤ ulp(high).
struct Reduced {
  int quarter;
  double high;
  double low;
};

/// Cody & Waite's reduction: π/2 in parts of 32 bits, so that n (at most 21 bits here) times a part is exact.
Reduced reduce(double x) {
  constexpr double kTwoOverPi = 0x1.45f306dc9c883p-1;
  constexpr double kPart[] = {0x1.921fb544p+0, 0x1.0b4611a6p-34, 0x1.3198a2e0p-69, 0x1.b839a252049c1p-104};
  const double n = std::rint(x * kTwoOverPi);
  double high = x - n * kPart[0];  // exact: Sterbenz, or n = 0
  double low = 0.0;
  for (int k = 1; k < 4; ++k) {  // high + low −= n·part, with the rounding error kept (Knuth's two-sum)
    const double term = -(n * kPart[k]);
    const double sum = high + term;
    const double from_term = sum - high;
    low += (high - (sum - from_term)) + (term - from_term);
    high = sum;
  }
  const double sum = high + low;
  return {int(std::fmod(n, 4.0)) & 3, sum, low - (sum - high)};
}

/// sin(x + low) for |x| ≤ π/4: x + (x³·(−1/3! + x²/5! − …) + low·cos x), the small part first.
double sin_near_zero(double x, double low) {
  const double z = x * x;
  double sum = 0.0;
  for (const double divisor : {272.0, 210.0, 156.0, 110.0, 72.0, 42.0, 20.0}) sum = (1.0 - sum) * (z / divisor);
  return x + (x * ((sum - 1.0) * (z / 6.0)) + low * (1.0 - 0.5 * z));
}

/// cos(x + low): 1 − x²/2 with its rounding error, + (x⁴/4! − x⁶/6! + …) − low·sin x.
double cos_near_zero(double x, double low) {
  const double z = x * x;
  double sum = 0.0;
  for (const double divisor : {306.0, 240.0, 182.0, 132.0, 90.0, 56.0, 30.0}) sum = (1.0 - sum) * (z / divisor);
  const double half = 0.5 * z;
  const double head = 1.0 - half;
  return head + (((1.0 - head) - half) + (half * ((1.0 - sum) * (z / 12.0)) - x * low));
}

}  // namespace

SinCos sin_cos(double x_rad) {
  if (!(std::fabs(x_rad) <= 0x1p20)) {
    const double nan = std::numeric_limits<double>::quiet_NaN();
    return {nan, nan};
  }
  const Reduced r = reduce(x_rad);
  const double s = sin_near_zero(r.high, r.low);
  const double c = cos_near_zero(r.high, r.low);
  switch (r.quarter) {
    case 0:
      return {s, c};
    case 1:
      return {c, -s};
    case 2:
      return {-s, -c};
    default:
      return {-c, s};
  }
}

double tangent(double x_rad) {
  const SinCos t = sin_cos(x_rad);
  return t.sin / t.cos;
}

}  // namespace lode::geometry
