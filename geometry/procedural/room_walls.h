#pragma once
/// The walls of the interior: rooms of kRoomX × kRoomZ in a plan of kRoomsX × kRoomsZ around the origin, floor at y =
/// 0.

#include "geometry/procedural/model.h"

namespace lode::geometry {

inline constexpr int kRoomsX = 4, kRoomsZ = 3;
inline constexpr double kRoomX = 6.0, kRoomZ = 8.0, kRoomHeight = 3.0;
inline constexpr double kDoorWidth = 1.0, kDoorHeight = 2.1, kWallThickness = 0.16;
inline constexpr std::size_t kEastPartitionTriangles = 4840, kSouthPartitionTriangles = 5424;
inline constexpr std::size_t kShellTriangles =
    30'344 - (kRoomsX - 1) * kEastPartitionTriangles - (kRoomsZ - 1) * kSouthPartitionTriangles;

/// Of the door in a wall of a room, from the wall's middle along +x or +z: beside the middle, where tables stand.
inline constexpr double kDoorOffset = 1.6;

/// The partition between columns i and i + 1 of rooms, in its place, with a door from each room to its neighbour.
[[nodiscard]] Model partition_east_of(int column);
/// The partition between rows j and j + 1.
[[nodiscard]] Model partition_south_of(int row);
/// Floor boards, ceiling, outer walls with windows: seen from inside, open outwards.
[[nodiscard]] Model room_shell();

}  // namespace lode::geometry
