/// What is said to be inside a model is.

#include "geometry/solid.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <limits>

#include "geometry/convex_body.h"
#include "geometry/error.h"
#include "geometry/procedural/furniture.h"
#include "tests/geometry/solid_models.h"

namespace lode::geometry {
namespace {

using test::box_corners;
using test::soup_of;

TEST(Solid, BoxContainsItselfAndNothingBeyondOneUnitInTheLastPlace) {
  const Solid solid = soup_of(box({0, 0, 0}, {1, 2, 3})).solid();
  EXPECT_TRUE(solid.contains_box({0, 0, 0}, {1, 2, 3}));
  EXPECT_TRUE(solid.contains_hull(box_corners({0, 0, 0}, {1, 2, 3})));
  EXPECT_FALSE(solid.contains_box({0, 0, 0}, {std::nextafter(1.0f, 2.0f), 2, 3}));
  std::vector<glm::vec3> corners = box_corners({0, 0, 0}, {1, 2, 3});
  corners.emplace_back(0.5f, 1.0f, std::nextafter(3.0f, 4.0f));
  EXPECT_FALSE(solid.contains_hull(corners));
}

// The torus' winding number is 1 in the tube, 0 in the hole and outside.
TEST(Solid, WindingCountsTheTubeOfATorusAndNotItsHole) {
  const Solid solid = soup_of(torus({0, 0, 0}, 2.0, 0.5, 24, 12)).solid();
  ASSERT_EQ(solid.parts().size(), 1u);
  EXPECT_EQ(solid.winding(0, {2, 0, 0}), 1);
  EXPECT_EQ(solid.winding(0, {0, 0, -2}), 1);
  EXPECT_EQ(solid.winding(0, {0, 0, 0}), 0);
  EXPECT_EQ(solid.winding(0, {0, 2, 0}), 0);
  EXPECT_EQ(solid.winding(0, {9, 0, 0}), 0);
  EXPECT_FALSE(solid.contains_box({-2, -0.1f, -0.1f}, {2, 0.1f, 0.1f}));  // across the hole
  EXPECT_FALSE(solid.contains_box({-0.1f, -0.1f, -0.1f}, {0.1f, 0.1f, 0.1f}));
  EXPECT_TRUE(solid.contains_box({1.8f, -0.2f, -0.2f}, {2.2f, 0.2f, 0.2f}));
}

// Lines up from these points pass through vertices and along edges.
TEST(Solid, WindingIsExactBelowVerticesAndEdges) {
  const Solid solid = soup_of(torus({0, 0, 0}, 2.0, 0.5, 4, 4)).solid();
  // Four segments: the tube's square sections stand at (±2, 0, 0) and (0, 0, ±2); the hole ends at |x| + |z| = 3/2.
  for (const double s : {-1.0, 1.0}) {
    EXPECT_EQ(solid.winding(0, {2 * s, 0, 0}), 1);
    EXPECT_EQ(solid.winding(0, {0, 0, 2 * s}), 1);
    EXPECT_EQ(solid.winding(0, {0, 0, s}), 0);
    EXPECT_EQ(solid.winding(0, {0, 0, 3 * s}), 0);
  }
}

TEST(Solid, EachArmOfAnLIsInsideAndTheHullOfAllSticksOut) {
  const test::Soup soup = test::l_shape();
  const Solid solid = soup.solid();
  ASSERT_EQ(solid.parts().size(), 1u);
  EXPECT_DOUBLE_EQ(solid.volume(), 5.0);
  EXPECT_FALSE(solid.contains_hull(soup.positions));
  EXPECT_TRUE(solid.contains_box({0, 0, 0}, {3, 1, 1}));
  EXPECT_TRUE(solid.contains_box({0, 0, 0}, {1, 3, 1}));
  EXPECT_FALSE(solid.contains_box({0, 0, 0}, {2, 2, 1}));
  // A wedge with an edge from end to end of the inner corner's line, x = y = 1: it touches it.
  const std::vector<glm::vec3> touching = {{0, 2, 0}, {2, 0, 0}, {0, 0, 0}, {0, 2, 1}, {2, 0, 1}, {0, 0, 1}};
  EXPECT_TRUE(solid.contains_hull(touching));
}

// The edge from (0, r, 3/4) to (r, 0, 1/4) passes the inner corner's line x = y = 1 at x = y = r/2: only a plane along
// both lines tells. At r = 2 it touches.
TEST(Solid, AnEdgeAcrossAnEdgeIsJudgedExactly) {
  const Solid solid = test::l_shape().solid();
  const auto tetrahedron = [](float reach) {
    return std::vector<glm::vec3>{{0, reach, 0.75f}, {reach, 0, 0.25f}, {0, 0, 0.5f}, {0, 0, 0.625f}};
  };
  EXPECT_TRUE(solid.contains_hull(tetrahedron(2.0f)));
  EXPECT_FALSE(solid.contains_hull(tetrahedron(std::nextafter(2.0f, 3.0f))));
}

TEST(Solid, NothingIsInsideAnOpenBoxNorOneInsideOut) {
  Mesh open = box({0, 0, 0}, {1, 1, 1});
  open.indices.resize(open.indices.size() - 3);
  EXPECT_EQ(soup_of(open).solid().n_open(), 1u);
  EXPECT_FALSE(soup_of(open).solid().contains_box(glm::vec3(0.25f), glm::vec3(0.75f)));
  const Solid inward = soup_of(test::inside_out(box({0, 0, 0}, {1, 1, 1}))).solid();
  EXPECT_EQ(inward.n_inward(), 1u);
  EXPECT_FALSE(inward.contains_box(glm::vec3(0.25f), glm::vec3(0.75f)));
}

// The eye is outside: it sees the outer box alone, whatever the cavity holds.
TEST(Solid, ACavityIsHiddenByTheBoxAroundItAndHoldsNothingByItself) {
  test::Soup cavity = soup_of(test::inside_out(box(glm::dvec3(1), glm::dvec3(4))));
  cavity.add(box(glm::dvec3(2), glm::dvec3(3)));
  EXPECT_TRUE(cavity.solid().contains_box(glm::vec3(2), glm::vec3(3)));
  EXPECT_FALSE(cavity.solid().contains_box(glm::vec3(1), glm::vec3(4)));
  cavity.add(box(glm::dvec3(0), glm::dvec3(5)));
  const Solid solid = cavity.solid();
  EXPECT_EQ(solid.parts().size(), 2u);
  EXPECT_EQ(solid.n_inward(), 1u);
  EXPECT_TRUE(solid.contains_box(glm::vec3(0), glm::vec3(5)));
}

TEST(Solid, BoxesThatTouchOrOverlapEachHoldTheirOwn) {
  test::Soup soup = soup_of(box({0, 0, 0}, {1, 1, 1}));
  soup.add(box({1, 0.25, 0.25}, {2, 0.75, 0.75}));     // on a face
  soup.add(box({-0.5, 0.25, 0.25}, {0.5, 0.5, 0.5}));  // half within
  const Solid solid = soup.solid();
  EXPECT_EQ(solid.parts().size(), 3u);
  EXPECT_TRUE(solid.contains_box({0, 0, 0}, {1, 1, 1}));
  EXPECT_TRUE(solid.contains_box({1, 0.25f, 0.25f}, {2, 0.75f, 0.75f}));
  EXPECT_TRUE(solid.contains_box({-0.5f, 0.25f, 0.25f}, {0.5f, 0.5f, 0.5f}));
}

// A face in the middle of a block, twice, once from either side: the block is closed still, but no longer empty.
TEST(Solid, ASheetWithinASolidIsASurface) {
  test::Soup soup = test::l_shape();
  EXPECT_TRUE(soup.solid().contains_box({0, 0, 0}, {3, 1, 1}));
  for (const std::uint32_t i : {1u, 4u, 12u, 12u, 4u, 1u}) soup.indices.push_back(i);
  const Solid solid = soup.solid();
  ASSERT_EQ(solid.parts().size(), 1u);
  EXPECT_FALSE(solid.contains_box({0, 0, 0}, {3, 1, 1}));
  EXPECT_TRUE(solid.contains_box({1, 0, 0}, {3, 1, 1}));
}

TEST(Solid, PointsWithoutVolumeAreInNothing) {
  const Solid solid = soup_of(box({0, 0, 0}, {1, 1, 1})).solid();
  EXPECT_FALSE(solid.contains_hull({}));
  EXPECT_FALSE(solid.contains_hull(std::vector<glm::vec3>(9, glm::vec3(0.5f))));
  EXPECT_FALSE(solid.contains_hull(box_corners({0, 0, 0.5f}, {1, 1, 0.5f})));
  EXPECT_FALSE(solid.contains_box({0, 0, 0}, {1, 1, 0}));
  std::vector<glm::vec3> points = box_corners({0, 0, 0}, {1, 1, 1});
  points.emplace_back(std::numeric_limits<float>::quiet_NaN(), 0.5f, 0.5f);
  EXPECT_FALSE(solid.contains_hull(points));
}

TEST(Solid, BadInputIsNamed) {
  const std::vector<glm::vec3> positions = {{0, 0, 0}, {1, 0, 0}, {0, std::numeric_limits<float>::infinity(), 0}};
  const auto message = [&](const std::vector<std::uint32_t>& indices) -> std::string {
    try {
      (void)Solid(positions, indices);
    } catch (const Error& error) {
      return error.what();
    }
    return "";
  };
  EXPECT_EQ(message({0, 1}), "solid: expected three indices a triangle, found 2 indices");
  EXPECT_EQ(message({0, 1, 3}), "solid: expected index 2 below 3, found 3");
  EXPECT_EQ(message({0, 1, 2}), "solid: expected finite positions, found position 2 not finite");
  EXPECT_EQ(message({0, 0, 1}), "");  // dropped
  EXPECT_EQ(Solid({}, {}).parts().size(), 0u);
}

TEST(Solid, LargestAndSmallestNumbersAreJudgedToo) {
  const float most = std::numeric_limits<float>::max(), least = std::numeric_limits<float>::denorm_min();
  for (const float size : {most, least}) {
    const Solid solid = soup_of(box(glm::dvec3(-size), glm::dvec3(size))).solid();
    EXPECT_TRUE(solid.contains_box(glm::vec3(-size), glm::vec3(size))) << size;
    EXPECT_FALSE(solid.contains_box(glm::vec3(-size), glm::vec3(2 * size)));
  }
}

// A body's planes are tried where rounded numbers say so; touching along faces, edges and at corners must be seen.
TEST(ConvexBody, MissesWhatTouchesItAndNotWhatEnters) {
  const ConvexBody body = ConvexBody::of_box(glm::vec3(0), glm::vec3(1)).value();
  EXPECT_TRUE(body.misses(SpaceTriangle{glm::dvec3(1, 0, 0), {1, 1, 0}, {1, 0, 1}}));      // in a face
  EXPECT_TRUE(body.misses(SpaceTriangle{glm::dvec3(0, 2, 0.5), {2, 0, 0.5}, {2, 2, 0}}));  // across an edge
  EXPECT_TRUE(body.misses(SpaceTriangle{glm::dvec3(1, 1, 1), {2, 1, 0}, {1, 2, 3}}));      // at a corner
  EXPECT_FALSE(body.misses(SpaceTriangle{glm::dvec3(0, 1.99, 0.5), {1.99, 0, 0.5}, {2, 2, 0}}));
  EXPECT_FALSE(body.misses(SpaceTriangle{glm::dvec3(-9, -9, 0.5), {9, -9, 0.5}, {0, 9, 0.5}}));  // cut through
  EXPECT_FALSE(body.misses(SpaceTriangle{glm::dvec3(0.5), {0.5, 0.5, 0.5}, {0.5, 0.5, 9}}));     // a segment
  EXPECT_TRUE(body.misses(SpaceTriangle{glm::dvec3(0, 0, 0), {1, 0, 0}, {2, 0, 0}}));            // along an edge
}

TEST(Solid, NoHullOfARandomModelIsContainedThatSticksOut) {
  int n_contained = 0, n_false = 0;
  for (std::uint64_t i = 0; i < 400; ++i) n_contained += test::hull_case(i, 50, n_false);
  EXPECT_EQ(n_false, 0);
  EXPECT_GT(n_contained, 100);  // or nothing was tried
}

}  // namespace
}  // namespace lode::geometry
