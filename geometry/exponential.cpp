#include "geometry/exponential.h"

#include <array>
#include <cmath>
#include <cstddef>
#include <limits>

namespace lode::geometry {
namespace {

constexpr double kLn2 = 0x1.62e42fefa39efp-1;
constexpr double kInverseLn2 = 0x1.71547652b82fep+0;
constexpr double kSqrtHalf = 0x1.6a09e667f3bcdp-1;

/// 1/k.
constexpr auto kReciprocal = [] {
  std::array<double, 26> reciprocal{};
  for (std::size_t k = 1; k < reciprocal.size(); ++k) reciprocal[k] = 1.0 / double(k);
  return reciprocal;
}();

}  // namespace

double log2_of(double x) {
  if (x == 0.0) return -std::numeric_limits<double>::infinity();
  if (!(x > 0.0)) return std::numeric_limits<double>::quiet_NaN();
  if (std::isinf(x)) return x;
  int exponent = 0;
  double m = std::frexp(x, &exponent);
  if (m < kSqrtHalf) {
    m *= 2.0;
    exponent -= 1;
  }
  // ln m = 2 artanh s = 2s (1 + z/3 + z²/5 + …), z = s² ≤ 0.0295: thirteen terms reach 2^-53.
  const double s = (m - 1.0) / (m + 1.0), z = s * s;
  double sum = 0.0;
  for (std::size_t k = 25; k >= 3; k -= 2) sum = (sum + kReciprocal[k]) * z;
  return exponent + (2.0 * s * (1.0 + sum)) * kInverseLn2;
}

double exp2_of(double x) {
  if (std::isnan(x)) return x;
  if (x > 1100.0) return std::numeric_limits<double>::infinity();
  if (x < -1100.0) return 0.0;
  const double n = std::rint(x), t = (x - n) * kLn2;  // |t| ≤ 0.347
  double sum = 0.0;
  for (std::size_t k = 15; k >= 1; --k) sum = (1.0 + sum) * (t * kReciprocal[k]);
  return std::ldexp(1.0 + sum, int(n));
}

double power(double x, double y) {
  if (std::isnan(x) || std::isnan(y) || x < 0.0) return std::numeric_limits<double>::quiet_NaN();
  if (y == 0.0 || x == 1.0) return 1.0;
  return exp2_of(y * log2_of(x));
}

}  // namespace lode::geometry
