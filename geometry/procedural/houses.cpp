#include "geometry/procedural/houses.h"

#include <string>
#include <utility>
#include <vector>

#include "geometry/procedural/house.h"
#include "geometry/procedural/parts.h"
#include "geometry/random.h"
#include "geometry/trigonometry.h"

namespace lode::geometry {
namespace {

constexpr double kPitch = 16.0;    ///< from house to house
constexpr double kStreet = 14.0;   ///< from front to front of a street's rows
constexpr double kDepth = 10.0;    ///< of the deepest house
constexpr double kGardens = 12.0;  ///< behind the houses
constexpr int kKinds = 6, kFrames = 2000;
constexpr double kEye = 1.7;

/// The middle of a row of houses, from the middle of all.
double row_z(int row, int n_rows) {
  const double pair = 2.0 * kDepth + kStreet + kGardens;
  const double side = 0.5 * (kStreet + kDepth);
  const double first = -0.5 * pair * ((n_rows + 1) / 2 - 1);
  return first + pair * (row / 2) + (row % 2 == 0 ? -side : side);
}

void add_ground(ModelScene& scene, const glm::dvec2& half) {
  Model ground{.name = "ground", .surfaces = {}};
  Mesh& grass = ground.surface(paint("lawn", 0.10f, 0.17f, 0.05f));
  const auto corner = [](double x, double z) { return glm::dvec3(x, 0.0, z); };
  add_quad(grass, corner(-half.x, half.y), corner(half.x, half.y), corner(half.x, -half.y), corner(-half.x, -half.y));
  scene.place(ground, "ground");
}

}  // namespace

Scene houses(const HousesParams& params) {
  ModelScene scene("houses" + std::to_string(params.n_rows * params.n_in_row));
  std::vector<std::size_t> models;
  for (int k = 0; k < kKinds; ++k) models.push_back(scene.add(house(house_plan(k), params.n_each)));
  for (int row = 0; row < params.n_rows; ++row) {
    for (int i = 0; i < params.n_in_row; ++i) {
      const int number = row * params.n_in_row + i;
      Random random(params.seed, 0x686f7573, std::uint64_t(number));
      const std::size_t model = models[random.below(kKinds)];
      const glm::dvec3 at(kPitch * (i - 0.5 * (params.n_in_row - 1)), 0.0, row_z(row, params.n_rows));
      scene.place(model, "house " + std::to_string(number), turned_frame(at, row % 2 == 0 ? 0.0 : kPi));
    }
  }
  const double end = 0.5 * kPitch * params.n_in_row, side = row_z(params.n_rows - 1, params.n_rows) + kDepth;
  add_ground(scene, {end + 300.0, side + 300.0});
  const double street_z = row_z(params.n_rows / 4 * 2, params.n_rows) + 0.5 * (kStreet + kDepth);
  const glm::dvec3 middle(0.0, 3.0, street_z);
  const auto eye = [&](double x, double z) { return glm::dvec3(x, kEye, street_z + z); };
  scene.add_path({.name = "approach",
                  .points = {eye(end + 40.0, 0.0), eye(end + 200.0, 0.0), eye(end + 40.0, 0.0)},
                  .n_frames = kFrames,
                  .target = middle});
  const double away = side - street_z + 58.0;  // 80 m, if there are two rows
  scene.add_path(
      {.name = "sideways", .points = {eye(-60.0, away), eye(60.0, away)}, .n_frames = kFrames, .target = middle});
  scene.add_free_space({{-end, 1.2, street_z - 4.0}, {end, 2.2, street_z + 4.0}});
  return std::move(scene).take();
}

}  // namespace lode::geometry
