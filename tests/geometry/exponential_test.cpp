/// Logarithms and powers against MPFR.

#include "geometry/exponential.h"

#include <gtest/gtest.h>
#include <mpfr.h>

#include <cmath>
#include <limits>

#include "geometry/random.h"

namespace lode::geometry {
namespace {

constexpr double kInfinity = std::numeric_limits<double>::infinity();

/// Numbers of 200 bits.
class Exponential : public testing::Test {
 protected:
  Exponential() { mpfr_inits2(200, x_, y_, exact_, static_cast<mpfr_ptr>(nullptr)); }
  ~Exponential() override { mpfr_clears(x_, y_, exact_, static_cast<mpfr_ptr>(nullptr)); }

  void set(double x, double y = 0.0) {
    mpfr_set_d(x_, x, MPFR_RNDN);
    mpfr_set_d(y_, y, MPFR_RNDN);
  }
  /// |computed − exact|.
  double error(double computed) {
    mpfr_sub_d(y_, exact_, computed, MPFR_RNDN);
    return std::fabs(mpfr_get_d(y_, MPFR_RNDN));
  }
  double exact() { return std::fabs(mpfr_get_d(exact_, MPFR_RNDN)); }

  mpfr_t x_, y_, exact_;
};

TEST_F(Exponential, LogarithmsAreWithinTwoUlp) {
  for (std::uint64_t i = 0; i < 4000; ++i) {
    Random random(1, 5, i);
    const double x =
        std::ldexp(random.uniform(0.5, 1.0), i % 2 == 0 ? int(random.below(2)) : int(random.below(2000)) - 1000);
    set(x);
    mpfr_log2(exact_, x_, MPFR_RNDN);
    EXPECT_LE(error(log2_of(x)), std::fmax(2.0 * exact() * 0x1p-52, 0x1p-52)) << x;
  }
}

TEST_F(Exponential, PowersOfTwoAreWithinTwoUlp) {
  for (std::uint64_t i = 0; i < 4000; ++i) {
    const double x = Random(1, 6, i).uniform(-1021.0, 1023.0);
    set(x);
    mpfr_exp2(exact_, x_, MPFR_RNDN);
    EXPECT_LE(error(exp2_of(x)), 2.0 * exact() * 0x1p-52) << x;
  }
}

TEST_F(Exponential, PowersHaveTheErrorThatTheyPromise) {
  for (std::uint64_t i = 0; i < 4000; ++i) {
    Random random(1, 7, i);
    const double x = i % 2 == 0 ? random.uniform(0.0, 1.0) : random.uniform(0.0, 1e6), y = random.uniform(-10.0, 10.0);
    set(x, y);
    mpfr_pow(exact_, x_, y_, MPFR_RNDN);
    EXPECT_LE(error(power(x, y)), 0x1p-50 * exact() * (1.0 + std::fabs(y * std::log2(x)))) << x << " ^ " << y;
  }
}

TEST_F(Exponential, WholeNumbersAreExact) {
  for (int n = -1074; n <= 1023; ++n) {
    EXPECT_EQ(exp2_of(n), std::ldexp(1.0, n));
    EXPECT_EQ(log2_of(std::ldexp(1.0, n)), n);
  }
}

TEST_F(Exponential, EveryInputHasADefinedResult) {
  EXPECT_EQ(log2_of(0.0), -kInfinity);
  EXPECT_EQ(log2_of(kInfinity), kInfinity);
  EXPECT_TRUE(std::isnan(log2_of(-1.0)));
  EXPECT_TRUE(std::isnan(log2_of(std::nan(""))));
  EXPECT_EQ(exp2_of(kInfinity), kInfinity);
  EXPECT_EQ(exp2_of(1024.0), kInfinity);
  EXPECT_EQ(exp2_of(-kInfinity), 0.0);
  EXPECT_TRUE(std::isnan(exp2_of(std::nan(""))));
  EXPECT_EQ(power(0.0, 0.0), 1.0);
  EXPECT_EQ(power(0.0, 0.7), 0.0);
  EXPECT_EQ(power(0.0, -1.0), kInfinity);
  EXPECT_EQ(power(1.0, kInfinity), 1.0);
  EXPECT_TRUE(std::isnan(power(-1.0, 2.0)));
}

}  // namespace
}  // namespace lode::geometry
