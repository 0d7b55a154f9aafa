/// Convex hulls in space (C14).

#include "geometry/hull.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <cmath>
#include <limits>

#include "tests/geometry/hull_cases.h"

namespace lode::geometry {
namespace {

using test::Points3;
using testing::ElementsAre;

TEST(Hull, SaysWhatThePointsSpan) {
  EXPECT_EQ(convex_hull(Points3{}).kind, HullKind::nothing);
  const Hull point = convex_hull(Points3{{1, 2, 3}, {1, 2, 3}});
  EXPECT_EQ(point.kind, HullKind::point);
  EXPECT_THAT(point.vertices, ElementsAre(0));
  const Hull segment = convex_hull(Points3{{1, 1, 1}, {3, 3, 3}, {0, 0, 0}, {2, 2, 2}, {3, 3, 3}});
  EXPECT_EQ(segment.kind, HullKind::segment);
  EXPECT_THAT(segment.vertices, ElementsAre(1, 2));
  const Hull polygon = convex_hull(Points3{{0, 0, 1}, {2, 0, 1}, {1, 0, 1}, {2, 2, 1}, {0, 2, 1}, {1, 1, 1}});
  EXPECT_EQ(polygon.kind, HullKind::polygon);
  EXPECT_THAT(polygon.vertices, ElementsAre(0, 1, 3, 4));
  EXPECT_TRUE(polygon.triangles.empty());
}

TEST(Hull, ACubeOfGridPointsHasEightVerticesAndTwelveTriangles) {
  Points3 points;
  for (int i = 0; i < 125; ++i) points.emplace_back(i % 5, i / 5 % 5, i / 25);
  const Hull hull = convex_hull(points);
  EXPECT_THAT(hull.vertices, ElementsAre(0, 4, 20, 24, 100, 104, 120, 124));
  EXPECT_EQ(hull.triangles.size(), 12u);
  EXPECT_EQ(test::wrong_with(hull, points), "");
  EXPECT_TRUE(contains(hull, points, {4, 4, 4}));
  EXPECT_FALSE(contains(hull, points, {4, 4, std::nextafter(4.0, 5.0)}));
}

TEST(Hull, HoldsEveryPointOfDegenerateGridsAndNeedsEveryVertex) {
  int n_polyhedra = 0;
  for (std::uint64_t i = 0; i < 1000; ++i) {
    const Points3 points = test::grid_points(i);
    const Hull hull = convex_hull(points);
    EXPECT_EQ(test::wrong_with(hull, points), "") << i;
    n_polyhedra += hull.kind == HullKind::polyhedron;
  }
  EXPECT_GT(n_polyhedra, 300);
}

TEST(Hull, CocircularPointsAreAllVertices) {
  // 24 points of a circle in integers (25² = 7² + 24² = 15² + 20²), as a prism's ends: two faces of many corners.
  Points3 points;
  for (const double z : {0.0, 1.0}) {
    for (const auto& [x, y] : {std::pair(25, 0), {24, 7}, {20, 15}, {15, 20}, {7, 24}}) {
      for (const auto& [u, v] : {std::pair(x, y), {-y, x}, {-x, -y}, {y, -x}}) points.emplace_back(u, v, z);
    }
    points.emplace_back(3, 4, z);
  }
  const Hull hull = convex_hull(points);
  EXPECT_EQ(hull.vertices.size(), 40u);
  EXPECT_EQ(test::wrong_with(hull, points), "");
}

TEST(Hull, SurvivesTheSmallestAndTheLargestDoubles) {
  const double big = std::numeric_limits<double>::max(), tiny = std::numeric_limits<double>::denorm_min();
  const Points3 points = {{-big, -big, 0}, {big, -big, tiny}, {big, big, 0}, {-big, big, 0}, {0, 0, tiny}, {0, 0, 0}};
  const Hull hull = convex_hull(points);
  EXPECT_EQ(hull.kind, HullKind::polyhedron);
  EXPECT_EQ(test::wrong_with(hull, points), "");
  EXPECT_THROW((void)convex_hull(Points3{{NAN, 0, 0}}), std::logic_error);
}

TEST(Hull, ThousandsOfPointsOnASphereAndInABall) {
  Random random(5, 80);
  Points3 sphere;
  for (int i = 0; i < 3000; ++i) {
    glm::dvec3 p(random.uniform(-1, 1), random.uniform(-1, 1), random.uniform(-1, 1));
    const double length = std::sqrt(p.x * p.x + p.y * p.y + p.z * p.z);
    if (i % 2 == 0) p = p / length;
    sphere.push_back(p * (length < 1.0 || i % 2 == 0 ? 1.0 : 0.5));
  }
  const Hull hull = convex_hull(sphere);
  for (std::size_t i = 0; i < sphere.size(); i += 7) EXPECT_TRUE(contains(hull, sphere, sphere[i]));
  EXPECT_EQ(hull.triangles.size(), 2 * hull.vertices.size() - 4);  // Euler's, in a closed surface of triangles
}

}  // namespace
}  // namespace lode::geometry
