#include "raster/texture_address.h"

#include <gtest/gtest.h>

#include <limits>

#include "texture_cases.h"
#include "texture_oracle.h"

namespace lode::raster {
namespace {

using test::Int128;

/// The pair as the oracle has it; the second texel counts only if it has a weight.
template <class Integer>
void expect_exact_pair(double u, int size_px, Wrap wrap) {
  const auto expected = test::tent<Integer>(u, size_px, wrap);
  const TexelPair found = linear_texels(u, size_px, wrap);
  ASSERT_EQ(found.first, expected[0].texel) << u << " size " << size_px << " wrap " << static_cast<int>(wrap);
  if (expected.size() == 2) {
    ASSERT_EQ(found.second, expected[1].texel) << u << " size " << size_px;
  }
  if (found.first != found.second) {  // of one texel, or of two of the border, only the sum of the weights counts
    ASSERT_EQ(256 - found.second_weight_fx8, expected[0].weight) << u << " size " << size_px;
  }
  const auto index = test::texel_index<Integer>(u, size_px, wrap);
  const Wrap edge = wrap == Wrap::mirror ? Wrap::clamp : wrap;  // the oracle's index is mirrored already
  ASSERT_EQ(nearest_texel(u, size_px, wrap), test::texel_in_row(index, size_px, edge)) << u << " size " << size_px;
}

template <class Integer>
void expect_exact_pairs(std::uint64_t seed, int n) {
  test::HashedNumbers random(seed);
  for (int i = 0; i < n && !testing::Test::HasFatalFailure(); ++i) {
    const int size_px = i % 16 == 0 ? random.between(1, 16384) : random.between(1, 40);
    const double u = test::random_coordinate(random, size_px);
    expect_exact_pair<Integer>(u, size_px, test::kWraps[random.below(4)]);
  }
}

TEST(TextureAddress, EqualsTheRationalOracleUpToTwoToTheTwenty) { expect_exact_pairs<Int128>(1, 200'000); }

TEST(TextureAddress, EqualsTheGmpOracleUpToTwoToTheTwenty) { expect_exact_pairs<mpz_class>(2, 20'000); }

TEST(TextureAddress, EqualsTheGmpOracleAtTheBoundsOfTheRange) {
  for (const double u : {0.0,      -0.0,    1.0,      -1.0,          0.5,           -0.5,           2.0,
                         3.0,      -2.0,    0x1p20,   -0x1p20,       0x1p-1074,     -0x1p-1074,     -1e-20,
                         -0x1p-54, 0x1p-54, -0x1p-53, 1.0 - 0x1p-53, 1.0 + 0x1p-52, -1.0 + 0x1p-53, 0x1p20 - 0x1p-33}) {
    for (const int size_px : {1, 2, 3, 7, 255, 256, 16383, 16384}) {
      for (const Wrap wrap : test::kWraps) expect_exact_pair<mpz_class>(u, size_px, wrap);
    }
  }
}

TEST(TextureAddress, EveryFiniteCoordinateIsExact) {
  for (const double u : {0x1p53 + 1.0, -0x1p52 - 0.5, 1e300, -1e300, std::numeric_limits<double>::max()}) {
    for (const int size_px : {1, 3, 16384}) {
      for (const Wrap wrap : test::kWraps) expect_exact_pair<mpz_class>(u, size_px, wrap);
    }
  }
}

TEST(TextureAddress, ACoordinateThatIsNotFiniteReadsAsZero) {
  const double inf = std::numeric_limits<double>::infinity();
  for (const double u : {inf, -inf, std::numeric_limits<double>::quiet_NaN()}) {
    for (const Wrap wrap : test::kWraps) {
      EXPECT_EQ(nearest_texel(u, 5, wrap), nearest_texel(0.0, 5, wrap));
      EXPECT_EQ(linear_texels(u, 5, wrap).first, linear_texels(0.0, 5, wrap).first);
      EXPECT_EQ(linear_texels(u, 5, wrap).second, linear_texels(0.0, 5, wrap).second);
      EXPECT_EQ(linear_texels(u, 5, wrap).second_weight_fx8, 128);
    }
  }
}

// 1/3 rounded down, times 3, rounds up to 1 in double: but the sample is left of the bound at 1/3.
TEST(TextureAddress, NearestReadsTheTexelThatContainsTheSample) {
  ASSERT_EQ((1.0 / 3.0) * 3.0, 1.0);
  EXPECT_EQ(nearest_texel(1.0 / 3.0, 3, Wrap::repeat), 0);
  EXPECT_EQ(nearest_texel(std::nextafter(1.0 / 3.0, 1.0), 3, Wrap::repeat), 1);
  EXPECT_EQ(nearest_texel(-1e-20, 3, Wrap::repeat), 2);
  EXPECT_EQ(nearest_texel(-1e-20, 3, Wrap::border), kBorderTexel);
  EXPECT_EQ(nearest_texel(1.0, 3, Wrap::border), kBorderTexel);
  EXPECT_EQ(nearest_texel(1.0, 3, Wrap::clamp), 2);
}

TEST(TextureAddress, AMirroredCoordinateGivesMirroredWeights) {
  for (int k = 0; k <= 4096; ++k) {
    const double u = k / 4096.0;  // of 8 texels: 2048 steps of 1/256, so every other one is a tie
    const TexelPair there = linear_texels(u, 8, Wrap::mirror);
    const TexelPair back = linear_texels(2.0 - u, 8, Wrap::mirror);
    const TexelPair negative = linear_texels(-u, 8, Wrap::mirror);
    ASSERT_EQ(there.first, back.first) << k;
    ASSERT_EQ(there.second_weight_fx8, back.second_weight_fx8) << k;
    ASSERT_EQ(there.first, negative.first) << k;
    ASSERT_EQ(there.second_weight_fx8, negative.second_weight_fx8) << k;
  }
}

// A repeated picture flipped left to right: coordinate −u reads what u read, in the other order.
TEST(TextureAddress, ANegatedCoordinateReadsTheFlippedPicture) {
  for (int k = 1; k < 4096; ++k) {
    const double u = k / 4096.0;  // ties, as above
    const TexelPair right = linear_texels(u, 8, Wrap::repeat);
    const TexelPair left = linear_texels(-u, 8, Wrap::repeat);
    if (right.second_weight_fx8 == 0) {
      ASSERT_EQ(left.first, 7 - right.first) << k;
      ASSERT_EQ(left.second_weight_fx8, 0) << k;
    } else {
      ASSERT_EQ(left.first, 7 - right.second) << k;
      ASSERT_EQ(left.second_weight_fx8, 256 - right.second_weight_fx8) << k;
    }
  }
}

}  // namespace
}  // namespace lode::raster
