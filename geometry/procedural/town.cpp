#include "geometry/procedural/town.h"

#include <algorithm>
#include <cmath>
#include <string>
#include <utility>

#include "geometry/error.h"
#include "geometry/procedural/building.h"
#include "geometry/procedural/parts.h"
#include "geometry/procedural/town_ground.h"
#include "geometry/procedural/town_models.h"
#include "geometry/procedural/town_plan.h"
#include "geometry/random.h"
#include "geometry/trigonometry.h"

namespace lode::geometry {
namespace {

constexpr std::size_t kBuildings = 70, kCars = 40, kTrees = 45;
constexpr std::size_t kBuildingTriangles = 420'000;

/// What random numbers are for.
enum Purpose : std::uint32_t { for_blocks = 1, for_heights, for_walls, for_shapes, for_cars, for_trees, for_bays };

/// 0 … n − 1 in random order (Fisher and Yates).
std::vector<int> shuffled(int n, Random random) {
  std::vector<int> order;
  for (int k = 0; k < n; ++k) order.push_back(k);
  for (int k = n; k > 1; --k) std::swap(order[std::size_t(k - 1)], order[random.below(std::uint32_t(k))]);
  return order;
}

/// Two blocks away from the border, of which neither is next to the other.
std::vector<int> choose_parks(std::uint64_t seed) {
  const int west = 1 + int(Random(seed, for_blocks, 0).below(2)), east = 3 + int(Random(seed, for_blocks, 1).below(2));
  const int north = 1, south = 3;
  const bool rising = Random(seed, for_blocks, 2).below(2) == 1;
  return {kBlocksX * (rising ? south : north) + west, kBlocksX * (rising ? north : south) + east};
}

bool contains(const std::vector<int>& list, int value) {
  return std::find(list.begin(), list.end(), value) != list.end();
}

// ---- Buildings ----

/// Where a building may stand, and which side of it is the middle of its block.
struct Plot {
  Square square;
  glm::dvec2 block_centre;
};

/// A block's plots: its square inside the pavements, halved, and with `three` one half halved again; lanes between.
void add_plots(const Square& block, bool three, bool along_x, std::vector<Plot>& plots) {
  constexpr double kLane = 3.0;
  const glm::dvec2 low = block.low + kPavement, high = block.high - kPavement, centre = 0.5 * (low + high);
  const auto add = [&](double u0, double u1, double v0, double v1) {
    const Square s = along_x ? Square{{u0, v0}, {u1, v1}} : Square{{v0, u0}, {v1, u1}};
    plots.push_back({s, centre});
  };
  const glm::dvec2 a = along_x ? low : glm::dvec2(low.y, low.x), b = along_x ? high : glm::dvec2(high.y, high.x);
  const glm::dvec2 c = 0.5 * (a + b);
  add(a.x, b.x, a.y, c.y - 0.5 * kLane);
  if (!three) {
    add(a.x, b.x, c.y + 0.5 * kLane, b.y);
    return;
  }
  add(a.x, c.x - 0.5 * kLane, c.y + 0.5 * kLane, b.y);
  add(c.x + 0.5 * kLane, b.x, c.y + 0.5 * kLane, b.y);
}

std::vector<Plot> all_plots(std::uint64_t seed, const std::vector<int>& parks) {
  std::vector<int> blocks;
  for (const int k : shuffled(kBlocksX * kBlocksZ, Random(seed, for_blocks, 3))) {
    if (!contains(parks, k)) blocks.push_back(k);
  }
  std::vector<Plot> plots;
  for (std::size_t n = 0; n < blocks.size(); ++n) {
    const int k = blocks[n];
    const bool three = n < kBuildings - 2 * blocks.size();
    add_plots(block_square(k % kBlocksX, k / kBlocksX), three, Random(seed, for_shapes, std::uint64_t(k)).below(2) == 0,
              plots);
  }
  return plots;
}

/// Floors of 70 buildings, 9 to 45 m: quantiles of a log-normal distribution of median 18 m and σ 0.45, five buildings
/// each, so that a town's sum hardly depends on its seed.
constexpr int kFloors[] = {2, 3, 3, 4, 4, 4, 5, 5, 6, 6, 7, 8, 9, 12};

std::vector<glm::dvec2> rectangle(const Square& s) {
  return {{s.low.x, s.high.y}, {s.high.x, s.high.y}, {s.high.x, s.low.y}, {s.low.x, s.low.y}};
}

/// The square without the quarter next to the block's middle: an L, its fan from the inner corner.
std::vector<glm::dvec2> ell(const Square& s, const glm::dvec2& block_centre) {
  const glm::dvec2 c = 0.5 * (s.low + s.high), size = s.high - s.low;
  const glm::dvec2 to_centre(block_centre.x < c.x ? -1.0 : 1.0, block_centre.y < c.y ? -1.0 : 1.0);
  const glm::dvec2 inner = c + to_centre * (0.06 * size), far = c + to_centre * (0.5 * size),
                   back = c - to_centre * (0.5 * size);
  std::vector<glm::dvec2> outline = {inner, {inner.x, far.y}, {back.x, far.y}, back, {far.x, back.y}, {far.x, inner.y}};
  if (to_centre.x * to_centre.y > 0.0) std::reverse(outline.begin() + 1, outline.end());
  return outline;
}

Square inset(const Square& s, double by) { return {s.low + by, s.high - by}; }

/// A tower on a base, an L, or a plain block.
std::vector<Wing> wings_on(const Plot& plot, int n_floors, Random& random) {
  if (n_floors >= 8) {
    std::vector<Wing> wings = {{rectangle(plot.square), 0.0, 2}};
    wings.push_back({rectangle(inset(plot.square, 4.0)), wing_height(wings[0]), n_floors - 2});
    return wings;
  }
  const bool is_ell = random.below(2) == 0;
  return {{is_ell ? ell(plot.square, plot.block_centre) : rectangle(plot.square), 0.0, n_floors}};
}

const Material& wall_material(std::uint32_t k) {
  static const Material kWalls[] = {
      paint("brick", 0.34f, 0.135f, 0.085f),         paint("sandstone", 0.52f, 0.41f, 0.26f),
      paint("cream render", 0.62f, 0.55f, 0.42f),    paint("ochre render", 0.55f, 0.36f, 0.15f),
      paint("grey concrete", 0.36f, 0.36f, 0.35f),   paint("rose render", 0.52f, 0.28f, 0.22f),
      paint("pale blue render", 0.34f, 0.42f, 0.48f)};
  return kWalls[k % 7];
}

std::vector<BuildingPlan> building_plans(std::uint64_t seed, const std::vector<Plot>& plots, double bay_m) {
  const std::vector<int> heights = shuffled(int(plots.size()), Random(seed, for_heights));
  std::vector<BuildingPlan> plans;
  for (std::size_t k = 0; k < plots.size(); ++k) {
    Random random(seed, for_walls, k);
    BuildingPlan plan;
    plan.wings = wings_on(plots[k], kFloors[std::size_t(heights[k]) % std::size(kFloors)], random);
    plan.bay_m = bay_m * random.uniform(0.92, 1.12);
    plan.wall = wall_material(random.below(7));
    plan.trim =
        random.below(2) == 0 ? paint("limestone", 0.58f, 0.54f, 0.46f) : paint("white trim", 0.68f, 0.67f, 0.64f);
    plan.seed = seed;
    plans.push_back(std::move(plan));
  }
  return plans;
}

/// Plans whose plain triangles leave nearly half for ornaments: bays grow until it is so.
std::vector<BuildingPlan> fitting_plans(std::uint64_t seed, const std::vector<Plot>& plots, std::size_t& plain) {
  for (double bay_m = 3.3;; bay_m *= 1.03) {
    std::vector<BuildingPlan> plans = building_plans(seed, plots, bay_m);
    plain = 0;
    for (const BuildingPlan& plan : plans) plain += n_plain_triangles(plan);
    if (plain <= kBuildingTriangles * 53 / 100) return plans;
  }
}

/// What is left over the plain triangles goes to buildings by their windows; the last takes what rounding leaves.
void add_buildings(ModelScene& scene, std::uint64_t seed, const std::vector<Plot>& plots) {
  std::size_t plain = 0, windows = 0, spent = 0;
  const std::vector<BuildingPlan> plans = fitting_plans(seed, plots, plain);
  for (const BuildingPlan& plan : plans) windows += n_windows(plan);
  for (std::size_t k = 0; k < plans.size(); ++k) {
    const std::size_t extra = (kBuildingTriangles - plain) * n_windows(plans[k]) / windows / 2 * 2;
    const bool last = k + 1 == plans.size();
    const std::size_t n = last ? kBuildingTriangles - spent : n_plain_triangles(plans[k]) + extra;
    scene.place(building(plans[k], n), "building " + std::to_string(k));
    spent += n;
  }
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
    scene.place(models[random.below(6)], "tree " + std::to_string(k), turned_frame(p, random.uniform(0.0, 2.0 * kPi)));
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
  add_buildings(scene, seed, all_plots(seed, parks));
  add_cars(scene, seed);
  add_trees(scene, seed, parks);
  add_street_furniture(scene, parks);
  add_paths(scene);
  expect_totals(scene.scene());
  return std::move(scene).take();
}

}  // namespace lode::geometry
