#include "raster/srgb.h"

#include <gtest/gtest.h>

#include <bit>
#include <cmath>
#include <limits>

#include "srgb_oracle.h"

namespace lode::raster {
namespace {

constexpr float kNan = std::numeric_limits<float>::quiet_NaN();
constexpr float kInf = std::numeric_limits<float>::infinity();

TEST(SrgbDecode, EveryCodeIsTheNearestFloat) {
  test::SrgbOracle oracle;
  for (int code = 0; code < 256; ++code) {
    EXPECT_EQ(srgb_decode(static_cast<std::uint8_t>(code)), oracle.decode(code)) << "code " << code;
  }
}

// srgb_encode counts thresholds, so it ascends; the exact code ascends, too. Two ascending functions that step at
// the same floats are equal everywhere: agreement on both sides of all 255 steps proves every float of [0, 1].
TEST(SrgbEncode, StepsAtTheFloatWhereTheExactCodeSteps) {
  const std::array<float, 256> threshold = test::SrgbOracle().thresholds();
  for (int k = 1; k < 256; ++k) {
    EXPECT_EQ(int{srgb_encode(threshold[std::size_t(k)])}, k);
    EXPECT_EQ(int{srgb_encode(std::nextafter(threshold[std::size_t(k)], 0.0f))}, k - 1);
  }
}

TEST(SrgbEncode, NeverDescends) {
  int previous = 0;
  for (std::uint32_t bits = 0; bits <= 0x3F800000u; bits += 997) {
    const int code = srgb_encode(std::bit_cast<float>(bits));
    ASSERT_GE(code, previous) << "at " << std::bit_cast<float>(bits);
    previous = code;
  }
}

TEST(SrgbEncode, UndoesDecode) {
  for (int code = 0; code < 256; ++code) {
    EXPECT_EQ(int{srgb_encode(srgb_decode(static_cast<std::uint8_t>(code)))}, code);
  }
}

TEST(SrgbEncode, OutsideOfItsRangeIsTheNearerEndAndNanIsZero) {
  EXPECT_EQ(int{srgb_encode(-1.0f)}, 0);
  EXPECT_EQ(int{srgb_encode(-kInf)}, 0);
  EXPECT_EQ(int{srgb_encode(-0.0f)}, 0);
  EXPECT_EQ(int{srgb_encode(kNan)}, 0);
  EXPECT_EQ(int{srgb_encode(1.0f)}, 255);
  EXPECT_EQ(int{srgb_encode(7.0f)}, 255);
  EXPECT_EQ(int{srgb_encode(kInf)}, 255);
}

TEST(Srgb8FromLinear, DividesColourByAlphaAndEncodesColourOnly) {
  // Half of full white, half covered, is straight white: 255; alpha ⌊127.5 + ½⌋ = 128, not encoded.
  EXPECT_EQ(srgb8_from_linear({0.5f, 0.25f, 0.0f, 0.5f}), glm::u8vec4(255, srgb_encode(0.5f), 0, 128));
  EXPECT_EQ(srgb8_from_linear({1.0f, 0.5f, 0.25f, 1.0f}), glm::u8vec4(255, srgb_encode(0.5f), srgb_encode(0.25f), 255));
}

TEST(Srgb8FromLinear, AlphaRoundsHalfUp) {
  const float below = std::nextafter(0.5f, 0.0f);  // 255·below = 127.49…
  EXPECT_EQ(int{srgb8_from_linear({0.0f, 0.0f, 0.0f, below}).a}, 127);
  EXPECT_EQ(int{srgb8_from_linear({0.0f, 0.0f, 0.0f, 0.5f}).a}, 128);
  EXPECT_EQ(int{srgb8_from_linear({0.0f, 0.0f, 0.0f, std::nextafter(1.0f, 0.0f)}).a}, 255);
}

TEST(Srgb8FromLinear, WithoutAlphaThereIsNoColour) {
  const glm::u8vec4 nothing(0, 0, 0, 0);
  EXPECT_EQ(srgb8_from_linear({1.0f, 1.0f, 1.0f, 0.0f}), nothing);
  EXPECT_EQ(srgb8_from_linear({1.0f, 1.0f, 1.0f, -0.5f}), nothing);
  EXPECT_EQ(srgb8_from_linear({1.0f, 1.0f, 1.0f, kNan}), nothing);
  EXPECT_EQ(srgb8_from_linear({kNan, -1.0f, kInf, 2.0f}), glm::u8vec4(0, 0, 255, 255));
  EXPECT_EQ(srgb8_from_linear({1.0f, 1.0f, kInf, kInf}), glm::u8vec4(0, 0, 0, 255));
}

}  // namespace
}  // namespace lode::raster
