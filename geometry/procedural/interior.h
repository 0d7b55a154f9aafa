#pragma once
/// A flat of 124 models and 629,336 triangles: the size of the interior in Onozawa and Kitazawa, "Occlusion culling
/// with a hierarchical convex approximation of models", sec. 4. What theirs looked like is not known. Metres, y up; 12
/// rooms of 6 × 8 × 3 m in a 4 × 3 plan, with doors of 1 × 2.1 m.
///
///   12 tables, 48 chairs, 10 sofas   361,792 triangles (furniture.h), turned a little
///   26 bookcases and cupboards       135,200
///   12 plants                         72,000; they may not occlude
///   10 lamps                          30,000
///    6 walls                          30,344: five partitions with their doors, and the shell: floor, ceiling and the
///                                     walls around

#include <cstdint>

#include "geometry/scene.h"

namespace lode::geometry {

inline constexpr std::size_t kInteriorModels = 124;
inline constexpr std::size_t kInteriorTriangles = 629'336;

/// One object a model. Path "rooms": 600 frames through the doors of all rooms, first to last, at an eye height of
/// 1.6 m. Free space: the rooms from 1.2 to 1.9 m above the floor. Throws Error (bad_input) if a count were not exact.
/// O(triangles); under a second.
[[nodiscard]] Scene interior(std::uint64_t seed);

}  // namespace lode::geometry
