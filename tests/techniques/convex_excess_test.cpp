// How much too much hulls hide, and whom they then may hide.
#include <gtest/gtest.h>

#include "technique_pictures.h"
#include "techniques/convex_culling/convex_culling.h"
#include "techniques/convex_culling/coverage_error.h"
#include "techniques/convex_culling/excess.h"

namespace lode::tests {
namespace {

using namespace techniques::convex_culling;
using techniques::ConvexCulling;

/// A frame of 4 × 4 around a hole of 2 × 2, 0.2 thick, of four boxes, at z; what is on one plane welds.
geometry::Mesh frame(double z) {
  geometry::Mesh mesh;
  for (const auto& [low, high] : {std::pair(glm::dvec3(-2, -2, 0), glm::dvec3(2, -1, 0.2)),
                                  std::pair(glm::dvec3(-2, 1, 0), glm::dvec3(2, 2, 0.2)),
                                  std::pair(glm::dvec3(-2, -1, 0), glm::dvec3(-1, 1, 0.2)),
                                  std::pair(glm::dvec3(1, -1, 0), glm::dvec3(2, 1, 0.2))}) {
    const geometry::Mesh part = geometry::box(low + glm::dvec3(0, 0, z), high + glm::dvec3(0, 0, z));
    for (const std::uint32_t i : part.indices) mesh.indices.push_back(std::uint32_t(mesh.positions.size()) + i);
    mesh.positions.insert(mesh.positions.end(), part.positions.begin(), part.positions.end());
  }
  return mesh;
}

// Along z the frame covers 16 − 4 units, the hull of all of it 16, and the hull of its left bar nothing but the bar:
// 96 lines over 4 units meet the hole 48 times. Along x and y there is no hole, in other directions less of it. The
// hull's silhouette is 16 (x) + 0.8 (y) + 0.8 (z) times the direction: at most √(256 + 0.64 + 0.64) < 16.05.
TEST(Excess, IsWhatAHullCoversBesideTheModelInItsWorstDirection) {
  const geometry::Mesh mesh = frame(0.0);
  const std::vector<glm::vec3> bar(mesh.positions.begin() + 48, mesh.positions.begin() + 72);
  const std::vector<std::vector<glm::vec3>> hulls = {mesh.positions, bar};
  const Excess found = excess(mesh.positions, mesh.indices, hulls);
  EXPECT_NEAR(found.model, 4.0 / 12.0, 1e-12);
  ASSERT_EQ(found.hulls.size(), 2u);
  EXPECT_GE(found.hulls[0], 4.0 / 16.05);
  EXPECT_LE(found.hulls[0], 4.0 / 16.0 + 1e-12);
  EXPECT_NEAR(found.hulls[1], 0.0, 1e-12);
  const std::vector<HullCoverage> along_z = each_coverage(mesh.positions, mesh.indices, hulls, {0, 0, 1}).hulls;
  EXPECT_NEAR(along_z[0].area, 16.0, 1e-12);
  EXPECT_NEAR(along_z[0].over, 4.0, 1e-12);
}

// Through the frame a wall and a ball show, and the frame's hull covers both. The wall's box is the second largest: of
// two occluders it is the other one.
TEST(Excess, KeepsAHullThatHidesTooMuchFromHidingOccludersOrAnything) {
  geometry::Scene scene;
  geometry::add_instance(scene, frame(0.0));
  geometry::add_instance(scene, geometry::box({-0.9, -0.9, -0.4}, {0.9, 0.9, -0.2}));
  geometry::add_instance(scene, geometry::sphere({0.0, 0.0, -0.8}, 0.3, 16, 8));
  const techniques::World world(scene, kRawUnlit, true, 1);
  techniques::View view{.camera = {}, .size_px = {160, 120}};
  geometry::look_at(view.camera, {0.0, 0.0, 10.0}, {0.0, 0.0, 0.0});
  const auto drawn = [&](double hull_excess, double occluder_excess) {
    ConvexCulling::Params params = ConvexCulling::params_for(ConvexCulling::Mode::safe);
    params.least_area_quantile = 0.0;
    params.largest_error = 10.0;
    params.approximation.limits = {8};  // one hull for the frame
    params.slabs.occluders.most = 2;
    params.largest_hull_excess = hull_excess;
    params.largest_occluder_excess = occluder_excess;
    const TechniquePicture picture = Showing(world, ConvexCulling(params)).picture(view);
    return std::vector<bool>{bool(picture.drawn[1]), bool(picture.drawn[2])};
  };
  constexpr double kAny = ConvexCulling::kAny;
  EXPECT_EQ(drawn(kAny, kAny), (std::vector<bool>{false, false}));
  EXPECT_EQ(drawn(kAny, 0.05), (std::vector<bool>{true, false}));
  EXPECT_EQ(drawn(0.05, 0.05), (std::vector<bool>{true, false}));  // the ball is behind the wall as well
}

}  // namespace
}  // namespace lode::tests
