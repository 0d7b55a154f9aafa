/// Walks go at constant speed and look where they go.

#include "geometry/camera_path.h"

#include <gtest/gtest.h>

#include <glm/geometric.hpp>

#include "geometry/error.h"

namespace lode::geometry {
namespace {

const CameraPath kCorner = {"corner", {{0, 1, 0}, {6, 1, 0}, {6, 1, 4}}, 11, 2.0};

// 6 + 4 long in ten steps: one a frame; the corner is frame 6.
TEST(CameraPath, FramesAreEquallyFarApartAlongThePath) {
  EXPECT_EQ(length(kCorner), 10.0);
  for (int k = 0; k <= 10; ++k) {
    const glm::dvec3 expected = k <= 6 ? glm::dvec3(k, 1, 0) : glm::dvec3(6, 1, k - 6);
    EXPECT_LT(glm::distance(camera_at(kCorner, k).eye, expected), 1e-12) << k;
  }
}

// At frame 5, at (5, 1, 0), the point 2 further on is (6, 1, 1): the view goes along (1, 0, 1).
TEST(CameraPath, LooksAtWhereItWillBe) {
  const Camera camera = camera_at(kCorner, 5);
  EXPECT_LT(glm::distance(-camera.back, glm::normalize(glm::dvec3(1, 0, 1))), 1e-12);
  EXPECT_LT(glm::distance(-camera_at(kCorner, 0).back, glm::dvec3(1, 0, 0)), 1e-12);
  EXPECT_LT(glm::distance(-camera_at(kCorner, 10).back, glm::dvec3(0, 0, 1)), 1e-12);  // straight on at the end
}

// Vertical field of view 60°: tan 30° = 1/√3.
TEST(CameraPath, HasAFieldOfViewOf60Degrees) {
  const Camera camera = camera_at(kCorner, 3);
  EXPECT_DOUBLE_EQ(camera.tan_half_fov_y, 0.57735026918962576);
  EXPECT_EQ(camera.near, 0.1);
  EXPECT_EQ(camera.far, std::numeric_limits<double>::infinity());
}

TEST(CameraPath, RoundedCornersStayWithinTheRadiusOfTheCorner) {
  const std::vector<glm::dvec3> round = rounded_corners(kCorner.points, 1.5);
  ASSERT_EQ(round.size(), 11u);  // two ends and nine points of the curve
  EXPECT_EQ(round.front(), kCorner.points.front());
  EXPECT_EQ(round[1], glm::dvec3(4.5, 1, 0));
  EXPECT_EQ(round[9], glm::dvec3(6, 1, 1.5));
  EXPECT_EQ(round[5], glm::dvec3(5.625, 1, 0.375));  // the parabola's middle: 1/4, 1/2, 1/4 of the three points
}

TEST(CameraPath, RefusesWhatIsNoPath) {
  EXPECT_THROW((void)camera_at(kCorner, 11), Error);
  EXPECT_THROW((void)camera_at(kCorner, -1), Error);
  EXPECT_THROW((void)camera_at({"point", {{0, 0, 0}}, 10, 1.0}, 0), Error);
  EXPECT_THROW((void)camera_at({"still", {{0, 0, 0}, {1, 0, 0}}, 1, 1.0}, 0), Error);
}

}  // namespace
}  // namespace lode::geometry
