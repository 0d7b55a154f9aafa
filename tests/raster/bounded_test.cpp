#include "raster/reference/bounded.h"

#include <gmpxx.h>
#include <gtest/gtest.h>

#include <cmath>

#include "tests/raster/counter_random.h"

namespace lode::tests {
namespace {

using namespace raster::reference;

/// A number with its exact value.
struct Pair {
  Bounded bounded;
  mpq_class exact;
};

bool encloses(const Pair& p) {
  if (!std::isfinite(p.bounded.value) || !std::isfinite(p.bounded.error)) return true;  // says nothing
  return abs(mpq_class(p.bounded.value) - p.exact) <= mpq_class(p.bounded.error);
}

/// Around 1, near overflow, near the least denormal, or 0.
Pair leaf(const CounterRandom& random, std::uint64_t purpose) {
  const int range = random.integer(purpose, 0, 9);
  const int exponent = range < 5    ? random.integer(purpose + 1, -3, 3)
                       : range == 5 ? random.integer(purpose + 1, 400, 1020)
                       : range < 9  ? random.integer(purpose + 1, -1074, -480)
                                    : -2000;
  const double x = std::ldexp(random.real(purpose + 2), exponent);
  return {{x, 0.0}, mpq_class(x)};
}

TEST(Bounded, EnclosesTheExactValueOfEveryExpression) {
  int informative = 0;
  for (std::uint64_t i = 0; i < 30000; ++i) {
    const CounterRandom random{41, i};
    Pair p = leaf(random, 0);
    for (std::uint64_t step = 1; step <= 4; ++step) {
      Pair q = leaf(random, 10 * step);
      if (random.integer(10 * step + 3, 0, 1) == 0) {  // a product as the other operand
        const Pair r = leaf(random, 10 * step + 4);
        q = {q.bounded * r.bounded, q.exact * r.exact};
      }
      switch (random.integer(10 * step + 8, 0, 2)) {
        case 0:
          p = {p.bounded + q.bounded, p.exact + q.exact};
          break;
        case 1:
          p = {p.bounded - q.bounded, p.exact - q.exact};
          break;
        default:
          p = {p.bounded * q.bounded, p.exact * q.exact};
      }
      ASSERT_TRUE(encloses(p)) << "case " << i << " step " << step;
    }
    informative += surely_positive(p.bounded) || surely_negative(p.bounded);
  }
  EXPECT_GT(informative, 15000);
}

TEST(Bounded, KeepsAnExactZero) {
  const Bounded zero, huge{1e300, 1e290};
  EXPECT_TRUE(is_zero(zero * huge));
  EXPECT_TRUE(is_zero(zero + zero));
  EXPECT_TRUE(surely_not_negative(zero));
  EXPECT_TRUE(surely_not_positive(zero));
  EXPECT_FALSE(surely_positive(zero));
}

TEST(Bounded, OverflowIsNeverCertain) {
  const Bounded huge{1e200, 0.0}, overflow = huge * huge, nan = overflow - overflow;
  for (const Bounded& a : {overflow, nan}) {
    EXPECT_FALSE(surely_positive(a) || surely_not_positive(a) || surely_negative(a));
  }
}

}  // namespace
}  // namespace lode::tests
