/// Hulls on the screen, cut at the near plane.

#include "geometry/projected_hull.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <limits>

#include "geometry/camera.h"

namespace lode::geometry {
namespace {

/// From the origin along −z, 90° wide and high, near 1: a point at view distance d and x is at pixel 50 + 50·x/d.
glm::dmat4 simple_clip(Projection projection = Projection::perspective) {
  Camera camera;
  camera.tan_half_fov_y = 1.0;
  camera.near = 1.0;
  camera.projection = projection;
  if (projection == Projection::orthographic) camera.height = 2.0, camera.far = 11.0;
  return clip_from_world(camera, {100, 100});
}

Bounds box(const glm::dvec3& low, const glm::dvec3& high) {
  Bounds result;
  result.add(low);
  result.add(high);
  return result;
}

TEST(ProjectedHull, GivesPixelsAndWrittenDepths) {
  // A box from 2 to 4 before the eye, from x = 0 to 1 and y = 0 to 1: the near face is 25 px wide; depth is n/d.
  const ProjectedHull hull = project_hull(corners(box({0, 0, -4}, {1, 1, -2})), simple_clip(), {100, 100});
  EXPECT_EQ(hull.near_plane, NearPlane::in_front);
  ASSERT_EQ(hull.points_px.size(), 8u);
  EXPECT_NEAR(hull.nearest_depth, 0.5, 1e-15);
  EXPECT_NEAR(hull.farthest_depth, 0.25, 1e-15);
  double right = 0.0, top = 100.0;
  for (const glm::dvec2& p : hull.points_px) right = std::max(right, p.x), top = std::min(top, p.y);
  EXPECT_NEAR(right, 75.0, 1e-12);
  EXPECT_NEAR(top, 25.0, 1e-12);
}

TEST(ProjectedHull, OrthographicDepthsFallEvenly) {
  const ProjectedHull hull =
      project_hull(corners(box({0, 0, -6}, {1, 1, -1})), simple_clip(Projection::orthographic), {100, 100});
  EXPECT_NEAR(hull.nearest_depth, 1.0, 1e-15);
  EXPECT_NEAR(hull.farthest_depth, 0.5, 1e-15);
}

TEST(ProjectedHull, IsCutAtTheNearPlane) {
  // From 4 before to 2 behind the eye: cut at d = 1, where x = 1 is at the right border.
  const ProjectedHull hull = project_hull(corners(box({0, 0, -4}, {1, 1, 2})), simple_clip(), {100, 100});
  EXPECT_EQ(hull.near_plane, NearPlane::crosses);
  EXPECT_NEAR(hull.nearest_depth, 1.0, 1e-12);
  double right = 0.0;
  for (const glm::dvec2& p : hull.points_px) right = std::max(right, p.x);
  EXPECT_NEAR(right, 100.0, 1e-9);
}

TEST(ProjectedHull, BehindTheNearPlaneThereIsNothing) {
  const ProjectedHull hull = project_hull(corners(box({0, 0, -0.5}, {1, 1, 2})), simple_clip(), {100, 100});
  EXPECT_EQ(hull.near_plane, NearPlane::behind);
  EXPECT_TRUE(hull.points_px.empty());
}

TEST(ProjectedHull, WhatIsNotFiniteCrosses) {
  const glm::vec3 points[] = {{0, 0, -4}, {std::numeric_limits<float>::infinity(), 0, -4}};
  const ProjectedHull hull = project_hull(points, simple_clip(), {100, 100});
  EXPECT_EQ(hull.near_plane, NearPlane::crosses);
  EXPECT_TRUE(hull.points_px.empty());
}

TEST(ProjectedHull, ABoxKeepsAllOfItselfInFloats) {
  const Bounds exact = box({0.1, -0.1, 1.0 / 3.0}, {0.7, 1e-60, 5.0});
  for (const glm::vec3& p : corners(exact)) {
    for (int axis = 0; axis < 3; ++axis) {
      EXPECT_TRUE(double(p[axis]) <= exact.low[axis] || double(p[axis]) >= exact.high[axis]);
    }
  }
}

}  // namespace
}  // namespace lode::geometry
