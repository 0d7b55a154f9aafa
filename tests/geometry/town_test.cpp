/// The town and the interior have exactly the models and triangles that they say, of closed parts, and their walks
/// stay in free air.

#include "geometry/procedural/town.h"

#include <gtest/gtest.h>

#include <bit>
#include <cmath>
#include <glm/geometric.hpp>
#include <glm/vector_relational.hpp>

#include "geometry/procedural/interior.h"
#include "geometry/procedural/room_walls.h"
#include "geometry/procedural/town_plan.h"
#include "geometry/viewpoints.h"
#include "tests/geometry/mesh_parts.h"

namespace lode::geometry {
namespace {

/// Made once for all tests: a town costs most of what they cost.
const Scene& the_town() {
  static const Scene scene = town(1);
  return scene;
}
const Scene& the_interior() {
  static const Scene scene = interior(1);
  return scene;
}

std::size_t total_triangles(const Scene& scene) {
  std::size_t n = 0;
  for (const SceneObject& object : scene.objects) n += n_triangles(scene, object);
  return n;
}

/// Of the objects whose names begin so: how many, and their triangles.
struct Kind {
  std::size_t objects = 0, triangles = 0;
  friend bool operator==(const Kind&, const Kind&) = default;
};
Kind kind(const Scene& scene, std::string_view name) {
  Kind k;
  for (const SceneObject& object : scene.objects) {
    if (!object.name.starts_with(name)) continue;
    ++k.objects;
    k.triangles += n_triangles(scene, object);
  }
  return k;
}

void expect_objects_tile_instances(const Scene& scene) {
  std::uint32_t next = 0;
  for (const SceneObject& object : scene.objects) {
    EXPECT_EQ(object.first_instance, next) << object.name;
    EXPECT_GT(object.n_instances, 0u) << object.name;
    next += object.n_instances;
  }
  EXPECT_EQ(next, scene.instances.size());
}

bool inside(const Bounds& box, const glm::dvec3& p) {
  return glm::all(glm::greaterThan(p, box.low)) && glm::all(glm::lessThan(p, box.high));
}

/// FNV-1a over positions, indices and places: a scene's geometry to the bit.
std::uint64_t hash_of(const Scene& scene) {
  std::uint64_t hash = 14695981039346656037u;
  const auto add = [&](std::uint64_t word) { hash = (hash ^ word) * 1099511628211u; };
  for (const Mesh& mesh : scene.meshes) {
    for (const glm::vec3& p : mesh.positions) {
      for (int k = 0; k < 3; ++k) add(std::bit_cast<std::uint32_t>(p[k]));
    }
    for (const std::uint32_t index : mesh.indices) add(index);
  }
  for (const Instance& instance : scene.instances) {
    for (int c = 0; c < 4; ++c) {
      for (int r = 0; r < 4; ++r) add(std::bit_cast<std::uint64_t>(instance.world_from_object[c][r]));
    }
  }
  return hash;
}

TEST(Town, Has179ModelsAnd973103TrianglesKindByKind) {
  const Scene& scene = the_town();
  EXPECT_EQ(scene.objects.size(), 179u);
  EXPECT_EQ(total_triangles(scene), 973103u);
  EXPECT_EQ(kind(scene, "building"), (Kind{70, 420000}));
  EXPECT_EQ(kind(scene, "car"), (Kind{40, 220000}));
  EXPECT_EQ(kind(scene, "tree"), (Kind{45, 225000}));
  EXPECT_EQ(kind(scene, "ground"), (Kind{1, 4511}));
  expect_objects_tile_instances(scene);
}

TEST(Interior, Has124ModelsAnd629336TrianglesKindByKind) {
  const Scene& scene = the_interior();
  EXPECT_EQ(scene.objects.size(), 124u);
  EXPECT_EQ(total_triangles(scene), 629336u);
  EXPECT_EQ(kind(scene, "table"), (Kind{12, 12 * 3948}));
  EXPECT_EQ(kind(scene, "chair"), (Kind{48, 48 * 4617}));
  EXPECT_EQ(kind(scene, "sofa"), (Kind{10, 10 * 9280}));
  EXPECT_EQ(kind(scene, "partition").objects + kind(scene, "shell").objects, 6u);
  expect_objects_tile_instances(scene);
}

// 6 · 60 m of blocks, 5 streets between and 2 around of 12 m: 444 m; 5 · 60 + 6 · 12 = 372 m. Buildings reach 9 to 48
// m.
TEST(Town, SpansItsBlocksAndStreets) {
  const Bounds bounds = the_town().bounds();
  EXPECT_EQ(bounds.low.x, -222.0);
  EXPECT_EQ(bounds.high.x, 222.0);
  EXPECT_EQ(bounds.low.z, -186.0);
  EXPECT_EQ(bounds.high.z, 186.0);
  EXPECT_EQ(bounds.low.y, 0.0);
  EXPECT_GT(bounds.high.y, 36.0);
  EXPECT_LT(bounds.high.y, 48.0);
}

TEST(Town, BuildingsAndCarsAreClosedAndFaceOutwards) {
  for (const SceneObject& object : the_town().objects) {
    if (object.name != "building 0" && object.name != "building 5" && object.name != "car 0") continue;
    const PartCounts parts = count_parts(welded(the_town(), object));
    EXPECT_GT(parts.closed_outwards, 10) << object.name;
    EXPECT_EQ(parts.closed_inwards, 0) << object.name;
    EXPECT_EQ(parts.open, 0) << object.name;
  }
}

TEST(Interior, FurnitureIsClosedAndFacesOutwards) {
  for (const char* name : {"bookcase", "cupboard", "lamp", "partition"}) {
    for (const SceneObject& object : the_interior().objects) {
      if (!object.name.starts_with(name)) continue;
      const PartCounts parts = count_parts(welded(the_interior(), object));
      EXPECT_GE(parts.closed_outwards, 3) << object.name;
      EXPECT_EQ(parts.closed_inwards + parts.open, 0) << object.name;
      break;
    }
  }
}

TEST(Scenes, TreesAndPlantsMayNotOccludeAndAllElseMay) {
  for (const Scene* scene : {&the_town(), &the_interior()}) {
    for (const SceneObject& object : scene->objects) {
      const bool leafy = object.name.starts_with("tree") || object.name.starts_with("plant");
      EXPECT_EQ(may_occlude(*scene, object), !leafy) << object.name;
    }
  }
}

// Pinned: the same seed gives the same bits on every machine, by every compiler, in every build type.
TEST(Scenes, AreFunctionsOfTheirSeedToTheBit) {
  EXPECT_EQ(hash_of(the_town()), 17131892748713431671u);
  EXPECT_EQ(hash_of(the_interior()), 10216573307175865117u);
  EXPECT_NE(hash_of(interior(2)), hash_of(the_interior()));
}

TEST(Town, NoModelStandsInAnother) {
  const Scene& scene = the_town();
  std::vector<std::pair<std::string, Bounds>> boxes;
  for (const SceneObject& object : scene.objects) {
    if (object.name != "ground" && !object.name.starts_with("tree")) {
      boxes.emplace_back(object.name, object_bounds(scene, object));
    }
  }
  for (std::size_t a = 0; a < boxes.size(); ++a) {
    for (std::size_t b = 0; b < a; ++b) {
      const Bounds &p = boxes[a].second, &q = boxes[b].second;
      const bool apart = glm::any(glm::lessThanEqual(p.high, q.low)) || glm::any(glm::lessThanEqual(q.high, p.low));
      EXPECT_TRUE(apart) << boxes[a].first << " and " << boxes[b].first;
    }
  }
}

TEST(Town, TheStreetPathStaysInTheStreetsAndOutOfEveryModel) {
  const Scene& scene = the_town();
  const CameraPath& path = scene.paths.at(0);
  EXPECT_EQ(path.name, "street");
  EXPECT_EQ(path.n_frames, 800);
  std::vector<Bounds> models;
  for (const SceneObject& object : scene.objects) models.push_back(object_bounds(scene, object));
  for (int k = 0; k < path.n_frames; k += 4) {
    const glm::dvec3 eye = camera_at(path, k).eye;
    EXPECT_NEAR(eye.y, 1.7, 1e-9);
    for (std::size_t m = 0; m < models.size(); ++m) {
      const bool leafy = !may_occlude(scene, scene.objects[m]);  // under the crown of a tree is free
      EXPECT_TRUE(leafy || !inside(models[m], eye)) << scene.objects[m].name << " at frame " << k;
    }
  }
}

TEST(Interior, ThePathGoesFromTheFirstRoomToTheLastThroughDoors) {
  const CameraPath& path = the_interior().paths.at(0);
  EXPECT_EQ(path.n_frames, 600);
  const auto room = [](const glm::dvec3& p) {
    return glm::ivec2(int(std::floor(p.x / kRoomX + 0.5 * kRoomsX)), int(std::floor(p.z / kRoomZ + 0.5 * kRoomsZ)));
  };
  EXPECT_EQ(room(camera_at(path, 0).eye), glm::ivec2(0, 0));
  EXPECT_EQ(room(camera_at(path, 599).eye), glm::ivec2(3, 2));
  int doors = 0;
  for (int k = 1; k < 600; ++k) {
    const glm::dvec3 from = camera_at(path, k - 1).eye, to = camera_at(path, k).eye;
    const glm::ivec2 a = room(from), b = room(to);
    if (a == b) continue;
    ++doors;
    // The door's middle is kDoorOffset beside the wall's; half its width to either side, less a shoulder's 0.2 m.
    const bool east = a.x != b.x;
    const double along = east ? to.z : to.x, size = east ? kRoomZ : kRoomX;
    const double from_middle = along - size * (std::floor(along / size + (east ? 0.5 : 0.0)) + (east ? 0.0 : 0.5));
    EXPECT_NEAR(from_middle, kDoorOffset, 0.3) << k;
  }
  EXPECT_EQ(doors, 11);  // between 12 rooms in a row
}

TEST(Interior, ThePathMeetsNoFurniture) {
  const Scene& scene = the_interior();
  const CameraPath& path = scene.paths.at(0);
  for (const SceneObject& object : scene.objects) {
    if (object.name.starts_with("partition") || object.name == "shell") continue;
    const Bounds box = object_bounds(scene, object);
    for (int k = 0; k < path.n_frames; k += 3) {
      EXPECT_FALSE(inside(box, camera_at(path, k).eye)) << object.name << " at frame " << k;
    }
  }
}

TEST(Viewpoints, AreInFreeSpaceAndAFunctionOfTheSeedAndTheirNumber) {
  const Scene& scene = the_interior();
  const std::vector<Camera> few = random_viewpoints(scene, 7, 20), many = random_viewpoints(scene, 7, 40);
  const std::vector<Camera> others = random_viewpoints(scene, 8, 20);
  for (std::size_t k = 0; k < few.size(); ++k) {
    EXPECT_EQ(few[k].eye, many[k].eye);
    EXPECT_EQ(few[k].back, many[k].back);
    EXPECT_NE(few[k].eye, others[k].eye);
  }
  for (const Camera& camera : many) {
    EXPECT_TRUE(camera.eye.y > 1.2 && camera.eye.y < 1.9);
    for (const SceneObject& object : scene.objects) {
      EXPECT_TRUE(object.name == "shell" || !inside(object_bounds(scene, object), camera.eye)) << object.name;
    }
  }
}

}  // namespace
}  // namespace lode::geometry
