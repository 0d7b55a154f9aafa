/// Objects of a scene: what a technique culls as a whole.

#include "geometry/scene.h"

#include <gtest/gtest.h>

#include "geometry/procedural.h"

namespace lode::geometry {
namespace {

/// Two nodes; the first has two instances, of which the second's material is alpha-tested.
Scene two_nodes() {
  Scene scene;
  Material cut_out;
  cut_out.alpha_mode = AlphaMode::mask;
  add_instance(scene, box({0, 0, 0}, {1, 1, 1}));
  add_instance(scene, box({2, 0, 0}, {3, 1, 1}), cut_out);
  add_instance(scene, box({9, 0, 0}, {10, 1, 1}));
  scene.instances[1].node = 0;
  scene.nodes[0].name = "first";
  scene.nodes[2].name = "second";
  return scene;
}

TEST(SceneObjects, OfASceneThatHasNoneAreTheRunsOfInstancesOfOneNode) {
  EXPECT_EQ(objects_of(two_nodes()), (std::vector<SceneObject>{{"first", 0, 2}, {"second", 2, 1}}));
  EXPECT_TRUE(objects_of(Scene{}).empty());
}

TEST(SceneObjects, AreTheScenesOwnWhereItHasThem) {
  Scene scene = two_nodes();
  scene.objects = {{"all", 0, 3}};
  EXPECT_EQ(objects_of(scene), scene.objects);
}

TEST(SceneObjects, MayOccludeOnlyIfEveryInstanceIsOpaque) {
  const Scene scene = two_nodes();
  const auto objects = objects_of(scene);
  EXPECT_FALSE(may_occlude(scene, objects[0]));
  EXPECT_TRUE(may_occlude(scene, objects[1]));
  EXPECT_FALSE(may_occlude(scene, {"nothing", 0, 0}));
}

TEST(SceneObjects, HaveTheBoundsAndTrianglesOfAllTheirInstances) {
  const Scene scene = two_nodes();
  const Bounds bounds = object_bounds(scene, objects_of(scene)[0]);
  EXPECT_EQ(bounds.low, glm::dvec3(0, 0, 0));
  EXPECT_EQ(bounds.high, glm::dvec3(3, 1, 1));
  EXPECT_EQ(n_triangles(scene, objects_of(scene)[0]), 24u);
}

}  // namespace
}  // namespace lode::geometry
