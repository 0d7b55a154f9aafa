#include "raster/blend.h"

#include <gtest/gtest.h>

#include <bit>
#include <cmath>
#include <limits>

#include "blend_oracle.h"

namespace lode::raster {
namespace {

constexpr float kNan = std::numeric_limits<float>::quiet_NaN();
constexpr float kInf = std::numeric_limits<float>::infinity();

TEST(Blend8, OverEqualsTheRationalResultForEveryDestinationAndAlpha) {
  for (const int s : {0, 1, 2, 127, 128, 254, 255}) EXPECT_EQ(test::wrong_blends(Blend::over, s), 0) << "source " << s;
}

TEST(Blend8, AddEqualsTheSaturatedSumForEveryDestinationAndAlpha) {
  for (const int s : {0, 1, 2, 127, 128, 254, 255}) EXPECT_EQ(test::wrong_blends(Blend::add, s), 0) << "source " << s;
}

TEST(Blend8, NoneKeepsTheSource) {
  EXPECT_EQ(blend_rgba8(Blend::none, {1, 2, 3, 4}, {200, 201, 202, 203}), glm::u8vec4(1, 2, 3, 4));
}

TEST(Blend8, AlphaIsBlendedAsTheColoursAre) {
  // 128 + ⌊100·127/255 + ½⌋ = 128 + ⌊50.30…⌋; the same formula in every channel.
  EXPECT_EQ(blend_rgba8(Blend::over, {0, 0, 0, 128}, {100, 100, 100, 100}), glm::u8vec4(50, 50, 50, 178));
}

TEST(Blend32, OverIsSourcePlusDestinationTimesOneMinusAlpha) {
  const glm::vec4 s{0.1f, 0.2f, 0.3f, 0.7f};
  const glm::vec4 d{0.9f, 0.8f, 5.0f, 0.6f};
  const float kept = 1.0f - 0.7f;
  EXPECT_EQ(blend_rgba32f(Blend::over, s, d),
            glm::vec4(0.1f + 0.9f * kept, 0.2f + 0.8f * kept, 0.3f + 5.0f * kept, 0.7f + 0.6f * kept));
  EXPECT_EQ(blend_rgba32f(Blend::add, s, d), glm::vec4(0.1f + 0.9f, 0.2f + 0.8f, 0.3f + 5.0f, 0.7f + 0.6f));
  EXPECT_EQ(blend_rgba32f(Blend::none, s, d), s);
}

TEST(Blend32, EveryEquationStoresOneNanAndOneZero) {
  const float negative_nan = std::bit_cast<float>(0xFFC12345u);
  for (const Blend blend : {Blend::none, Blend::over, Blend::add}) {
    const glm::vec4 result = blend_rgba32f(blend, {negative_nan, -0.0f, kInf, 0.0f}, {1.0f, -0.0f, 1.0f, 0.0f});
    EXPECT_EQ(std::bit_cast<std::uint32_t>(result.r), 0x7FC00000u);
    EXPECT_EQ(std::bit_cast<std::uint32_t>(result.g), 0u);
    EXPECT_EQ(result.b, kInf);
    EXPECT_EQ(std::bit_cast<std::uint32_t>(result.a), 0u);
  }
  // Inf · 0 is a NaN of its own, negative on x86.
  const glm::vec4 made = blend_rgba32f(Blend::over, {0.0f, 0.0f, 0.0f, 1.0f}, {kInf, -kInf, 0.0f, 0.0f});
  EXPECT_EQ(std::bit_cast<std::uint32_t>(made.r), 0x7FC00000u);
  EXPECT_EQ(std::bit_cast<std::uint32_t>(made.g), 0x7FC00000u);
}

TEST(StoreRgba8, RoundsHalfUpForEveryCodeAndItsNeighbours) {
  for (int code = 0; code < 255; ++code) {
    const float tie = static_cast<float>(code) + 0.5f;
    EXPECT_EQ(int{store_rgba8(glm::vec4(static_cast<float>(code))).r}, code);
    EXPECT_EQ(int{store_rgba8(glm::vec4(std::nextafter(tie, 0.0f))).g}, code);
    EXPECT_EQ(int{store_rgba8(glm::vec4(tie)).b}, code + 1);
    EXPECT_EQ(int{store_rgba8(glm::vec4(std::nextafter(tie, 256.0f))).a}, code + 1);
  }
}

TEST(StoreRgba8, ClampsAndReadsNanAsZero) {
  EXPECT_EQ(store_rgba8({-1.0f, kNan, 300.0f, kInf}), glm::u8vec4(0, 0, 255, 255));
  EXPECT_EQ(store_rgba8({-kInf, 1e-40f, 255.0f, 3e38f}), glm::u8vec4(0, 0, 255, 255));
}

TEST(StoreRgba32f, KeepsEveryOtherBit) {
  const float denormal = std::bit_cast<float>(1u);
  EXPECT_EQ(store_rgba32f({denormal, -denormal, -kInf, 3e38f}), glm::vec4(denormal, -denormal, -kInf, 3e38f));
}

}  // namespace
}  // namespace lode::raster
