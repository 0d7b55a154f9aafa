#include "geometry/procedural/town_buildings.h"

#include <algorithm>
#include <string>

#include "geometry/procedural/building.h"
#include "geometry/procedural/town_plan.h"
#include "geometry/procedural/town_random.h"

namespace lode::geometry {
namespace {

constexpr std::size_t kBuildings = 70, kBuildingTriangles = 420'000;

bool contains(const std::vector<int>& list, int value) {
  return std::find(list.begin(), list.end(), value) != list.end();
}

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

}  // namespace

void add_town_buildings(ModelScene& scene, std::uint64_t seed, const std::vector<int>& parks) {
  const std::vector<Plot> plots = all_plots(seed, parks);
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

}  // namespace lode::geometry
