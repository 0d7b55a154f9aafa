/// Scenes of real models: what stands in them stands on the floor and apart, and their walks meet nothing. They need
/// the folder that LODESTONE_ASSETS names.

#include <gtest/gtest.h>

#include <algorithm>
#include <cstdlib>
#include <filesystem>
#include <glm/vector_relational.hpp>

#include "geometry/procedural/kit_scenes.h"
#include "geometry/viewpoints.h"

namespace lode::geometry {
namespace {

bool inside(const Bounds& box, const glm::dvec3& p) {
  return glm::all(glm::greaterThan(p, box.low)) && glm::all(glm::lessThan(p, box.high));
}

bool begins(const std::string& name, std::initializer_list<const char*> with) {
  return std::any_of(with.begin(), with.end(), [&](const char* w) { return name.starts_with(w); });
}

class KitScenes : public testing::Test {
 protected:
  void SetUp() override {
    const char* root = std::getenv("LODESTONE_ASSETS");
    if (root == nullptr || !std::filesystem::exists(std::string(root) + "/kits")) {
      GTEST_SKIP() << "LODESTONE_ASSETS names no folder with kits/ in it";
    }
    assets_ = root;
  }

  /// Frames of the first path whose eye is in the box of an object; what is hollow is not asked.
  static void expect_free_path(const Scene& scene, std::initializer_list<const char*> hollow) {
    const CameraPath& path = scene.paths.at(0);
    EXPECT_EQ(path.n_frames, 600);
    for (const SceneObject& object : scene.objects) {
      if (begins(object.name, hollow)) continue;
      const Bounds box = object_bounds(scene, object);
      for (int k = 0; k < path.n_frames; k += 5) {
        EXPECT_FALSE(inside(box, camera_at(path, k).eye)) << object.name << " at frame " << k;
      }
    }
  }

  static void expect_apart(const Scene& scene, std::initializer_list<const char*> kinds, double overlap_m = 0.02) {
    std::vector<std::pair<std::string, Bounds>> boxes;
    for (const SceneObject& object : scene.objects) {
      if (begins(object.name, kinds)) boxes.emplace_back(object.name, object_bounds(scene, object));
    }
    for (std::size_t a = 0; a < boxes.size(); ++a) {
      for (std::size_t b = 0; b < a; ++b) {
        const Bounds &p = boxes[a].second, &q = boxes[b].second;
        const bool apart =
            glm::any(glm::lessThan(p.high - overlap_m, q.low)) || glm::any(glm::lessThan(q.high - overlap_m, p.low));
        EXPECT_TRUE(apart) << boxes[a].first << " and " << boxes[b].first;
      }
    }
  }

  std::string assets_;
};

TEST_F(KitScenes, TheCityHasHundredsOfModelsApartAndAFreeStreet) {
  const Scene scene = kit_city(assets_ + "/kits/kaykit-city/gltf", 1);
  EXPECT_GT(scene.objects.size(), 350u);
  EXPECT_EQ(scene.pictures.size(), 1u);  // the kit's one picture is kept once
  EXPECT_GE(scene.bounds().low.y, -0.01);
  expect_apart(scene, {"building"}, 0.1);  // terraces: their cornices touch
  expect_apart(scene, {"car", "bench", "dumpster", "bush", "box", "trash", "firehydrant"});
  expect_free_path(scene, {"road"});
  EXPECT_EQ(random_viewpoints(scene, 1, 50).size(), 50u);
}

TEST_F(KitScenes, TheDungeonHasHundredsOfModelsAndFreeDoorways) {
  const Scene scene = kit_dungeon(assets_ + "/kits/kaykit-dungeon/glb", 1);
  EXPECT_GT(scene.objects.size(), 400u);
  expect_free_path(scene, {"wall_doorway", "floor"});
  expect_apart(scene, {"barrel", "box", "chest", "bed", "table", "keg", "trunk"});
  EXPECT_EQ(random_viewpoints(scene, 1, 50).size(), 50u);
}

TEST_F(KitScenes, TheRoomsAreFurnishedAndTheirDoorsFree) {
  const Scene scene = kit_rooms(assets_ + "/kits/kaykit-furniture/gltf", assets_ + "/furniture-cc0", 1);
  EXPECT_GT(scene.objects.size(), 160u);
  expect_free_path(scene, {"partition", "shell"});
  expect_apart(scene, {"bookcase", "cabinet", "couch", "armchair", "bed", "cactus", "table_low", "lamp_standing",
                       "pool", "oakTable", "wardrobe"});
  EXPECT_EQ(random_viewpoints(scene, 1, 50).size(), 50u);
}

}  // namespace
}  // namespace lode::geometry
