#pragma once
/// The ground of the town.

#include "geometry/procedural/model.h"

namespace lode::geometry {

inline constexpr std::size_t kTownGroundTriangles = 4511;

/// Asphalt, an open sheet; pavements and lawns, closed slabs; the markings of the roads, sheets 1 cm above the asphalt.
/// `parks`: the blocks, as kBlocksX·row + column, that are lawns. An odd number of triangles, because of the arrows'
/// heads: exactly kTownGroundTriangles, or Error (bad_input).
[[nodiscard]] Model town_ground(const std::vector<int>& parks);

}  // namespace lode::geometry
