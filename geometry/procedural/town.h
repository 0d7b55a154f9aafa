#pragma once
/// A town of 179 models and 973,103 triangles: the size of the city in Onozawa and Kitazawa, "Occlusion culling with a
/// hierarchical convex approximation of models", sec. 4. What theirs looked like is not known. Metres, y up, the
/// streets at y = 0.
///
///   70 buildings           420,000 triangles, 9 to 45 m high, on 28 of 6 × 5 blocks of 60 m
///   40 cars                220,000
///   45 trees               225,000 on pavements and in two parks; they may not occlude
///   24 street furniture    108,103: 23 of 4504, and the ground with its roads, 4511

#include <cstdint>

#include "geometry/scene.h"

namespace lode::geometry {

inline constexpr std::size_t kTownModels = 179;
inline constexpr std::size_t kTownTriangles = 973'103;

/// Objects: buildings, cars, trees, street furniture, the ground, one a model. Paths: "street", 800 frames with two
/// turns at an eye height of 1.7 m; "roofs", 800 frames over the roofs. Free space: the streets from 1.2 to 2.2 m above
/// the ground. Throws Error (bad_input) if a count were not exact. O(triangles); about a second.
[[nodiscard]] Scene town(std::uint64_t seed);

}  // namespace lode::geometry
