/// Hulls in space at the stress count (C14): 10^5 degenerate sets in CI, 10^7 long; and one of 10^5 points.

#include <gtest/gtest.h>

#include "tests/geometry/hull_cases.h"
#include "tests/raster/stress_count.h"

namespace lode::geometry {
namespace {

TEST(HullStress, DegenerateGrids) {
  const std::uint64_t n = raster::test::stress_count("degenerate sets", 100'000, 10'000'000);
  for (std::uint64_t i = 0; i < n; ++i) {
    const test::Points3 points = test::grid_points(i);
    ASSERT_EQ(test::wrong_with(convex_hull(points), points), "") << i;
  }
}

TEST(HullStress, AHundredThousandPointsOnAParaboloidOfIntegers) {
  // z = x² + y² on a grid: all are extreme, and every four neighbours are coplanar (cocircular in the plane).
  test::Points3 points;
  for (int i = 0; i < 100'000; ++i) {
    const double x = i % 400, y = i / 400;
    points.emplace_back(x, y, x * x + y * y);
  }
  const Hull hull = convex_hull(points);
  EXPECT_EQ(hull.vertices.size(), points.size());
  EXPECT_EQ(hull.triangles.size(), 2 * points.size() - 4);
}

}  // namespace
}  // namespace lode::geometry
