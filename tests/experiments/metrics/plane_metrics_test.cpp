/// Depth errors, overdraw, popping, percentiles and the colour map.

#include <gtest/gtest.h>

#include <cmath>
#include <limits>
#include <numeric>

#include "experiments/metrics/depth_error.h"
#include "experiments/metrics/error_map.h"
#include "experiments/metrics/magma.h"
#include "experiments/metrics/overdraw.h"
#include "experiments/metrics/popping.h"

namespace lode::experiments {
namespace {

constexpr float kInfinity = std::numeric_limits<float>::infinity();

TEST(DepthError, AnUlpIsOneStepOfFloats) {
  EXPECT_EQ(ulp_distance(1.0f, 1.0f), 0u);
  EXPECT_EQ(ulp_distance(1.0f, std::nextafter(1.0f, 2.0f)), 1u);
  EXPECT_EQ(ulp_distance(std::nextafter(1.0f, 0.0f), std::nextafter(1.0f, 2.0f)), 2u);
  EXPECT_EQ(ulp_distance(0.5f, 1.0f), 1u << 23);
  EXPECT_EQ(ulp_distance(0.0f, -0.0f), 0u);
  EXPECT_EQ(ulp_distance(-0x1p-149f, 0x1p-149f), 2u);
  EXPECT_EQ(ulp_distance(-kInfinity, kInfinity), 2u * 0x7F800000u);
}

TEST(DepthError, IsCountedByPowersOfTwo) {
  // Steps of 2^-24 below 1: 0, 1, 2, 3, 4, 7, 8.
  std::vector<float> a(7, 0.5f), b;
  for (const int steps : {0, 1, 2, 3, 4, 7, 8}) b.push_back(0.5f + float(steps) * 0x1p-24f);
  const DepthError e = depth_error(a, b);
  EXPECT_EQ(e.compared, 7u);
  EXPECT_EQ(e.max_ulp, 8u);
  EXPECT_EQ(e.histogram[0], 1u);
  EXPECT_EQ(e.histogram[1], 1u);
  EXPECT_EQ(e.histogram[2], 2u);
  EXPECT_EQ(e.histogram[3], 2u);
  EXPECT_EQ(e.histogram[4], 1u);
}

TEST(DepthError, NothingIsNoDepth) {
  const float nan = std::nanf("");
  const std::vector<float> a = {0.0f, 0.0f, 0.25f, nan, 0.25f}, b = {-0.0f, 0.5f, 0.0f, 0.5f, 0.25f};
  const DepthError e = depth_error(a, b);
  EXPECT_EQ(e.compared, 1u);
  EXPECT_EQ(e.one_sided, 2u);
  EXPECT_EQ(e.not_a_number, 1u);
  EXPECT_EQ(e.max_ulp, 0u);
}

TEST(DepthError, PixelsCanBeLeftOut) {
  const std::vector<float> a = {0.5f, 0.5f}, b = {0.75f, 0.5f};
  const std::vector<std::uint8_t> where = {0, 1};
  EXPECT_EQ(depth_error(a, b, where).max_ulp, 0u);
  EXPECT_EQ(depth_error(a, b, where).compared, 1u);
  EXPECT_THROW((void)depth_error(a, b, std::span(where).first(1)), std::logic_error);
  EXPECT_THROW((void)depth_error(a, std::span(b).first(1)), std::logic_error);
}

TEST(DepthError, TheLargestHasAPlaceInTheHistogram) {
  const std::vector<float> a = {-kInfinity}, b = {kInfinity};
  EXPECT_EQ(depth_error(a, b).histogram[32], 1u);
}

TEST(Overdraw, IsPerPixelThatIsDrawn) {
  const std::vector<raster::Ids> ids = {{0, 0}, {raster::kNoId, raster::kNoId}, {7, 1}};
  raster::FrameStats stats;
  stats.fragments_covered = 5;
  stats.fragments_depth_failed = 3;
  stats.fragments_shaded = 2;
  const Overdraw o = overdraw(stats, ids);
  EXPECT_EQ(o.drawn_pixels, 2u);
  EXPECT_EQ(o.covered, 2.5);
  EXPECT_EQ(o.hidden, 1.5);
  EXPECT_EQ(o.shaded, 1.0);
  EXPECT_EQ(overdraw(stats, {}).covered, 0.0);
}

/// Grey pixels.
std::vector<glm::u8vec4> greys(const std::vector<int>& values) {
  std::vector<glm::u8vec4> texels;
  for (const int v : values) texels.emplace_back(glm::u8vec3(glm::u8(v)), 255);
  return texels;
}

Popping popping_of(const std::vector<int>& before, const std::vector<int>& now, const std::vector<int>& true_before,
                   const std::vector<int>& true_now) {
  const auto a = greys(before), b = greys(now), c = greys(true_before), d = greys(true_now);
  return popping({a, b, c, d});
}

TEST(Popping, AnErrorThatStaysDoesNotPop) {
  const Popping p = popping_of({10, 20}, {15, 25}, {110, 120}, {115, 125});
  EXPECT_EQ(p.mean, 0.0);
  EXPECT_EQ(p.p99, 0.0);
}

TEST(Popping, IsTheChangeBeyondTheTruths) {
  // (15 − 10) − (100 − 103) = 8 and (0 − 255) − (255 − 0) = −510.
  const Popping p = popping_of({10, 255}, {15, 0}, {103, 0}, {100, 255});
  EXPECT_EQ(p.mean, 259.0);
  EXPECT_EQ(p.p99, 510.0);
}

TEST(Popping, ChannelsAreAveragedAndAlphaIsLeftOut) {
  const std::vector<glm::u8vec4> zero(1, glm::u8vec4(0)), one(1, glm::u8vec4(3, 0, 4, 200));
  EXPECT_EQ(popping({zero, one, zero, zero}).mean, 7.0 / 3.0);
  EXPECT_EQ(popping({zero, one, zero, zero}).p99, 7.0 / 3.0);
}

TEST(Popping, OfAHundredPixelsOneMayBeAboveThe99thPercentile) {
  std::vector<int> now(100, 0);
  const std::vector<int> zero(100, 0);
  now[17] = 90;
  EXPECT_EQ(popping_of(zero, now, zero, zero).p99, 0.0);
  EXPECT_DOUBLE_EQ(popping_of(zero, now, zero, zero).mean, 0.9);
  now[18] = 60;
  EXPECT_EQ(popping_of(zero, now, zero, zero).p99, 60.0);
}

TEST(Popping, SizesThatDifferAreTheCallersMistake) {
  EXPECT_THROW((void)popping_of({1}, {1}, {1}, {1, 2}), std::logic_error);
  EXPECT_EQ(popping_of({}, {}, {}, {}).mean, 0.0);
}

TEST(ErrorMap, PercentilesAreOfTheNearestRank) {
  std::vector<float> errors(200);
  std::iota(errors.rbegin(), errors.rend(), 1.0f);
  EXPECT_EQ(error_percentile(errors, 99), 198.0f);
  EXPECT_EQ(error_percentile(errors, 100), 200.0f);
  EXPECT_EQ(error_percentile(errors, 50), 100.0f);
  EXPECT_EQ(error_percentile(std::span(errors).first(1), 1), 200.0f);
  EXPECT_EQ(error_percentile({}, 99), 0.0f);
  EXPECT_THROW((void)error_percentile(errors, 0), std::logic_error);
  EXPECT_EQ(mean_error(errors), 100.5);
  EXPECT_EQ(mean_error({}), 0.0);
}

TEST(Magma, BeginsNearBlackAndEndsInPaleYellow) {
  EXPECT_EQ(magma(0.0f), glm::u8vec4(0, 0, 4, 255));
  EXPECT_EQ(magma(1.0f), glm::u8vec4(252, 253, 191, 255));
  EXPECT_EQ(magma(-1.0f), magma(0.0f));
  EXPECT_EQ(magma(std::nanf("")), magma(0.0f));
  EXPECT_EQ(magma(kInfinity), magma(1.0f));
  EXPECT_EQ(magma(0.5f / 255.0f), magma(1.0f / 255.0f));  // half up
  const std::vector<float> values = {0.0f, 1.0f};
  EXPECT_EQ(magma_picture(values), (std::vector<glm::u8vec4>{magma(0.0f), magma(1.0f)}));
}

}  // namespace
}  // namespace lode::experiments
