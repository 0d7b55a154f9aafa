/// Polygons become triangles that cover them once.

#include "geometry/polygon.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <cmath>
#include <glm/geometric.hpp>

#include "geometry/random.h"

namespace lode::geometry {
namespace {

using testing::ElementsAre;
using Corners = std::vector<glm::vec3>;

std::vector<std::uint32_t> triangles_of(const Corners& corners) {
  std::vector<std::uint32_t> triangles;
  EXPECT_TRUE(triangulate(corners, triangles));
  EXPECT_EQ(triangles.size(), 3 * (corners.size() - 2));
  return triangles;
}

/// Twice the sum of the triangles' areas, each counted as positive, and of the polygon's own signed area, in x and y.
struct Areas {
  double triangles = 0.0, polygon = 0.0;
};
Areas areas(const Corners& p) {
  const auto cross = [&](std::size_t a, std::size_t b, std::size_t c) {
    const glm::dvec3 ab = glm::dvec3(p[b]) - glm::dvec3(p[a]), ac = glm::dvec3(p[c]) - glm::dvec3(p[a]);
    return ab.x * ac.y - ab.y * ac.x;
  };
  Areas result;
  const std::vector<std::uint32_t> t = triangles_of(p);
  for (std::size_t i = 0; i < t.size(); i += 3) result.triangles += std::fabs(cross(t[i], t[i + 1], t[i + 2]));
  for (std::size_t i = 1; i + 1 < p.size(); ++i) result.polygon += cross(0, i, i + 1);
  return result;
}

TEST(Polygon, AConvexOneIsAFanFromItsFirstCorner) {
  EXPECT_THAT(triangles_of({{0, 0, 0}, {1, 0, 0}, {0, 1, 0}}), ElementsAre(0, 1, 2));
  EXPECT_THAT(triangles_of({{0, 0, 0}, {1, 0, 0}, {1, 1, 0}, {0, 1, 0}}), ElementsAre(0, 1, 2, 0, 2, 3));
  // Seen from behind (clockwise), and with a corner in the middle of an edge.
  EXPECT_THAT(triangles_of({{0, 0, 0}, {0, 1, 0}, {1, 1, 0}, {1, 0, 0}}), ElementsAre(0, 1, 2, 0, 2, 3));
  EXPECT_THAT(triangles_of({{0, 0, 0}, {1, 0, 0}, {2, 0, 0}, {2, 2, 0}, {0, 2, 0}}),
              ElementsAre(0, 1, 2, 0, 2, 3, 0, 3, 4));
}

TEST(Polygon, AConcaveQuadIsCutAtItsReflexCorner) {
  // An arrowhead with its notch at corner 2, where the fan from corner 0 has its diagonal already; and turned by one,
  // where corner 1 is the notch and the diagonal must not start at corner 0.
  EXPECT_EQ(areas({{0, 0, 0}, {4, 1, 0}, {1, 1, 0}, {1, 4, 0}}).triangles,
            areas({{0, 0, 0}, {4, 1, 0}, {1, 1, 0}, {1, 4, 0}}).polygon);
  const Corners turned = {{4, 1, 0}, {1, 1, 0}, {1, 4, 0}, {0, 0, 0}};
  EXPECT_EQ(areas(turned).triangles, areas(turned).polygon);
  EXPECT_THAT(triangles_of(turned), ElementsAre(3, 0, 1, 2, 3, 1));
}

TEST(Polygon, ConcaveOnesAreCoveredOnceInEveryPlane) {
  // A comb with random teeth: n − 2 triangles whose areas add up to the polygon's, so that none overlaps another.
  Random random(1, 0);
  for (int k = 0; k < 200; ++k) {
    Corners comb = {{0, -1, 0}};
    const int n = 3 + int(random.below(20));
    comb.push_back({float(n), -1, 0});
    for (int i = n; i >= 0; --i) comb.push_back({float(i), i % 2 == 0 ? 0.5f : float(1 + random.below(9)), 0});
    const Areas plain = areas(comb);
    EXPECT_EQ(plain.triangles, plain.polygon) << k;
    // The same triangles in a plane that leans, from either side.
    const std::vector<std::uint32_t> triangles = triangles_of(comb);
    for (glm::vec3& p : comb) p = {p.z + 7.0f, p.x, p.y + 2.0f * p.x};
    EXPECT_EQ(triangles_of(comb), triangles);
  }
}

TEST(Polygon, ASpiralIsCoveredOnce) {
  Corners spiral;
  for (int i = 0; i < 100; ++i)
    spiral.push_back({float((i % 4 < 2 ? 1 : -1) * (i + 2)), float((i % 4 == 1 || i % 4 == 2 ? 1 : -1) * (i + 2)), 0});
  for (int i = 99; i >= 0; --i)
    spiral.push_back({spiral[std::size_t(i)].x * 1.001f, spiral[std::size_t(i)].y * 1.001f, 0});
  const Areas a = areas(spiral);
  EXPECT_NEAR(a.triangles, std::fabs(a.polygon), 1e-9 * a.triangles);
}

TEST(Polygon, AHoleBridgedByADoubledEdgeStaysOpen) {
  // A square of side 4 with a square hole of side 2, by the edge (0,0)-(1,1) there and back: area 16 − 4 = 12.
  const Corners ring = {{0, 0, 0}, {4, 0, 0}, {4, 4, 0}, {0, 4, 0}, {0, 0, 0},
                        {1, 1, 0}, {1, 3, 0}, {3, 3, 0}, {3, 1, 0}, {1, 1, 0}};
  EXPECT_EQ(areas(ring).triangles, 24.0);
}

TEST(Polygon, WhatHasNoAreaOrCrossesItselfGivesAsManyTriangles) {
  triangles_of({{1, 1, 1}, {1, 1, 1}, {1, 1, 1}, {1, 1, 1}, {1, 1, 1}});
  triangles_of({{0, 0, 0}, {1, 0, 0}, {2, 0, 0}, {3, 0, 0}});
  triangles_of({{0, 0, 0}, {1, 1, 0}, {1, 0, 0}, {0, 1, 0}});                 // a bow
  triangles_of({{0, 3, 0}, {2, -3, 0}, {-3, 1, 0}, {3, 1, 0}, {-2, -3, 0}});  // a pentagram
  triangles_of({{3e38f, 0, 0}, {-3e38f, 3e38f, 0}, {0, -3e38f, 0}, {1, 1, 3e38f}, {0, 0, 0}});
  Random random(2, 0);
  for (int k = 0; k < 300; ++k) {
    Corners any;
    for (std::uint32_t i = 0, n = 3 + random.below(30); i < n; ++i) {
      any.push_back({float(random.below(5)), float(random.below(5)), float(random.below(2))});
    }
    for (const std::uint32_t corner : triangles_of(any)) EXPECT_LT(corner, any.size());
  }
}

TEST(Polygon, OnlyConcaveOnesHaveALimit) {
  Corners circle, star;
  const std::size_t n = kMaxConcaveCorners + 2;
  for (std::size_t i = 0; i < n; ++i) {
    const double x = double(i) / double(n);  // on a parabola: convex
    circle.push_back({float(i), float(x * double(i)), 0});
    star.push_back({float(i), i % 2 == 0 ? 0.0f : 1.0f, 0});
  }
  star.push_back({0, 10, 0});
  EXPECT_EQ(triangles_of(circle).size(), 3 * (n - 2));
  std::vector<std::uint32_t> triangles;
  EXPECT_FALSE(triangulate(star, triangles));
  EXPECT_TRUE(triangles.empty());
}

}  // namespace
}  // namespace lode::geometry
