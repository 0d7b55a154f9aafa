#pragma once
/// What stands in rooms beside table, chair and sofa (furniture.h), on y = 0 around the origin, in metres, front
/// towards +z. Solid parts are closed. Each has exactly the triangles asked for, or throws Error (bad_input).

#include <cstdint>

#include "geometry/procedural/model.h"

namespace lode::geometry {

inline constexpr std::size_t kShelfTriangles = 5200;
inline constexpr std::size_t kPlantTriangles = 6000;
inline constexpr std::size_t kRoomLampTriangles = 3000;

/// Shelves full of books, 1.1 × 2.1 × 0.32 m, open to the front and with a back.
[[nodiscard]] Model bookcase(std::uint64_t seed);

/// A cupboard with two panelled doors and drawers, 1.2 × 1.9 × 0.5 m.
[[nodiscard]] Model cupboard();

/// A potted plant 1.4 to 1.8 m high. Its leaves are single faces of an alpha-tested material: it may not occlude.
[[nodiscard]] Model potted_plant(std::uint64_t seed);

/// A standard lamp, 1.6 m high.
[[nodiscard]] Model standard_lamp();

}  // namespace lode::geometry
