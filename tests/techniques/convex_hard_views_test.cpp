// Convex culling where projections go wrong: eyes inside hulls, hulls and boxes that reach through the near plane.
#include <gtest/gtest.h>

#include "technique_pictures.h"
#include "techniques/convex_culling/convex_culling.h"

namespace lode::tests {
namespace {

using techniques::ConvexCulling;
using Mode = ConvexCulling::Mode;
using techniques::View;
using techniques::World;

View view_from(const glm::dvec3& eye, const glm::dvec3& at) {
  View view{.camera = {}, .size_px = {160, 120}};
  geometry::look_at(view.camera, eye, at);
  return view;
}

/// One hull for each model, whatever its error, and no angle limit.
TechniquePicture picture_of(const World& world, Mode mode, const View& view) {
  ConvexCulling::Params params = ConvexCulling::params_for(mode);
  params.least_area_quantile = 0.0;
  params.largest_error = 10.0;
  params.approximation.limits = {26};
  params.slabs.angle_limit_deg = 180.0;
  params.slabs.occluders.most = 1;
  return Showing(world, ConvexCulling(params)).picture(view);
}

constexpr Mode kModes[] = {Mode::literal, Mode::safe, Mode::conservative};

// The eye stands in the hole of a ring, in its hull but not in the ring, and sees a ball beyond it.
TEST(ConvexHardViews, FromInsideAHullHidesNothing) {
  geometry::Scene scene;
  geometry::add_instance(scene, geometry::torus(glm::dvec3(0.0), 3.0, 0.5, 24, 12));
  geometry::add_instance(scene, geometry::sphere({0.0, 0.0, -9.0}, 0.4, 16, 8));
  const World world(scene, kRawUnlit, true, 1);
  const View view = view_from({0.0, 0.1, 0.0}, {0.0, 0.0, -9.0});
  for (const Mode mode : kModes) EXPECT_TRUE(picture_of(world, mode, view).drawn[1]) << int(mode);
}

// A long block from in front of the eye to behind it, one unit to the eye's left: its hull crosses the near plane, and
// what lies in front of that hides the ball on the block's other side. The ball is beside the block, not behind all of
// it: only the literal mode takes that for hidden.
TEST(ConvexHardViews, AHullThroughTheNearPlaneHidesWithWhatIsInFrontOfIt) {
  geometry::Scene scene;
  geometry::add_instance(scene, geometry::box({-1.0, -3.0, 0.0}, {1.0, 3.0, 12.0}));
  geometry::add_instance(scene, geometry::sphere({-3.0, 0.0, 5.0}, 0.4, 16, 8));
  const World world(scene, kRawUnlit, true, 1);
  const View view = view_from({2.0, 0.0, 10.0}, {-3.0, 0.0, 5.0});
  const TechniquePicture whole = Showing(world, techniques::Plain{}).picture(view);
  for (const Mode mode : kModes) {
    const TechniquePicture picture = picture_of(world, mode, view);
    EXPECT_EQ(picture.drawn[1], mode != Mode::literal) << int(mode);
    EXPECT_EQ(raster::test::first_difference(picture.image, whole.image), "") << int(mode);
  }
}

// Behind the wall on the screen, but reaching to the eye: its box cannot be projected.
TEST(ConvexHardViews, WhatReachesThroughTheNearPlaneIsDrawn) {
  geometry::Scene scene;
  geometry::add_instance(scene, geometry::box({-30.0, -30.0, 0.0}, {30.0, 30.0, 0.5}));
  geometry::add_instance(scene, geometry::box({-0.2, -0.2, -9.0}, {0.2, 0.2, 10.5}));
  const World world(scene, kRawUnlit, true, 1);
  const View view = view_from({0.0, 0.0, 10.0}, glm::dvec3(0.0));
  for (const Mode mode : kModes) EXPECT_TRUE(picture_of(world, mode, view).drawn[1]) << int(mode);
}

// Nothing, single triangles, flat sheets and heaps of the same point, all of them candidates.
TEST(ConvexHardViews, ModelsThatAreNoSolidsAreDrawn) {
  geometry::Scene scene;
  const auto add = [&](std::vector<glm::vec3> positions, std::vector<std::uint32_t> indices) {
    geometry::Mesh mesh;
    mesh.positions = std::move(positions);
    mesh.indices = std::move(indices);
    geometry::add_instance(scene, mesh);
  };
  add({}, {});
  add({{-1, -1, 0}, {1, -1, 0}, {0, 1, 0}}, {0, 1, 2});
  add({{-1, -1, 1}, {1, -1, 1}, {1, 1, 1}, {-1, 1, 1}}, {0, 1, 2, 0, 2, 3});
  add({{2, 2, 2}, {2, 2, 2}, {2, 2, 2}}, {0, 1, 2, 0, 1, 2});
  add({{-2, -2, 2}, {2, -2, 2}, {0, 2, 2}, {0, 0, 4}, {0, 0, -4}}, {0, 1, 2, 0, 1, 3, 0, 1, 4, 0, 1, 2});
  const World world(scene, kRawUnlit, true, 1);
  const View view = view_from({0.0, 0.0, 10.0}, glm::dvec3(0.0));
  const TechniquePicture whole = Showing(world, techniques::Plain{}).picture(view);
  for (const Mode mode : kModes) {
    EXPECT_EQ(raster::test::first_difference(picture_of(world, mode, view).image, whole.image), "") << int(mode);
  }
}

}  // namespace
}  // namespace lode::tests
