#include <string>

#include "geometry/procedural/kit.h"
#include "geometry/procedural/kit_scenes.h"
#include "geometry/procedural/parts.h"
#include "geometry/random.h"
#include "geometry/trigonometry.h"

namespace lode::geometry {
namespace {

// A unit of the kit is 0.75 m: its walls are 4 long, 4 high and 1 thick. Cells are 4 × 4 units: rooms of 3 × 3 in two
// rows, a corridor of one cell between them.
constexpr double kUnit = 0.75, kCell = 4.0 * kUnit;
constexpr int kRooms = 5, kRoomCells = 3, kCellsX = kRooms * kRoomCells, kCellsZ = 2 * kRoomCells + 1;
constexpr double kEye = 1.6;

/// The corner of cell (i, j) in the plan; fractions are inside cells.
glm::dvec3 at(double i, double j, double y = 0.0) {
  return {(i - 0.5 * kCellsX) * kCell, y, (j - 0.5 * kCellsZ) * kCell};
}

/// Turned by half a turn about the x axis.
glm::dmat4 frame_upside_down(const glm::dvec3& origin) {
  glm::dmat4 m(1.0);
  m[1][1] = m[2][2] = -1.0;
  m[3] = glm::dvec4(origin, 1.0);
  return m;
}

std::string one_of(std::initializer_list<const char*> names, Random& random) {
  return *(names.begin() + random.below(std::uint32_t(names.size())));
}

void add_floor_and_ceiling(Kit& kit, std::uint64_t seed) {
  for (int j = 0; j < kCellsZ; ++j) {
    for (int i = 0; i < kCellsX; ++i) {
      Random random(seed, 1, std::uint64_t(j * kCellsX + i));
      const bool wooden = j < kRoomCells && (i / kRoomCells) % 2 == 1;
      const std::string floor = wooden ? "floor_wood_large.gltf.glb" : "floor_tile_large.gltf.glb";
      kit.place(floor, turned_frame(at(i + 0.5, j + 0.5), 0.5 * kPi * random.below(4)));
      kit.place("floor_wood_large.gltf.glb", frame_upside_down(at(i + 0.5, j + 0.5, 4.05 * kUnit)));  // the ceiling
    }
  }
}

/// One piece of wall; `along_x`: from (i, j) to (i + 1, j), else to (i, j + 1).
void add_wall(Kit& kit, int i, int j, bool along_x, bool door, Random random) {
  const glm::dvec3 middle = along_x ? at(i + 0.5, j) : at(i, j + 0.5);
  const std::string plain =
      one_of({"wall.gltf.glb", "wall.gltf.glb", "wall.gltf.glb", "wall_cracked.gltf.glb"}, random);
  kit.place(door ? "wall_doorway.glb" : plain, turned_frame(middle, along_x ? 0.0 : 0.5 * kPi));
}

/// Doorways are in the middle of a room's sides: to the corridor from all, to the next room in the southern row, and
/// between the last two of the northern one.
void add_walls(Kit& kit, std::uint64_t seed) {
  const auto random = [&](int i, int j, int way) { return Random(seed, 2, std::uint64_t((j * 32 + i) * 2 + way)); };
  for (const int j : {0, kRoomCells, kRoomCells + 1, kCellsZ}) {
    for (int i = 0; i < kCellsX; ++i) {
      const bool inner = j > 0 && j < kCellsZ;
      add_wall(kit, i, j, true, inner && i % kRoomCells == 1, random(i, j, 0));
    }
  }
  for (int room = 0; room <= kRooms; ++room) {
    for (int j = 0; j < kCellsZ; ++j) {
      const bool end = room == 0 || room == kRooms;
      if (j == kRoomCells && !end) continue;
      const bool south = j == kRoomCells + 2 && !end, north = j == 1 && room == kRooms - 1;
      add_wall(kit, kRoomCells * room, j, false, south || north, random(kRoomCells * room, j, 1));
    }
    for (const int j : {0, kRoomCells, kRoomCells + 1, kCellsZ}) {
      kit.place("pillar.gltf.glb", turned_frame(at(kRoomCells * room, j), 0.0));
    }
  }
}

/// Things in the corners and along the sides of a room whose first cell is (i, j); the cross of its middles stays free.
void furnish(Kit& kit, int i, int j, Random random) {
  const auto put = [&](const std::string& file, double x, double z, double turn) {
    kit.stand(file, turned_frame(at(i + x, j + z, 0.04), turn));
  };
  const double quarter = 0.5 * kPi;
  const std::string table = one_of({"table_long_decorated_A.gltf.glb", "table_medium_decorated_A.gltf.glb",
                                    "table_long_tablecloth_decorated_A.gltf.glb", "table_long.gltf.glb"},
                                   random);
  put(table, 0.72, 2.25, 0.0);
  for (const double z : {1.95, 2.2, 2.45}) {
    if (random.below(4) != 0) put("chair.gltf.glb", 1.08, z, -quarter + random.uniform(-0.3, 0.3));
    if (random.below(4) != 0) put("chair.gltf.glb", 0.36, z, quarter + random.uniform(-0.3, 0.3));
  }
  const double turn_large = quarter * random.below(4), turn_small = quarter * random.below(2),
               turn_round = random.uniform(0.0, 2.0 * kPi);
  put(one_of({"barrel_large.gltf.glb", "barrel_large_decorated.gltf.glb", "box_stacked.gltf.glb"}, random), 0.5, 0.55,
      turn_large);
  put(one_of({"barrel_small_stack.gltf.glb", "box_small_decorated.gltf.glb", "box_large.gltf.glb"}, random), 2.55, 0.45,
      turn_small);
  put(one_of({"chest.glb", "chest_gold.glb", "keg.gltf.glb"}, random), 2.1, 0.36, 0.0);
  put(one_of({"bed_decorated.gltf.glb", "bed_frame.gltf.glb", "trunk_large_A.gltf.glb"}, random), 2.5, 2.38, kPi);
  put(one_of({"barrel_small.gltf.glb", "box_small.gltf.glb", "stool.gltf.glb"}, random), 1.98, 2.74, turn_round);
  if (random.below(2) == 0) put("candle_triple.gltf.glb", 1.95, 2.45, 0.0);
  // Torches on the walls across from each other.
  for (const double x : {0.6, 2.4}) {
    kit.place("torch_mounted.gltf.glb", turned_frame(at(i + x, j, 2.0 * kUnit) + glm::dvec3(0, 0, 0.5 * kUnit), 0.0));
    kit.place("torch_mounted.gltf.glb",
              turned_frame(at(i + x, j + 3, 2.0 * kUnit) - glm::dvec3(0, 0, 0.5 * kUnit), kPi));
  }
}

void add_path(ModelScene& scene) {
  const double north = 1.5, corridor = 3.5, south = 5.5;
  const auto middle = [](int room) { return kRoomCells * (room + 0.5); };
  const auto eye = [](double i, double j) { return at(i, j, kEye); };
  const std::vector<glm::dvec3> points = {
      eye(middle(0), 0.9),      eye(middle(0), corridor), eye(middle(1), corridor),
      eye(middle(1), south),    eye(middle(4), south),    eye(middle(4), corridor),
      eye(middle(3), corridor), eye(middle(3), north),    eye(middle(4) + 0.3, north)};
  scene.add_path({"rooms", rounded_corners(points, 1.2), 600, 2.5});
  const double edge = 0.25;
  for (int room = 0; room < kRooms; ++room) {
    for (const int j : {0, kRoomCells + 1}) {
      scene.add_free_space({at(kRoomCells * room + edge, j + edge, 1.2),
                            at(kRoomCells * (room + 1) - edge, j + kRoomCells - edge, 1.9)});
    }
  }
  scene.add_free_space({at(edge, kRoomCells + edge, 1.2), at(kCellsX - edge, kRoomCells + 1 - edge, 1.9)});
}

}  // namespace

Scene kit_dungeon(const std::string& folder, std::uint64_t seed) {
  ModelScene scene("kit_dungeon");
  Kit kit(scene, folder, kUnit);
  kit.leave_out("_door");
  add_floor_and_ceiling(kit, seed);
  add_walls(kit, seed);
  for (int room = 0; room < kRooms; ++room) {
    for (const int row : {0, 1}) {
      furnish(kit, kRoomCells * room, row * (kRoomCells + 1), Random(seed, 3, std::uint64_t(2 * room + row)));
    }
  }
  add_path(scene);
  return std::move(scene).take();
}

}  // namespace lode::geometry
