/// HDR-FLIP against NVIDIA's FLIP 1.6 (its CPU code, run on the pictures below, its error maps summed in double).

#include "experiments/metrics/flip/hdr_flip.h"

#include <gtest/gtest.h>

#include <cmath>
#include <functional>
#include <limits>

namespace lode::experiments {
namespace {

/// The program's single precision.
constexpr double kMeanTolerance = 2e-5;

using Colors = std::function<glm::vec3(int x, int y)>;
using Texels = std::vector<glm::vec4>;

Texels painted(glm::ivec2 size_px, const Colors& color) {
  Texels texels;
  for (int y = 0; y < size_px.y; ++y) {
    for (int x = 0; x < size_px.x; ++x) texels.emplace_back(color(x, y), 1.0f);
  }
  return texels;
}

ErrorMap hdr_flip_of(glm::ivec2 size_px, const Colors& a, const Colors& b) {
  const Texels reference = painted(size_px, a), test = painted(size_px, b);
  return hdr_flip_map({size_px, reference, test}, {.threads = 2}).value();
}
double mean_of(glm::ivec2 size_px, const Colors& a, const Colors& b) {
  return mean_error(hdr_flip_of(size_px, a, b).errors);
}

Colors grey(float value) {
  return [value](int, int) { return glm::vec3(value); };
}
/// Twelve stops from left to right, another hue in each row.
glm::vec3 ramp(int x, int y) {
  const float v = std::ldexp(1.0f, x / 8 - 6);
  return {v, v * (0.25f + float(y) / 64.0f), v * (1.0f - float(y) / 64.0f)};
}
glm::vec3 checkered_ramp(int x, int y) {
  return (((x >> 2) ^ (y >> 2)) & 1) != 0 ? ramp(x, y) * glm::vec3(1.25f, 1.0f, 0.75f) : ramp(x, y);
}
std::uint32_t hash(std::uint32_t x) {
  x = (x ^ (x >> 16)) * 0x7feb352du;
  x = (x ^ (x >> 15)) * 0x846ca68bu;
  return x ^ (x >> 16);
}
/// Nine stops of noise, a value for each channel.
glm::vec3 noise(int x, int y) {
  glm::vec3 color;
  for (int c = 0; c < 3; ++c) {
    const std::uint32_t h = hash(std::uint32_t(x + 64 * y) * 3 + std::uint32_t(c));
    color[c] = std::ldexp(float(h & 255) / 256.0f, int((h >> 8) % 9) - 4);
  }
  return color;
}
glm::vec3 brighter_noise(int x, int y) { return noise(x, y) * (x >= 32 ? 1.0f + float(y) / 64.0f : 1.0f); }

TEST(HdrFlip, ConstantsHaveTheProgramsValues) {
  EXPECT_NEAR(mean_of({32, 32}, grey(0.25f), grey(0.5f)), 0.144833133, kMeanTolerance);
  EXPECT_NEAR(mean_of({32, 32}, grey(4.0f), grey(5.0f)), 0.076379821, kMeanTolerance);
}

TEST(HdrFlip, ARampAndNoiseHaveTheProgramsValues) {
  EXPECT_NEAR(mean_of({96, 48}, ramp, checkered_ramp), 0.152660247, kMeanTolerance);
  EXPECT_NEAR(mean_of({64, 64}, noise, brighter_noise), 0.123925392, kMeanTolerance);
}

TEST(HdrFlip, TheReferenceDecidesTheExposures) {
  const Colors spark = [](int x, int y) { return glm::vec3(x == 24 && y == 24 ? 1000.0f : 0.125f); };
  EXPECT_NEAR(mean_of({49, 49}, grey(0.125f), spark), 0.000290122, kMeanTolerance);
  EXPECT_NEAR(mean_of({49, 49}, spark, grey(0.125f)), 0.005938384, kMeanTolerance);
}

TEST(HdrFlip, ExposuresReachFromTheBrightestToTheMedian) {
  const Exposures constant = exposures_of(painted({4, 4}, grey(0.25f)));
  EXPECT_NEAR(constant.start, 3.083297, 1e-6);
  EXPECT_EQ(constant.stop, constant.start);
  EXPECT_EQ(constant.n, 2);
  const Exposures wide = exposures_of(painted({96, 48}, ramp));
  EXPECT_NEAR(wide.start, -3.820980, 1e-6);
  EXPECT_NEAR(wide.stop, 2.179020, 1e-6);
  EXPECT_EQ(wide.n, 6);
  EXPECT_EQ(wide.at(0), wide.start);
  EXPECT_DOUBLE_EQ(wide.at(5), wide.stop);
}

TEST(HdrFlip, BlackMediansAndBlackPicturesHaveExposures) {
  // Three of nine pixels have light, of 1, 1 and 2: their median is 1.
  Texels dark(9, glm::vec4(0.0f));
  dark[1] = dark[4] = glm::vec4(1.0f);
  dark[7] = glm::vec4(2.0f);
  EXPECT_DOUBLE_EQ(exposures_of(dark).stop - exposures_of(dark).start, 1.0);
  const Exposures black = exposures_of(Texels(9, glm::vec4(0.0f)));
  EXPECT_EQ(black.at(0), 0.0);
  EXPECT_EQ(black.at(1), 0.0);
  EXPECT_EQ(mean_of({3, 3}, grey(0.0f), grey(0.0f)), 0.0);
  EXPECT_GT(mean_of({3, 3}, grey(0.0f), grey(1.0f)), 0.5);
}

TEST(HdrFlip, ExtremesAreFinite) {
  const float huge = std::numeric_limits<float>::max(), tiny = std::numeric_limits<float>::denorm_min();
  for (const float error : hdr_flip_of({2, 1}, grey(huge), grey(-huge)).errors) EXPECT_LE(error, 1.0f);
  const Texels both = {glm::vec4(tiny), glm::vec4(huge), glm::vec4(tiny)};
  EXPECT_EQ(exposures_of(both).n, 277);  // 2^-149 to just below 2^128
  EXPECT_EQ(mean_error(hdr_flip_map({{3, 1}, both, both})->errors), 0.0);
}

TEST(HdrFlip, PicturesWithColorsThatAreNotFiniteHaveNone) {
  Texels a(4, glm::vec4(1.0f)), b = a;
  b[2].g = std::numeric_limits<float>::infinity();
  EXPECT_FALSE(hdr_flip_map({{2, 2}, a, b}).has_value());
  b[2].g = std::nanf("");
  EXPECT_FALSE(hdr_flip_map({{2, 2}, b, a}).has_value());
  b[2].g = 1.0f;
  b[2].a = std::nanf("");  // does not count
  EXPECT_TRUE(hdr_flip_map({{2, 2}, b, a}).has_value());
}

}  // namespace
}  // namespace lode::experiments
