#include "geometry/procedural/town.h"

#include <algorithm>
#include <cmath>
#include <string>
#include <utility>

#include "geometry/error.h"
#include "geometry/procedural/parts.h"
#include "geometry/procedural/town_buildings.h"
#include "geometry/procedural/town_ground.h"
#include "geometry/procedural/town_models.h"
#include "geometry/procedural/town_plan.h"
#include "geometry/procedural/town_random.h"
#include "geometry/trigonometry.h"

namespace lode::geometry {
namespace {

constexpr std::size_t kCars = 40, kTrees = 45;

/// Two blocks away from the border, of which neither is next to the other.
std::vector<int> choose_parks(std::uint64_t seed) {
  const int west = 1 + int(Random(seed, for_blocks, 0).below(2)), east = 3 + int(Random(seed, for_blocks, 1).below(2));
  const int north = 1, south = 3;
  const bool rising = Random(seed, for_blocks, 2).below(2) == 1;
  return {kBlocksX * (rising ? south : north) + west, kBlocksX * (rising ? north : south) + east};
}

// ---- What stands in the streets ----

void add_cars(ModelScene& scene, std::uint64_t seed) {
  const Material paints[] = {paint("car red", 0.42f, 0.03f, 0.03f),     paint("car white", 0.68f, 0.68f, 0.66f),
                             paint("car blue", 0.04f, 0.10f, 0.32f),    paint("car silver", 0.42f, 0.43f, 0.45f),
                             paint("car black", 0.025f, 0.025f, 0.03f), paint("car green", 0.05f, 0.18f, 0.10f)};
  std::vector<std::size_t> models;
  for (int k = 0; k < 12; ++k) models.push_back(scene.add(car(CarBody(k % 3), paints[(k / 3 * 2 + k % 3) % 6])));
  // Parking bays: four on either side of every stretch of the inner streets along x, on the right of who drives.
  const std::vector<int> bays = shuffled((kBlocksZ - 1) * kBlocksX * 8, Random(seed, for_bays));
  for (std::size_t k = 0; k < kCars; ++k) {
    Random random(seed, for_cars, k);
    const int bay = bays[k] % 8, stretch = bays[k] / 8;
    const double side = bay < 4 ? -1.0 : 1.0, u = 14.3 + 10.5 * (bay % 4) + random.uniform(-0.8, 0.8);
    const double turn = (side > 0.0 ? 0.0 : kPi) + random.uniform(-0.02, 0.02);
    const glm::dmat4 place = turned_frame(
        {block_square(stretch % kBlocksX, 0).low.x + u, 0.0, street_z(1 + stretch / kBlocksX) + side * 4.75}, turn);
    scene.place(models[random.below(12)], "car " + std::to_string(k), place);
  }
}

/// A point of a block in its own metres from its middle, on its pavement or lawn.
glm::dvec3 in_block(int block, double x, double z) {
  const Square s = block_square(block % kBlocksX, block / kBlocksX);
  const glm::dvec2 c = 0.5 * (s.low + s.high);
  return {c.x + x, kKerb, c.y + z};
}

void add_trees(ModelScene& scene, std::uint64_t seed, const std::vector<int>& parks) {
  std::vector<std::size_t> models;
  for (std::uint64_t k = 0; k < 6; ++k) models.push_back(scene.add(tree(seed * 6 + k)));
  const auto plant = [&](std::size_t k, const glm::dvec3& p) {
    Random random(seed, for_trees, k);
    const std::size_t model = models[random.below(6)];
    scene.place(model, "tree " + std::to_string(k), turned_frame(p, random.uniform(0.0, 2.0 * kPi)));
  };
  std::size_t k = 0;
  for (const int park : parks) {
    for (int i = 0; i < 10; ++i, ++k) {  // a ring of trees around each lawn, off the paths
      const SinCos a = sin_cos(2.0 * kPi * (i + 0.5) / 10);
      Random random(seed, for_trees, 1000 + k);
      const double r = random.uniform(15.0, 21.0);
      const double x = r * a.sin, z = r * a.cos;
      const auto off = [](double v) { return std::abs(v) < 3.5 ? (v < 0 ? v - 3.5 : v + 3.5) : v; };
      plant(k, in_block(park, off(x), off(z)));
    }
  }
  // Avenues: every 14 m on the pavements that face two of the streets along x.
  const double across = 0.5 * kBlock - 0.9;
  for (int i = 0; k < kTrees; ++i) {
    const int place = i % 4, column = (i / 4) % kBlocksX, row = i / (4 * kBlocksX) == 0 ? 1 : 2;
    plant(k, in_block(kBlocksX * row + column, -21.0 + 14.0 * place, row == 1 ? across : -across));
    ++k;
  }
}

void add_street_furniture(ModelScene& scene, const std::vector<int>& parks) {
  using enum StreetFurniture;
  const double edge = 0.5 * kBlock - 0.8;
  const std::size_t lamp_model = scene.add(street_furniture(lamp)), bench_model = scene.add(street_furniture(bench)),
                    shelter_model = scene.add(street_furniture(shelter)),
                    column_model = scene.add(street_furniture(column));
  for (int k = 0; k < 12; ++k) {  // along the main street's south side
    scene.place(lamp_model, "lamp " + std::to_string(k),
                turned_frame(in_block(kBlocksX * 2 + k / 2, k % 2 == 0 ? -14.0 : 14.0, -edge), 0.5 * kPi));
  }
  for (int k = 0; k < 5; ++k) {
    const int side = k % 4;
    const SinCos a = sin_cos(0.5 * kPi * side);
    scene.place(bench_model, "bench " + std::to_string(k),
                turned_frame(in_block(parks[std::size_t(k / 4)], 9.0 * a.sin + 2.3 * a.cos, 9.0 * a.cos - 2.3 * a.sin),
                             0.5 * kPi * side + 1.5 * kPi));
  }
  for (int k = 0; k < 3; ++k) {
    scene.place(shelter_model, "shelter " + std::to_string(k),
                turned_frame(in_block(kBlocksX + 2 * k, 6.0, edge - 0.9), 0.0));
  }
  for (int k = 0; k < 2; ++k) {
    scene.place(column_model, "column " + std::to_string(k),
                turned_frame(in_block(kBlocksX * 2 + 1 + 3 * k, -28.4, -28.4), 0.0));
  }
  scene.place(street_furniture(fountain), "fountain", turned_frame(in_block(parks[0], 0.0, 0.0), 0.0));
  scene.place(town_ground(parks), "ground");
}

// ---- Ways through it ----

void add_paths(ModelScene& scene) {
  constexpr double kEye = 1.7;
  const double west = street_x(0) + 6.0, east = street_x(kBlocksX) - 6.0;
  // Along the main street, north at a crossing, and on eastwards: on the right of the middle.
  const std::vector<glm::dvec3> street = {{west, kEye, street_z(2) + 1.5},
                                          {street_x(3) - 1.5, kEye, street_z(2) + 1.5},
                                          {street_x(3) - 1.5, kEye, street_z(4) + 1.5},
                                          {east, kEye, street_z(4) + 1.5}};
  scene.add_path({"street", rounded_corners(street, 7.0), 800, 10.0});
  // Diagonally above the roofs, from which nearly everything is seen.
  const std::vector<glm::dvec3> roofs = {{street_x(0), 52.0, street_z(5)},
                                         {street_x(2), 48.0, street_z(3)},
                                         {street_x(4), 48.0, street_z(2)},
                                         {street_x(6), 52.0, street_z(0)}};
  scene.add_path({"roofs", rounded_corners(roofs, 30.0), 800, 40.0});
  const auto add_free = [&](double x0, double z0, double x1, double z1) {
    scene.add_free_space({{x0, 1.2, z0}, {x1, 2.2, z1}});
  };
  for (int j = 0; j <= kBlocksZ; ++j) {  // streets along x whole, streets along z between them
    add_free(street_x(0), street_z(j) - 5.5, street_x(kBlocksX), street_z(j) + 5.5);
    for (int i = 0; i <= kBlocksX && j < kBlocksZ; ++i) {
      add_free(street_x(i) - 5.5, street_z(j) + 5.5, street_x(i) + 5.5, street_z(j + 1) - 5.5);
    }
  }
}

void expect_totals(const Scene& scene) {
  std::size_t n = 0;
  for (const SceneObject& object : scene.objects) n += n_triangles(scene, object);
  if (scene.objects.size() == kTownModels && n == kTownTriangles) return;
  throw Error(ErrorKind::bad_input, "town: expected 179 models and 973103 triangles, found " +
                                        std::to_string(scene.objects.size()) + " and " + std::to_string(n));
}

}  // namespace

Scene town(std::uint64_t seed) {
  ModelScene scene("town179");
  const std::vector<int> parks = choose_parks(seed);
  add_town_buildings(scene, seed, parks);
  add_cars(scene, seed);
  add_trees(scene, seed, parks);
  add_street_furniture(scene, parks);
  add_paths(scene);
  expect_totals(scene.scene());
  return std::move(scene).take();
}

}  // namespace lode::geometry
