#pragma once
/// What stands in a town's streets, standing on y = 0 around the origin, in metres. Solid parts are closed; leaves are
/// single faces seen from both sides, of an alpha-tested material (no texture cuts anything out), so that no tree may
/// occlude. Each has exactly the triangles asked for, or throws Error (bad_input).

#include <cstdint>

#include "geometry/procedural/model.h"

namespace lode::geometry {

inline constexpr std::size_t kCarTriangles = 5500;
inline constexpr std::size_t kTreeTriangles = 5000;
inline constexpr std::size_t kStreetFurnitureTriangles = 4504;

enum class CarBody : std::uint8_t { hatchback, saloon, van };

/// 4 to 5 m long, front towards +x.
[[nodiscard]] Model car(CarBody body, const Material& paint);

/// 7 to 10 m high.
[[nodiscard]] Model tree(std::uint64_t seed);

enum class StreetFurniture : std::uint8_t { lamp, bench, shelter, column, fountain };

/// Front towards +z.
[[nodiscard]] Model street_furniture(StreetFurniture kind);

}  // namespace lode::geometry
