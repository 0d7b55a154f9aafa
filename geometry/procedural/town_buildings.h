#pragma once
/// The buildings of the town.

#include <cstdint>
#include <vector>

#include "geometry/procedural/model.h"

namespace lode::geometry {

/// Adds 70 buildings of 420,000 triangles in all, two or three on each block that is no park (`parks`: two blocks, as
/// kBlocksX·row + column). What is left over the plain triangles goes to buildings by their windows; the last takes
/// what rounding leaves.
void add_town_buildings(ModelScene& scene, std::uint64_t seed, const std::vector<int>& parks);

}  // namespace lode::geometry
