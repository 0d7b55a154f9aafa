/// Sine and cosine against MPFR.

#include "geometry/trigonometry.h"

#include <gtest/gtest.h>
#include <mpfr.h>

#include <cmath>
#include <limits>

#include "geometry/random.h"

namespace lode::geometry {
namespace {

/// |computed − exact| in units in the last place of the exact value.
class Oracle {
 public:
  Oracle() { mpfr_inits2(200, x_, exact_, static_cast<mpfr_ptr>(nullptr)); }
  ~Oracle() { mpfr_clears(x_, exact_, static_cast<mpfr_ptr>(nullptr)); }

  double ulps(int (*function)(mpfr_t, const mpfr_t, mpfr_rnd_t), double x, double computed) {
    mpfr_set_d(x_, x, MPFR_RNDN);
    function(exact_, x_, MPFR_RNDN);
    const double rounded = std::fabs(mpfr_get_d(exact_, MPFR_RNDN));
    mpfr_sub_d(exact_, exact_, computed, MPFR_RNDN);
    const double difference = std::fabs(mpfr_get_d(exact_, MPFR_RNDN));
    const double ulp = std::nextafter(rounded, HUGE_VAL) - rounded;
    return difference / ulp;
  }

 private:
  mpfr_t x_, exact_;
};

TEST(Trigonometry, SineAndCosineAreWithinOneUlpAndTheTangentWithinTwoAndAHalf) {
  Oracle oracle;
  double worst_sin = 0.0, worst_cos = 0.0, worst_tan = 0.0;
  const auto look = [&](double x) {
    const SinCos t = sin_cos(x);
    worst_sin = std::fmax(worst_sin, oracle.ulps(mpfr_sin, x, t.sin));
    worst_cos = std::fmax(worst_cos, oracle.ulps(mpfr_cos, x, t.cos));
    worst_tan = std::fmax(worst_tan, oracle.ulps(mpfr_tan, x, tangent(x)));
  };
  for (std::uint64_t i = 0; i < 20000; ++i) {
    Random random(1, 3, i);
    const double sign = i % 2 ? 1.0 : -1.0;
    look(sign * random.uniform(0.0, 7.0));
    look(sign * random.uniform(0.0, 0x1p20));
    look(sign * std::ldexp(random.uniform(1.0, 2.0), -int(random.below(300))));
    // The doubles nearest to multiples of π/2, where the result is all rounding.
    look(sign * double(random.below(667000)) * (kPi / 2));
  }
  EXPECT_LE(worst_sin, 1.0);
  EXPECT_LE(worst_cos, 1.0);
  EXPECT_LE(worst_tan, 2.5);
}

TEST(Trigonometry, IsExactWhereItShouldBe) {
  EXPECT_EQ(sin_cos(0.0).sin, 0.0);
  EXPECT_EQ(sin_cos(0.0).cos, 1.0);
  EXPECT_EQ(sin_cos(kPi / 2).sin, 1.0);
  EXPECT_EQ(sin_cos(kPi).cos, -1.0);
}

TEST(Trigonometry, OutOfRangeIsNotANumber) {
  for (const double x : {0x1.0000001p20, -1e300, HUGE_VAL, std::numeric_limits<double>::quiet_NaN()}) {
    EXPECT_TRUE(std::isnan(sin_cos(x).sin) && std::isnan(sin_cos(x).cos)) << x;
  }
}

}  // namespace
}  // namespace lode::geometry
