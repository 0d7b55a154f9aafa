/// Metrics against values known in closed form or published with their definitions.

#include <gtest/gtest.h>

#include <functional>
#include <vector>

#include "experiments/metrics/pixel_difference.h"
#include "experiments/metrics/structural_similarity.h"

namespace lode::experiments {
namespace {

using Texels = std::vector<glm::u8vec4>;

/// A grey picture.
Texels grey(glm::ivec2 size_px, const std::function<int(int x, int y)>& value) {
  Texels texels;
  for (int y = 0; y < size_px.y; ++y) {
    for (int x = 0; x < size_px.x; ++x) texels.emplace_back(glm::u8vec3(glm::u8(value(x, y))), x & 255);
  }
  return texels;
}

int checker(int x, int y) { return (((x >> 3) ^ (y >> 3)) & 1) != 0 ? 255 : 0; }

struct Pictures {
  glm::ivec2 size_px;
  Texels a, b;
  [[nodiscard]] PicturePair pair() const { return {size_px, a, b}; }
};

Pictures shifted_checker() {
  const glm::ivec2 size(256, 256);
  return {size, grey(size, checker), grey(size, [](int x, int y) { return checker(x + 1, y); })};
}
Pictures constants(int a, int b) {
  const glm::ivec2 size(64, 48);
  return {size, grey(size, [a](int, int) { return a; }), grey(size, [b](int, int) { return b; })};
}

TEST(Metrics, OfEqualPicturesAreThoseOfNoDifference) {
  const Pictures p = constants(17, 17);
  const PixelDifference d = pixel_difference(p.pair());
  EXPECT_EQ(d.max, 0);
  EXPECT_EQ(d.differing, 0u);
  EXPECT_EQ(rmse(d), 0.0);
  EXPECT_FALSE(psnr(d).has_value());
  EXPECT_EQ(ssim(p.pair()), 1.0);
}

TEST(Metrics, CountPixelsAndNotChannelsAndLeaveAlphaOut) {
  Pictures p = constants(10, 10);
  p.b[5] = {10, 13, 6, 200};   // differs by 3 and 4
  p.b[9] = {10, 10, 10, 255};  // in alpha only
  const PixelDifference d = pixel_difference(p.pair());
  EXPECT_EQ(d.max, 4);
  EXPECT_EQ(d.differing, 1u);
  EXPECT_EQ(d.sum_squared, 25u);
  EXPECT_DOUBLE_EQ(rmse(d), std::sqrt(25.0 / (64 * 48 * 3)));
}

TEST(Metrics, ConstantsHaveTheirClosedForms) {
  // Squared difference 100: 10 log10(65025/100). SSIM: (2·100·110 + 2.55²)/(100² + 110² + 2.55²).
  const Pictures p = constants(100, 110);
  EXPECT_NEAR(*psnr(pixel_difference(p.pair())), 28.1308036, 5e-8);
  EXPECT_DOUBLE_EQ(rmse(pixel_difference(p.pair())), 10.0);
  EXPECT_NEAR(*ssim(p.pair()), 0.995476444, 5e-10);
}

TEST(Metrics, AShiftedCheckerHasItsPublishedValues) {
  const Pictures p = shifted_checker();
  EXPECT_NEAR(*psnr(pixel_difference(p.pair())), 9.03089987, 5e-9);
  EXPECT_NEAR(*ssim(p.pair()), 0.618704703, 5e-10);
  EXPECT_NEAR(*ms_ssim(p.pair()), 0.907074055, 5e-10);
}

TEST(Metrics, SmallPicturesHaveNoStructuralSimilarity) {
  const glm::ivec2 size(11, 10);
  const Pictures small = {size, grey(size, checker), grey(size, checker)};
  EXPECT_FALSE(ssim(small.pair()).has_value());
  EXPECT_TRUE(ssim(constants(1, 2).pair()).has_value());
  EXPECT_FALSE(ms_ssim(constants(1, 2).pair()).has_value());
}

TEST(Metrics, ChannelsAreAveraged) {
  // One of three channels differs: two have SSIM 1.
  Pictures p = constants(100, 100);
  for (glm::u8vec4& texel : p.b) texel.g = 110;
  EXPECT_NEAR(*ssim(p.pair()), (2.0 + 0.995476444) / 3.0, 5e-10);
}

}  // namespace
}  // namespace lode::experiments
