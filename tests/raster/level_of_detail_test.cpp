#include "raster/level_of_detail.h"

#include <gtest/gtest.h>

#include <bit>
#include <cmath>
#include <limits>

#include "texture_cases.h"
#include "texture_filter_oracle.h"

namespace lode::raster {
namespace {

constexpr double kInf = std::numeric_limits<double>::infinity();
constexpr double kNan = std::numeric_limits<double>::quiet_NaN();

/// The smallest double m in [1, 2] with round(128 · log2(m)) ≥ step, by bisection with MPFR.
double first_at_step(int step) {
  std::uint64_t below = std::bit_cast<std::uint64_t>(1.0), at_least = std::bit_cast<std::uint64_t>(2.0);
  while (at_least - below > 1) {
    const std::uint64_t middle = below + (at_least - below) / 2;
    (test::exact_lambda_fx8(mpq_class(std::bit_cast<double>(middle))) >= step ? at_least : below) = middle;
  }
  return std::bit_cast<double>(at_least);
}

// lambda_fx8 counts thresholds, so it ascends, as the logarithm does: agreement on both sides of all 128 steps of an
// octave, and 128 more per octave, prove it for every double.
TEST(LevelOfDetail, StepsAtTheDoubleWhereTheExactRoundedLogarithmSteps) {
  for (int step = 1; step <= 128; ++step) {
    const double m = first_at_step(step);
    EXPECT_EQ(lambda_fx8(m), step);
    EXPECT_EQ(lambda_fx8(std::nextafter(m, 0.0)), step - 1);
    EXPECT_EQ(lambda_fx8(std::ldexp(m, 7)), step + 7 * 128);
    EXPECT_EQ(lambda_fx8(std::ldexp(std::nextafter(m, 0.0), -9)), step - 1 - 9 * 128);
  }
}

TEST(LevelOfDetail, EqualsMpfrForDoublesOfEveryMagnitude) {
  test::HashedNumbers random(1);
  for (int i = 0; i < 10'000; ++i) {
    const double rho_squared = random.of_magnitude(-1022, 1023);
    ASSERT_EQ(lambda_fx8(rho_squared), test::exact_lambda_fx8(mpq_class(rho_squared))) << rho_squared;
  }
}

TEST(LevelOfDetail, NoLengthIsTheLeastAndInfiniteLengthTheMost) {
  for (const double least : {0.0, -0.0, -1.0, -kInf, kNan, 0x1p-1074}) EXPECT_EQ(lambda_fx8(least), kMinLambda_fx8);
  EXPECT_EQ(lambda_fx8(kInf), kMaxLambda_fx8);
  EXPECT_LT(kMinLambda_fx8, lambda_fx8(std::numeric_limits<double>::min()));
  EXPECT_GE(kMaxLambda_fx8, lambda_fx8(std::numeric_limits<double>::max()));
  EXPECT_EQ(lambda_fx8(kFirstLevelAlone), 0);
}

TEST(LevelOfDetail, LevelsAreClampedToThoseThatExist) {
  const auto is = [](LevelPair pair, int level, int f) { return pair.level == level && pair.second_weight_fx8 == f; };
  EXPECT_TRUE(is(mip_levels(-1, 5), 0, 0));
  EXPECT_TRUE(is(mip_levels(kMinLambda_fx8, 5), 0, 0));
  EXPECT_TRUE(is(mip_levels(1, 5), 0, 1));
  EXPECT_TRUE(is(mip_levels(3 * 256 + 255, 5), 3, 255));
  EXPECT_TRUE(is(mip_levels(4 * 256, 5), 4, 0));
  EXPECT_TRUE(is(mip_levels(4 * 256 + 1, 5), 4, 0));
  EXPECT_TRUE(is(mip_levels(kMaxLambda_fx8, 5), 4, 0));
  EXPECT_TRUE(is(mip_levels(700, 1), 0, 0));
}

// 8 × 4 texels. ∂x = (6, 0) texels, ∂y = (0, 2): λ = log2 6 for one probe, ⌈6/2⌉ = 3 probes at log2(6/3) = 1.
TEST(LevelOfDetail, LengthsAreInTexelsOfLevelZero) {
  const Footprint footprint{.uv = {0.0, 0.0}, .duv_dx = {6.0 / 8.0, 0.0}, .duv_dy = {0.0, 2.0 / 4.0}};
  EXPECT_EQ(isotropic_probe(footprint, {8, 4}).lambda_fx8, test::exact_lambda_fx8(36));
  const Probes probes = anisotropic_probes(footprint, {8, 4}, 8);
  EXPECT_EQ(probes.n, 3);
  EXPECT_EQ(probes.lambda_fx8, 256);
  EXPECT_EQ(probes.major_duv, footprint.duv_dx);
}

TEST(LevelOfDetail, ALengthIsThatOfBothComponents) {  // 3 and 4 texels: 5
  const Footprint footprint{.uv = {0.0, 0.0}, .duv_dx = {3.0 / 16.0, 4.0 / 64.0}, .duv_dy = {0.0, 0.0}};
  EXPECT_EQ(isotropic_probe(footprint, {16, 64}).lambda_fx8, test::exact_lambda_fx8(25));
}

TEST(AnisotropicProbes, ThereAreAsManyAsTheRatioRoundedUpNeedsUpToTheMaximum) {
  const auto n_probes = [](double x, double y, int most) {
    return anisotropic_probes({.uv = {}, .duv_dx = {x, 0.0}, .duv_dy = {0.0, y}}, {1, 1}, most).n;
  };
  EXPECT_EQ(n_probes(1.0, 1.0, 16), 1);
  EXPECT_EQ(n_probes(3.0, 1.0, 16), 3);
  EXPECT_EQ(n_probes(std::nextafter(3.0, 4.0), 1.0, 16), 4);
  EXPECT_EQ(n_probes(1.0, 7.5, 16), 8);
  EXPECT_EQ(n_probes(1.0, 7.5, 5), 5);
  EXPECT_EQ(n_probes(1.0, 0.0, 6), 6);
  EXPECT_EQ(n_probes(0.0, 0.0, 6), 1);
  EXPECT_EQ(n_probes(1.0, 100.0, 1000), 16);
  EXPECT_EQ(n_probes(1.0, 100.0, -3), 1);
  EXPECT_EQ(n_probes(kInf, 1.0, 4), 4);
  EXPECT_EQ(n_probes(kInf, kInf, 4), 1);
  EXPECT_EQ(n_probes(kNan, 1.0, 4), 4);  // NaN counts as no length
  EXPECT_EQ(n_probes(kNan, kNan, 4), 1);
}

TEST(AnisotropicProbes, LieAlongTheLongerDerivativeAndOfEqualOnesAlongX) {
  const glm::dvec2 x{0.5, 0.25}, y{0.25, -0.5};
  EXPECT_EQ(anisotropic_probes({.uv = {}, .duv_dx = x, .duv_dy = 2.0 * y}, {4, 4}, 8).major_duv, 2.0 * y);
  EXPECT_EQ(anisotropic_probes({.uv = {}, .duv_dx = x, .duv_dy = y}, {4, 4}, 8).major_duv, x);
}

// i/(n+1) − ½: for n = 3 at −¼, 0 and ¼ of the major derivative.
TEST(AnisotropicProbes, StandAtEqualStepsAroundTheSample) {
  const Probes probes{.n = 3, .major_duv = {1.0, -2.0}, .lambda_fx8 = 0};
  EXPECT_EQ(probes.at({0.5, 0.5}, 1), glm::dvec2(0.25, 1.0));
  EXPECT_EQ(probes.at({0.5, 0.5}, 2), glm::dvec2(0.5, 0.5));
  EXPECT_EQ(probes.at({0.5, 0.5}, 3), glm::dvec2(0.75, 0.0));
}

TEST(AnisotropicProbes, EachIsWithinTwoRoundingsOfTheRationalPosition) {
  for (int n = 1; n <= 16; ++n) {
    const Probes probes{.n = n, .major_duv = {0.7, -1.3}, .lambda_fx8 = 0};
    for (int i = 1; i <= n; ++i) {
      const mpq_class along = mpq_class(i, n + 1) - mpq_class(1, 2);
      const glm::dvec2 at = probes.at({0.3, 0.9}, i);
      // |uv + along·major| < 2 and |along·major| < 1: half ulps of 2^-53, 2^-54 and 2^-54.
      EXPECT_LE(abs(mpq_class(at.x) - (mpq_class(0.3) + along * mpq_class(0.7))), mpq_class(0x1p-52)) << n << " " << i;
      EXPECT_LE(abs(mpq_class(at.y) - (mpq_class(0.9) + along * mpq_class(-1.3))), mpq_class(0x1p-52)) << n << " " << i;
    }
  }
}

TEST(AnisotropicProbes, OneProbeIsAtTheSampleEvenIfTheDerivativesAreInfinite) {
  const Probes probes = anisotropic_probes({.uv = {}, .duv_dx = {kInf, 0.0}, .duv_dy = {kInf, 0.0}}, {4, 4}, 8);
  EXPECT_EQ(probes.at({0.25, 0.75}, 1), glm::dvec2(0.25, 0.75));
}

}  // namespace
}  // namespace lode::raster
