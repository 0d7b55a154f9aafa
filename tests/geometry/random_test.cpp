#include "geometry/random.h"

#include <gtest/gtest.h>

#include <array>

namespace lode::geometry {
namespace {

TEST(Philox, GivesThePublishedAnswers) {  // the known answers published with Salmon et al.'s generators
  constexpr std::uint32_t f = 0xFFFFFFFFu;
  EXPECT_EQ(philox({0, 0, 0, 0}, {0, 0}), (RandomBlock{0x6627e8d5u, 0xe169c58du, 0xbc57ac4cu, 0x9b00dbd8u}));
  EXPECT_EQ(philox({f, f, f, f}, {f, f}), (RandomBlock{0x408f276du, 0x41c83b0eu, 0xa20bc7c6u, 0x6d5451fdu}));
  EXPECT_EQ(philox({0x243f6a88u, 0x85a308d3u, 0x13198a2eu, 0x03707344u}, {0xa4093822u, 0x299f31d0u}),
            (RandomBlock{0xd16cfe09u, 0x94fdccebu, 0x5001e420u, 0x24126ea1u}));
}

TEST(Random, StreamsDependOnSeedPurposeAndElementAlone) {
  Random a(7, 1, 5), b(7, 1, 5);
  for (int i = 0; i < 10; ++i) EXPECT_EQ(a.word(), b.word());
  const std::uint32_t first = Random(7, 1, 5).word();
  EXPECT_NE(Random(8, 1, 5).word(), first);
  EXPECT_NE(Random(7, 2, 5).word(), first);
  EXPECT_NE(Random(7, 1, 6).word(), first);
  EXPECT_NE(Random(7, 1, 5 + (std::uint64_t(1) << 32)).word(), first);
}

TEST(Random, BelowHitsEveryValueEquallyOften) {
  // 60000 draws of 6: each count is binomial with mean 10000 and σ = 91; within 5σ.
  std::array<int, 6> counts{};
  Random random(1, 2);
  for (int i = 0; i < 60000; ++i) ++counts[random.below(6)];
  for (const int n : counts) EXPECT_NEAR(n, 10000, 457);
}

TEST(Random, UniformStaysBelowOne) {
  Random random(1, 3);
  double low = 1.0, high = 0.0;
  for (int i = 0; i < 100000; ++i) {
    const double x = random.uniform();
    ASSERT_TRUE(x >= 0.0 && x < 1.0);
    low = x < low ? x : low;
    high = x > high ? x : high;
  }
  EXPECT_LT(low, 1e-3);
  EXPECT_GT(high, 0.999);
}

}  // namespace
}  // namespace lode::geometry
