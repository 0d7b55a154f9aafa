#include "geometry/camera.h"

#include <gtest/gtest.h>

#include <cmath>
#include <glm/geometric.hpp>
#include <limits>

#include "geometry/error.h"
#include "geometry/frustum.h"
#include "geometry/random.h"

namespace lode::geometry {
namespace {

constexpr glm::ivec2 kSize(640, 360);

/// Window position (y down) and depth of a world point.
glm::dvec3 window(const Camera& camera, const glm::dvec3& p_world) {
  const glm::dvec4 clip = clip_from_world(camera, kSize) * glm::dvec4(p_world, 1.0);
  const glm::dvec3 ndc = glm::dvec3(clip) / clip.w;
  return {(ndc.x + 1.0) * 0.5 * kSize.x, (1.0 - ndc.y) * 0.5 * kSize.y, ndc.z};
}

Camera somewhere() {
  Camera camera;
  look_at(camera, {3, 2, 9}, {-1, 0.5, 0});
  camera.near = 0.25;
  return camera;
}

/// The point at view distance d, `right` and `up` half extents off the axis.
glm::dvec3 in_view(const Camera& c, double d, double right, double up) {
  const glm::dvec2 half = half_extent(c, kSize) * (c.projection == Projection::perspective ? d : 1.0);
  return c.eye - d * c.back + right * half.x * c.right + up * half.y * c.up;
}

TEST(Camera, DepthIsNearOverDistanceWithAnInfiniteFarPlane) {
  const Camera c = somewhere();
  for (const double d : {0.25, 1.0, 7.0, 1e6}) EXPECT_NEAR(window(c, in_view(c, d, 0.3, 0.2)).z, 0.25 / d, 1e-14);
}

TEST(Camera, DepthWithAFiniteFarPlaneRunsFromOneToZero) {
  Camera c = somewhere();
  c.far = 50.0;
  for (const double d : {0.25, 1.0, 7.0, 50.0}) {
    EXPECT_NEAR(window(c, in_view(c, d, 0.3, 0.2)).z, 0.25 * (50.0 - d) / (d * (50.0 - 0.25)), 1e-14) << d;
  }
}

TEST(Camera, OrthographicDepthIsLinear) {
  Camera c = somewhere();
  c.projection = Projection::orthographic;
  c.height = 4.0;
  c.near = -2.0;
  c.far = 50.0;
  for (const double d : {-2.0, 0.0, 7.0, 50.0}) {
    EXPECT_NEAR(window(c, in_view(c, d, 0.3, 0.2)).z, (50.0 - d) / 52.0, 1e-14) << d;
  }
}

TEST(Camera, HalfExtentsReachTheEdgesOfThePicture) {
  for (const Projection projection : {Projection::perspective, Projection::orthographic}) {
    Camera c = somewhere();
    c.projection = projection;
    c.far = 100.0;
    const glm::dvec3 upper_right = window(c, in_view(c, 5.0, 1.0, 1.0));
    EXPECT_NEAR(upper_right.x, kSize.x, 1e-9);
    EXPECT_NEAR(upper_right.y, 0.0, 1e-9);
    const glm::dvec3 lower_left = window(c, in_view(c, 5.0, -1.0, -1.0));
    EXPECT_NEAR(lower_left.x, 0.0, 1e-9);
    EXPECT_NEAR(lower_left.y, kSize.y, 1e-9);
  }
}

TEST(Camera, ViewRaysGoThroughWhatTheMatrixProjectsThere) {
  for (const Projection projection : {Projection::perspective, Projection::orthographic}) {
    Camera c = somewhere();
    c.projection = projection;
    c.far = 100.0;
    for (const glm::dvec2 p : {glm::dvec2(0.5, 0.5), glm::dvec2(600.25, 17.75), glm::dvec2(320, 180)}) {
      const ViewRay ray = view_ray(c, kSize, p);
      const glm::dvec3 at = ray.origin + 6.0 * ray.direction;
      const glm::dvec3 hit = window(c, c.eye + at.x * c.right + at.y * c.up + at.z * c.back);
      EXPECT_NEAR(hit.x, p.x, 1e-9);
      EXPECT_NEAR(hit.y, p.y, 1e-9);
      EXPECT_NEAR(-at.z, 6.0, 0.0);  // t is the view distance
    }
  }
}

TEST(Camera, LookingAlongUpStillGivesAFrame) {
  for (const glm::dvec3 up : {glm::dvec3(0, 1, 0), glm::dvec3(0, -1e-300, 0), glm::dvec3(0, 0, 0)}) {
    Camera c;
    look_at(c, {0, 5, 0}, {0, 0, 0}, up);
    EXPECT_EQ(c.back, glm::dvec3(0, 1, 0));
    EXPECT_NEAR(glm::length(c.right), 1.0, 1e-15);
    EXPECT_NEAR(glm::dot(c.right, c.back), 0.0, 1e-15);
    EXPECT_NEAR(glm::length(glm::cross(c.right, c.up) - c.back), 0.0, 1e-15);
  }
}

TEST(Camera, FramingShowsEveryCornerOfTheBox) {
  const Bounds bounds{{-3, 10, 2}, {40, 11, 9}};
  const Camera c = framing_camera(bounds, kSize);
  EXPECT_EQ(c.near, bounds.diagonal() / 1000.0);
  for (int i = 0; i < 8; ++i) {
    const glm::dvec3 corner(i & 1 ? 40 : -3, i & 2 ? 11 : 10, i & 4 ? 9 : 2);
    const glm::dvec3 p = window(c, corner);
    EXPECT_TRUE(p.x > 0 && p.x < kSize.x && p.y > 0 && p.y < kSize.y && p.z > 0 && p.z < 1) << i;
  }
  EXPECT_GT(c.eye.z, 9.0);                // from the front
  EXPECT_GT(c.eye.y, bounds.centre().y);  // above
}

TEST(Camera, OrbitByAFullTurnComesBack) {
  const Camera c = somewhere();
  Camera turned = c;
  for (int i = 0; i < 4; ++i) turned = orbited(turned, {1, 0, 1}, 3.14159265358979323846 / 2);
  EXPECT_NEAR(glm::length(turned.eye - c.eye), 0.0, 1e-13);
  EXPECT_NEAR(glm::length(turned.back - c.back), 0.0, 1e-14);
  // A quarter turn, counter-clockwise from above, takes +x to −z.
  Camera side;
  look_at(side, {5, 0, 0}, {0, 0, 0});
  EXPECT_NEAR(glm::length(orbited(side, {0, 0, 0}, 3.14159265358979323846 / 2).eye - glm::dvec3(0, 0, -5)), 0.0, 1e-14);
}

TEST(Camera, CheckNamesWhatIsWrong) {
  const auto message = [](auto change) {
    Camera c = somewhere();
    change(c);
    try {
      check(c);
    } catch (const Error& error) {
      return std::string(error.what());
    }
    return std::string();
  };
  const double inf = std::numeric_limits<double>::infinity(), nan = std::numeric_limits<double>::quiet_NaN();
  EXPECT_EQ(message([](Camera&) {}), "");
  EXPECT_NE(message([](Camera& c) { c.near = 0.0; }).find("near"), std::string::npos);
  EXPECT_NE(message([](Camera& c) { c.far = c.near; }).find("far"), std::string::npos);
  EXPECT_NE(message([&](Camera& c) { c.far = nan; }).find("far"), std::string::npos);
  EXPECT_NE(message([&](Camera& c) { c.tan_half_fov_y = inf; }).find("field of view"), std::string::npos);
  EXPECT_NE(message([&](Camera& c) { c.eye.y = nan; }).find("eye"), std::string::npos);
  EXPECT_NE(message([](Camera& c) { c.projection = Projection::orthographic; }).find("far"), std::string::npos);
  Camera c;
  EXPECT_THROW(look_at(c, {1, 2, 3}, {1, 2, 3}), Error);
}

TEST(Frustum, DropsABoxOnlyIfNoPointOfItIsInTheView) {
  const Camera c = somewhere();
  const glm::dmat4 m = clip_from_world(c, kSize);
  const Frustum f = frustum(m);
  int dropped = 0;
  for (std::uint64_t i = 0; i < 3000; ++i) {
    Random random(1, 9, i);
    Bounds box;
    for (int k = 0; k < 2; ++k) box.add({random.uniform(-20, 20), random.uniform(-20, 20), random.uniform(-20, 20)});
    if (!is_outside(f, box)) continue;
    ++dropped;
    for (int k = 0; k < 30; ++k) {
      const glm::dvec3 t(random.uniform(), random.uniform(), random.uniform());
      const glm::dvec4 p = m * glm::dvec4(box.low + t * (box.high - box.low), 1.0);
      EXPECT_FALSE(std::fabs(p.x) <= p.w && std::fabs(p.y) <= p.w && p.z <= p.w && p.z >= 0.0 && p.w > 0.0);
    }
  }
  EXPECT_GT(dropped, 300);
  EXPECT_TRUE(is_outside(f, Bounds{}));
  Bounds point;
  point.add(in_view(c, 5.0, 0.999, 0.999));
  EXPECT_FALSE(is_outside(f, point));
  Bounds beside;
  beside.add(in_view(c, 5.0, 1.001, 0.0));
  EXPECT_TRUE(is_outside(f, beside));
}

}  // namespace
}  // namespace lode::geometry
