/// Convex hulls in the plane (C14).

#include "geometry/hull_2d.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <cmath>

#include "geometry/convex_chains.h"
#include "geometry/predicates.h"
#include "geometry/random.h"

namespace lode::geometry {
namespace {

using testing::ElementsAre;
using Points = std::vector<glm::dvec2>;

TEST(Hull2d, DegenerateSetsArePointsAndSegments) {
  EXPECT_TRUE(convex_hull_2d(Points{}).empty());
  EXPECT_THAT(convex_hull_2d(Points{{2, 2}}), ElementsAre(0));
  EXPECT_THAT(convex_hull_2d(Points{{2, 2}, {2, 2}, {2, 2}}), ElementsAre(0));
  EXPECT_THAT(convex_hull_2d(Points{{1, 1}, {0, 0}, {3, 3}, {2, 2}, {3, 3}}), ElementsAre(1, 2));
  EXPECT_THAT(convex_hull_2d(Points{{0, 2}, {0, 1}, {0, 3}}), ElementsAre(1, 2));
}

TEST(Hull2d, RunsCounterClockwiseFromTheSmallestPointWithoutCollinearOnes) {
  EXPECT_THAT(convex_hull_2d(Points{{1, 1}, {2, 2}, {0, 2}, {1, 0}, {0, 0}, {2, 0}, {0, 1}, {2, 1}, {1, 2}}),
              ElementsAre(4, 5, 1, 2));
}

TEST(Hull2d, RefusesWhatIsNotFinite) { EXPECT_THROW((void)convex_hull_2d(Points{{0, 0}, {NAN, 0}}), std::logic_error); }

/// On small grids nearly everything is degenerate: every edge has all points on its left or between its ends, and every
/// corner turns left.
TEST(Hull2d, HoldsEveryPointOfSmallGrids) {
  Random random(4, 1);
  for (int k = 0; k < 2000; ++k) {
    Points points;
    const std::uint32_t size = 1 + random.below(6);
    for (std::uint32_t n = 1 + random.below(20); n > 0; --n)
      points.emplace_back(random.below(size), random.below(size));
    const std::vector<std::uint32_t> hull = convex_hull_2d(points);
    if (hull.size() < 3) continue;
    for (std::size_t i = 0; i < hull.size(); ++i) {
      const glm::dvec2 &a = points[hull[i]], &b = points[hull[(i + 1) % hull.size()]];
      for (const glm::dvec2& p : points) EXPECT_GE(orientation(a, b, p), 0);
      EXPECT_GT(orientation(a, b, points[hull[(i + 2) % hull.size()]]), 0);
    }
  }
}

TEST(ConvexChains, ASquareHasOneEdgeBelowAndOneAbove) {
  const ConvexChains chains = convex_chains(Points{{0, 0}, {4, 1}, {4, 5}, {0, 4}, {2, 2}});
  EXPECT_THAT(chains.lower, ElementsAre(glm::dvec2(0, 0), glm::dvec2(4, 1)));
  EXPECT_THAT(chains.upper, ElementsAre(glm::dvec2(0, 4), glm::dvec2(4, 5)));
}

TEST(ConvexChains, PointsAndSegmentsHaveChainsToo) {
  const ConvexChains point = convex_chains(Points{{1, 2}});
  EXPECT_THAT(point.lower, ElementsAre(glm::dvec2(1, 2)));
  EXPECT_THAT(point.upper, ElementsAre(glm::dvec2(1, 2)));
  const ConvexChains upright = convex_chains(Points{{1, 2}, {1, 5}});
  EXPECT_THAT(upright.lower, ElementsAre(glm::dvec2(1, 2)));
  EXPECT_THAT(upright.upper, ElementsAre(glm::dvec2(1, 5)));
  const ConvexChains level = convex_chains(Points{{1, 2}, {3, 2}});
  EXPECT_THAT(level.lower, ElementsAre(glm::dvec2(1, 2), glm::dvec2(3, 2)));
  EXPECT_THAT(level.upper, ElementsAre(glm::dvec2(1, 2), glm::dvec2(3, 2)));
}

TEST(ConvexChains, HeightsAreWithinTheirBoundOfTheEdge) {
  // A height y + error must be on or above the line, y − error on or below: by exact orientation.
  Random random(4, 2);
  for (int k = 0; k < 20000; ++k) {
    const double size = std::ldexp(1.0, int(random.below(40)));
    const glm::dvec2 p(random.uniform(-1, 1) * size, random.uniform(-1, 1) * size);
    const glm::dvec2 q(p.x + random.uniform() * size, random.uniform(-1, 1));
    const std::vector<glm::dvec2> chain = {p, q};
    const double x = p.x + random.uniform() * (q.x - p.x);
    if (!(p.x <= x && x <= q.x && p.x < q.x)) continue;
    const ChainHeight at = ChainWalk(chain).at(x);
    EXPECT_GE(orientation(p, q, glm::dvec2(x, at.y + at.error)), 0);
    EXPECT_LE(orientation(p, q, glm::dvec2(x, at.y - at.error)), 0);
  }
}

}  // namespace
}  // namespace lode::geometry
