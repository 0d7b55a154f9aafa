#include <gtest/gtest.h>

#include <bit>

#include "raster/srgb.h"
#include "srgb_oracle.h"
#include "stress_count.h"

namespace lode::raster {
namespace {

constexpr std::uint32_t kFloatsInUnitInterval = 0x3F800001u;  // 0, the denormals, …, 1: 1,065,353,217 of them

TEST(SrgbStress, EncodeEqualsMpfrForTheFloatsOfTheUnitInterval) {
  const std::uint64_t n = test::stress_count("floats in [0, 1]", kFloatsInUnitInterval / 7, kFloatsInUnitInterval);
  const std::uint32_t step = n == kFloatsInUnitInterval ? 1 : 7;
  const std::array<float, 256> threshold = test::SrgbOracle().thresholds();
  std::uint64_t wrong = 0;
  int expected = 0;
  for (std::uint32_t bits = 0; bits < kFloatsInUnitInterval; bits += step) {
    const float x = std::bit_cast<float>(bits);
    while (expected < 255 && x >= threshold[std::size_t(expected) + 1]) ++expected;
    wrong += srgb_encode(x) != expected;
  }
  EXPECT_EQ(wrong, 0u);
}

TEST(SrgbStress, EncodeEqualsMpfrDirectlyForSampledFloats) {
  const std::uint64_t n = test::stress_count("floats in [0, 1], each through MPFR", 300'000, 30'000'000);
  test::SrgbOracle oracle;
  const auto step = static_cast<std::uint32_t>(kFloatsInUnitInterval / n);
  std::uint64_t wrong = 0;
  for (std::uint32_t bits = 0; bits < kFloatsInUnitInterval; bits += step) {
    const float x = std::bit_cast<float>(bits);
    wrong += srgb_encode(x) != oracle.encode(x);
  }
  EXPECT_EQ(wrong, 0u);
}

}  // namespace
}  // namespace lode::raster
