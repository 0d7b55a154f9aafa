// Houses of any number of triangles, and the streets that they stand in.
#include "geometry/procedural/houses.h"

#include <gtest/gtest.h>

#include <glm/geometric.hpp>
#include <map>
#include <tuple>
#include <utility>

#include "geometry/error.h"
#include "geometry/procedural/house.h"

namespace lode::geometry {
namespace {

TEST(House, OfEveryKindHasAsManyTrianglesAsSaid) {
  for (int k = 0; k < 6; ++k) {
    for (const std::size_t n : {kFewestHouseTriangles, std::size_t(1002), std::size_t(4000), std::size_t(16000)}) {
      EXPECT_EQ(n_triangles(house(house_plan(k), n)), n) << k;
    }
    EXPECT_THROW(static_cast<void>(house(house_plan(k), 4001)), Error);
    EXPECT_THROW(static_cast<void>(house(house_plan(k), kFewestHouseTriangles - 2)), Error);
  }
}

/// All parts are blocks and a roof, whose edges have a triangle on either side, the other way round.
TEST(House, IsMadeOfClosedPartsThatFaceOutwards) {
  using Point = std::tuple<float, float, float>;
  for (int k = 0; k < 6; ++k) {
    std::map<std::pair<Point, Point>, int> edges;
    double volume = 0.0;
    for (const ModelSurface& s : house(house_plan(k), 6000).surfaces) {
      const auto& p = s.mesh.positions;
      for (std::size_t i = 0; i < s.mesh.indices.size(); i += 3) {
        const std::uint32_t* v = &s.mesh.indices[i];
        volume += glm::dot(glm::dvec3(p[v[0]]), glm::cross(glm::dvec3(p[v[1]]), glm::dvec3(p[v[2]]))) / 6.0;
        for (int e = 0; e < 3; ++e) {
          const glm::vec3 a = p[v[e]], b = p[v[(e + 1) % 3]];
          ++edges[{{a.x, a.y, a.z}, {b.x, b.y, b.z}}];
          --edges[{{b.x, b.y, b.z}, {a.x, a.y, a.z}}];
        }
      }
    }
    for (const auto& [edge, n] : edges) ASSERT_EQ(n, 0) << k;
    const HousePlan plan = house_plan(k);
    EXPECT_GT(volume, plan.width_m * plan.depth_m * 2.8 * plan.n_floors) << k;  // of the walls' block and more
  }
}

TEST(House, UsesUpItsTrianglesForWhatIsSeen) {
  for (int k = 0; k < 6; ++k) {
    // What is left over is split off the plinth's block of 12: less than a row of tiles, or the smallest kind of
    // detail.
    for (const ModelSurface& s : house(house_plan(k), 16000).surfaces) {
      if (s.material.name != "house stone") continue;
      EXPECT_LT(s.mesh.indices.size() / 3, 16000u / 20u) << k;
    }
  }
}

TEST(Houses, StandInRowsWithTwoWalks) {
  const Scene scene = houses({.n_rows = 2, .n_in_row = 12, .n_each = 1000, .seed = 3});
  ASSERT_EQ(scene.objects.size(), 25u);  // and the ground
  std::size_t n = 0;
  for (const SceneObject& object : scene.objects) n += n_triangles(scene, object);
  EXPECT_EQ(n, 24u * 1000u + 2u);
  ASSERT_EQ(scene.paths.size(), 2u);
  const CameraPath &approach = scene.paths[0], &sideways = scene.paths[1];
  // 16 m from house to house: the first ones end at 96.
  EXPECT_EQ(camera_at(approach, 0).eye, glm::dvec3(136.0, 1.7, 0.0));
  EXPECT_NEAR(camera_at(approach, 1000).eye.x, 296.0, 0.2);
  EXPECT_EQ(camera_at(approach, 1999).eye, glm::dvec3(136.0, 1.7, 0.0));
  EXPECT_EQ(camera_at(sideways, 0).eye, glm::dvec3(-60.0, 1.7, 80.0));
  EXPECT_EQ(camera_at(sideways, 1999).eye, glm::dvec3(60.0, 1.7, 80.0));
  for (const int frame : {0, 700, 1999}) {  // both look at the middle
    for (const CameraPath& path : scene.paths) {
      const Camera camera = camera_at(path, frame);
      EXPECT_GT(glm::dot(glm::normalize(glm::dvec3(0.0, 3.0, 0.0) - camera.eye), -camera.back), 1.0 - 1e-12);
    }
  }
}

TEST(Houses, OfATownStandFrontToFront) {
  const Scene scene = houses({.n_rows = 10, .n_in_row = 20, .n_each = 700, .seed = 1});
  EXPECT_EQ(scene.objects.size(), 201u);
  std::vector<double> rows;
  for (std::size_t row = 0; row < 10; ++row) {
    rows.push_back(scene.instances[scene.objects[20 * row].first_instance].world_from_object[3].z);
  }
  for (std::size_t row = 0; row + 1 < 10; ++row) {
    EXPECT_DOUBLE_EQ(rows[row + 1] - rows[row], row % 2 == 0 ? 24.0 : 22.0);  // a street, or gardens
  }
}

}  // namespace
}  // namespace lode::geometry
