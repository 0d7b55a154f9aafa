#pragma once
/// The plan of twelve rooms that the interior and the rooms of kits share: its walls, and the walk through its doors.
/// Rooms are numbered row by row from the north-west.

#include <glm/vec3.hpp>

#include "geometry/procedural/model.h"
#include "geometry/procedural/room_walls.h"

namespace lode::geometry {

inline constexpr int kRooms = kRoomsX * kRoomsZ;

/// A room's middle on the floor.
[[nodiscard]] glm::dvec3 room_centre(int column, int row);
[[nodiscard]] inline glm::dvec3 room_centre(int room) { return room_centre(room % kRoomsX, room / kRoomsX); }

/// Six objects: three partitions along z, two along x, the shell.
void add_room_walls(ModelScene& scene);

/// Path "rooms": eastwards through the rooms of the first row, back through the second, eastwards through the third;
/// and the rooms as free space from 1.2 to 1.9 m above the floor.
void add_room_walk(ModelScene& scene);

}  // namespace lode::geometry
