/// FLIP against NVIDIA's FLIP 1.6, its error maps summed in double.

#include "experiments/metrics/flip/flip.h"

#include <gtest/gtest.h>

#include <bit>
#include <cmath>
#include <functional>

#include "experiments/metrics/flip/filters.h"

namespace lode::experiments {
namespace {

/// The program computes in single precision: this much is its own noise.
constexpr double kMeanTolerance = 2e-5;

using Texels = std::vector<glm::u8vec4>;
using Colors = std::function<glm::u8vec3(int x, int y)>;

Texels painted(glm::ivec2 size_px, const Colors& color) {
  Texels texels;
  for (int y = 0; y < size_px.y; ++y) {
    for (int x = 0; x < size_px.x; ++x) texels.emplace_back(color(x, y), x & 255);
  }
  return texels;
}

ErrorMap flip_of(glm::ivec2 size_px, const Colors& a, const Colors& b, const FlipParams& params = {}) {
  const Texels reference = painted(size_px, a), test = painted(size_px, b);
  return flip_map({size_px, reference, test}, params);
}
double mean_of(glm::ivec2 size_px, const Colors& a, const Colors& b) {
  return mean_error(flip_of(size_px, a, b).errors);
}

Colors constant(int r, int g, int b) {
  return [=](int, int) { return glm::u8vec3(glm::u8(r), glm::u8(g), glm::u8(b)); };
}
Colors grey(const std::function<int(int x, int y)>& value) {
  return [=](int x, int y) { return glm::u8vec3(glm::u8(value(x, y))); };
}
int checker(int x, int y) { return (((x >> 3) ^ (y >> 3)) & 1) != 0 ? 255 : 0; }

TEST(Flip, ConstantsHaveTheirPublishedValues) {
  const glm::ivec2 size(9, 5);
  EXPECT_NEAR(mean_of(size, constant(0, 0, 0), constant(255, 255, 255)), 0.967388, kMeanTolerance);
  EXPECT_NEAR(mean_of(size, constant(0, 255, 0), constant(0, 0, 255)), 1.0, kMeanTolerance);
  EXPECT_NEAR(mean_of(size, constant(255, 0, 0), constant(0, 255, 0)), 0.986665, kMeanTolerance);
  EXPECT_NEAR(mean_of(size, constant(128, 128, 128), constant(129, 129, 129)), 0.02987, kMeanTolerance);
  EXPECT_NEAR(mean_of(size, constant(128, 128, 128), constant(136, 136, 136)), 0.12759, kMeanTolerance);
}

TEST(Flip, CheckersHaveTheirPublishedValues) {
  const glm::ivec2 size(256, 256);
  EXPECT_NEAR(mean_of(size, grey(checker), grey([](int x, int y) { return checker(x + 1, y); })), 0.318440,
              kMeanTolerance);
  EXPECT_NEAR(mean_of(size, grey(checker), grey([](int x, int y) { return 255 - checker(x, y); })), 0.756527,
              kMeanTolerance);
}

TEST(Flip, OnePixelAndOneStepHaveTheirPublishedValues) {
  const auto pixel = grey([](int x, int y) { return x == 64 && y == 64 ? 255 : 0; });
  EXPECT_NEAR(mean_of({129, 129}, constant(0, 0, 0), pixel), 0.000860, kMeanTolerance);
  const auto step = [](int first) { return grey([first](int x, int) { return x < first ? 255 : 0; }); };
  EXPECT_NEAR(mean_of({128, 128}, step(64), step(65)), 0.025857, kMeanTolerance);
}

TEST(Flip, EqualPicturesHaveNoErrorAndAlphaIsLeftOut) {
  const glm::ivec2 size(16, 3);
  const Texels picture = painted(size, grey(checker));
  Texels other_alpha = picture;
  for (glm::u8vec4& texel : other_alpha) texel.a = 7;
  for (const float error : flip_map({size, picture, other_alpha}).errors) EXPECT_EQ(error, 0.0f);
}

TEST(Flip, IsSymmetricAndTheSameForAnyNumberOfThreads) {
  const glm::ivec2 size(50, 71);  // three strips, the last of 7 rows
  const auto a = grey([](int x, int y) { return (x * x + 3 * y) & 255; });
  const Colors b = [](int x, int y) { return glm::u8vec3(glm::u8(x * y), glm::u8(5 * y), glm::u8(255 - x)); };
  const ErrorMap map = flip_of(size, a, b);
  EXPECT_EQ(flip_of(size, a, b, {.threads = 3}).errors, map.errors);
  EXPECT_EQ(flip_of(size, b, a).errors, map.errors);
}

TEST(Flip, ErrorsDoNotDependOnWhereAPictureIsCutIntoStrips) {
  // Rows 20 and up of a picture whose rows are all equal are like those of any other height.
  const auto a = grey([](int x, int) { return (x * 7) & 255; }), b = grey([](int x, int) { return (x * x) & 255; });
  const ErrorMap tall = flip_of({40, 70}, a, b), flat = flip_of({40, 1}, a, b);
  for (std::size_t i = 0; i < tall.errors.size(); ++i) EXPECT_EQ(tall.errors[i], flat.errors[i % 40]) << i;
}

TEST(Flip, HasOneSetOfBitsEverywhere) {
  // Not derived: what the first compiler gave, for the others to give, too. FNV-1a of the errors' bits.
  const auto a = grey([](int x, int y) { return (x * x + 3 * y) & 255; });
  const Colors b = [](int x, int y) { return glm::u8vec3(glm::u8(x * y), glm::u8(5 * y), glm::u8(255 - x)); };
  std::uint64_t hash = 0xcbf29ce484222325u;
  for (const float error : flip_of({50, 40}, a, b).errors) {
    hash = (hash ^ std::bit_cast<std::uint32_t>(error)) * 0x100000001b3u;
  }
  EXPECT_EQ(hash, 4242823168579239489u);
}

TEST(Flip, PicturesOfNoPixelsHaveNoErrorsAndOneOfOnePixelHasOne) {
  EXPECT_TRUE(flip_map({{0, 5}, {}, {}}).errors.empty());
  EXPECT_NEAR(mean_of({1, 1}, constant(0, 0, 0), constant(255, 255, 255)), 0.967388, kMeanTolerance);
}

TEST(Flip, WhatCannotBeMeantIsTheCallersMistake) {
  const Texels texels(6);
  EXPECT_THROW((void)flip_map({{2, 3}, texels, std::span(texels).first(5)}), std::logic_error);
  EXPECT_THROW((void)flip_map({{2, 3}, texels, texels}, {.pixels_per_degree = 0.5}), std::logic_error);
}

TEST(FlipFilters, HaveUnitSumsBySign) {
  const flip::Filters f = flip::make_filters(67.0);
  EXPECT_EQ(f.radius, 10);  // ⌈3 · √(0.04 / 2π²) · 67⌉ = ⌈9.05⌉
  double gaussian = 0.0, achromatic = 0.0, positive = 0.0, negative = 0.0, edge = 0.0;
  for (std::size_t k = 0; k < 21; ++k) {
    gaussian += double{f.gaussian[k]};
    achromatic += f.achromatic[k];
    edge += std::fabs(double{f.edge[k]});
    (f.point[k] > 0.0f ? positive : negative) += double{f.point[k]};
  }
  EXPECT_NEAR(gaussian, 1.0, 1e-7);
  EXPECT_NEAR(achromatic, 1.0, 1e-15);
  EXPECT_NEAR(edge, 2.0, 1e-6);
  EXPECT_NEAR(positive, 1.0, 1e-6);
  EXPECT_NEAR(negative, -1.0, 1e-6);
}

}  // namespace
}  // namespace lode::experiments
