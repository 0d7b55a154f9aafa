#pragma once
/// Family houses of any number of triangles: walls, windows, a porch and a chimney of closed blocks under a gable or a
/// hip; what is missing to the number is detail, roof tiles last.

#include <cstddef>

#include "geometry/procedural/model.h"

namespace lode::geometry {

enum class HouseRoof { gable, front_gable, hip };

/// Metres; the front is towards +z, the middle of the floor at the origin.
struct HousePlan {
  double width_m = 10.0, depth_m = 8.0;
  int n_floors = 1;
  HouseRoof roof = HouseRoof::gable;
  double pitch = 0.8;  ///< rise of the roof by run, > 0
  bool porch = true;
  Material wall, tiles, trim;  ///< named
};

/// One of six kinds, k below 6.
[[nodiscard]] HousePlan house_plan(int k);

inline constexpr std::size_t kFewestHouseTriangles = 700;

/// Exactly n triangles: frames, sills, corner boards, glazing bars, shutters, boards and railings, each kind all or
/// none, then as many tiles as fit; the last few are splits of the plinth. n even, at least kFewestHouseTriangles.
/// Throws Error (bad_input) otherwise.
[[nodiscard]] Model house(const HousePlan& plan, std::size_t n);

}  // namespace lode::geometry
