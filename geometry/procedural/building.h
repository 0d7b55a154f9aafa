#pragma once
/// Town buildings: extruded footprints whose windows are inset reliefs, ornamented until a count of triangles is met.

#include <cstddef>
#include <cstdint>
#include <vector>

#include "geometry/procedural/model.h"

namespace lode::geometry {

/// One prism of a building: a rectangle or an L.
struct Wing {
  std::vector<glm::dvec2> outline;  ///< corners (x, z) in metres, counter-clockwise from above, a fan from the first
  double base_m = 0.0;              ///< where it stands
  int n_floors = 3;
};

struct BuildingPlan {
  std::vector<Wing> wings;
  double bay_m = 3.4;      ///< width of a window's bay, about
  Material wall, trim;     ///< named
  std::uint64_t seed = 1;  ///< of which windows are curtained
};

/// Height of a wing: a ground floor of 4 m, the others of 3.1 m, a plinth and a parapet.
[[nodiscard]] double wing_height(const Wing& wing);

/// Windows and doors of all wings.
[[nodiscard]] std::size_t n_windows(const BuildingPlan& plan);

/// Triangles of the walls, windows and roofs alone: the fewest that `building` can have.
[[nodiscard]] std::size_t n_plain_triangles(const BuildingPlan& plan);

/// Exactly n triangles, even: cornices, sills, glazing bars, lintels, balconies and dentils are added in that order,
/// floor by floor, while they fit; the last few triangles are splits of a roof. Each wing and ornament is closed over
/// the model's surfaces together. Throws Error (bad_input) where n is too small or odd.
[[nodiscard]] Model building(const BuildingPlan& plan, std::size_t n);

}  // namespace lode::geometry
