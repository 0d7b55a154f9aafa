/// The town and the interior are exact whatever the seed: building them throws if a count is not.

#include <gtest/gtest.h>

#include <glm/vector_relational.hpp>

#include "geometry/procedural/interior.h"
#include "geometry/procedural/town.h"
#include "geometry/viewpoints.h"

namespace lode::geometry {
namespace {

TEST(TownStress, EverySeedGivesTheExactCountsAndAFreePath) {
  for (const std::uint64_t seed : {0ull, 2ull, 3ull, 4ull, 5ull, 6ull, 7ull, 8ull, 99ull, 12345ull, 1ull << 53}) {
    const Scene scene = town(seed);
    EXPECT_EQ(scene.objects.size(), kTownModels) << seed;
    for (const SceneObject& object : scene.objects) {
      if (!may_occlude(scene, object)) continue;  // under the crown of a tree is free
      const Bounds box = object_bounds(scene, object);
      for (int k = 0; k < 800; k += 10) {
        const glm::dvec3 eye = camera_at(scene.paths[0], k).eye;
        const bool inside = glm::all(glm::greaterThan(eye, box.low)) && glm::all(glm::lessThan(eye, box.high));
        EXPECT_FALSE(inside) << object.name << " of seed " << seed << " at frame " << k;
      }
    }
    EXPECT_EQ(random_viewpoints(scene, seed, 100).size(), 100u) << seed;
  }
}

TEST(InteriorStress, EverySeedGivesTheExactCountsAndAFreePath) {
  for (const std::uint64_t seed : {0ull, 2ull, 3ull, 4ull, 5ull, 6ull, 7ull, 8ull, 99ull, 12345ull, 1ull << 53}) {
    const Scene scene = interior(seed);
    EXPECT_EQ(scene.objects.size(), kInteriorModels) << seed;
    EXPECT_EQ(random_viewpoints(scene, seed, 100).size(), 100u) << seed;
  }
}

}  // namespace
}  // namespace lode::geometry
