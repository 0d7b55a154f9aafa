/// Hulls that are said to be inside of random closed models against points of them: 2·10^4 hulls in CI, 2·10^6
/// long.

#include <gtest/gtest.h>

#include "geometry/inner_boxes.h"
#include "tests/geometry/solid_models.h"
#include "tests/raster/stress_count.h"

namespace lode::geometry {
namespace {

TEST(SolidStress, NoPointOfAContainedHullIsOutside) {
  const std::uint64_t n = raster::test::stress_count("hulls of random models", 20'000, 2'000'000);
  std::uint64_t n_contained = 0;
  for (std::uint64_t i = 0; i < n; ++i) {
    int n_false = 0;
    n_contained += test::hull_case(i, 100, n_false);
    ASSERT_EQ(n_false, 0) << i;
  }
  EXPECT_GT(n_contained, n / 4);
}

TEST(SolidStress, TenThousandPointsOfEachInnerBoxAreInside) {
  const std::uint64_t n = raster::test::stress_count("models filled with boxes", 40, 20'000);
  for (std::uint64_t i = 0; i < n; ++i) {
    const Solid solid = test::random_closed_model(i).solid();
    for (const Bounds& b : inner_boxes(solid, {.resolution = 16})) {
      ASSERT_EQ(test::n_outside(solid, test::box_corners(glm::vec3(b.low), glm::vec3(b.high)), 10'000, i), 0) << i;
    }
  }
}

}  // namespace
}  // namespace lode::geometry
