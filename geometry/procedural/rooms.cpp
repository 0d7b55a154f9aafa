#include "geometry/procedural/rooms.h"

#include <string>
#include <vector>

namespace lode::geometry {

glm::dvec3 room_centre(int column, int row) {
  return {(column + 0.5 - 0.5 * kRoomsX) * kRoomX, 0.0, (row + 0.5 - 0.5 * kRoomsZ) * kRoomZ};
}

void add_room_walls(ModelScene& scene) {
  for (int i = 0; i + 1 < kRoomsX; ++i)
    scene.place(partition_east_of(i), "partition east of column " + std::to_string(i));
  for (int j = 0; j + 1 < kRoomsZ; ++j)
    scene.place(partition_south_of(j), "partition south of row " + std::to_string(j));
  scene.place(room_shell(), "shell");
}

void add_room_walk(ModelScene& scene) {
  constexpr double kEye = 1.6;
  const auto crossing = [&](int column, int row) {  // where a room's two ways cross
    return room_centre(column, row) + glm::dvec3(kDoorOffset, kEye, kDoorOffset);
  };
  std::vector<glm::dvec3> points = {room_centre(0, 0) + glm::dvec3(-2.3, kEye, kDoorOffset)};
  for (int row = 0; row < kRoomsZ; ++row) {
    const bool east = row % 2 == 0;
    if (row > 0) points.push_back(crossing(east ? 0 : kRoomsX - 1, row));
    if (row + 1 < kRoomsZ) points.push_back(crossing(east ? kRoomsX - 1 : 0, row));
  }
  points.push_back(room_centre(kRoomsX - 1, kRoomsZ - 1) + glm::dvec3(1.8, kEye, kDoorOffset));
  scene.add_path({"rooms", rounded_corners(points, 1.0), 600, 2.0});
  for (int room = 0; room < kRooms; ++room) {
    const glm::dvec3 half(0.5 * kRoomX - 0.3, 0.0, 0.5 * kRoomZ - 0.3), c = room_centre(room);
    scene.add_free_space({c - half + glm::dvec3(0, 1.2, 0), c + half + glm::dvec3(0, 1.9, 0)});
  }
}

}  // namespace lode::geometry
