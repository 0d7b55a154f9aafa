#include <array>
#include <string>

#include "geometry/procedural/kit.h"
#include "geometry/procedural/kit_scenes.h"
#include "geometry/procedural/parts.h"
#include "geometry/procedural/rooms.h"
#include "geometry/random.h"
#include "geometry/trigonometry.h"

namespace lode::geometry {
namespace {

constexpr double kQuarter = 0.5 * kPi;

/// One room being furnished, in metres from its middle, north-west negative. The ways between doors stay free: strips
/// 1.2 m wide, kDoorOffset south and east of the middle.
class Room {
 public:
  Room(Kit& kit, Kit& scanned, int room, std::uint64_t seed)
      : kit_(kit), scanned_(scanned), room_(room), centre_(room_centre(room)), random_(seed, 1, std::uint64_t(room)) {}

  void furnish(int kind) {
    switch (kind) {
      case 0:
        return living();
      case 1:
        return dining();
      case 2:
        return bedroom();
      case 3:
        return study();
      case 4:
        return scanned_dining();
      case 5:
        return scanned_bedroom();
      default:
        return games();
    }
  }

 private:
  void put(const std::string& file, double x, double z, double turn, double y = 0.0) {
    kit_.stand(file, turned_frame(centre_ + glm::dvec3(x, y, z), turn + random_.uniform(-0.03, 0.03)));
  }
  void put_scanned(const std::string& name, double x, double z, double turn) {
    scanned_.stand(name + "/" + name + ".obj", turned_frame(centre_ + glm::dvec3(x, 0.0, z), turn));
  }
  std::string one_of(std::initializer_list<const char*> names) {
    return *(names.begin() + random_.below(std::uint32_t(names.size())));
  }
  /// On the northern wall, or on the western one; not on outer walls, which have windows there.
  void hang_north(const std::string& file, double x, double y) {
    if (room_ < kRoomsX) return;
    kit_.place(file, turned_frame(centre_ + glm::dvec3(x, y, -0.5 * kRoomZ + 0.5 * kWallThickness + 0.02), 0.0));
  }
  void hang_west(const std::string& file, double z, double y) {
    if (room_ % kRoomsX == 0) return;
    kit_.place(file, turned_frame(centre_ + glm::dvec3(-0.5 * kRoomX + 0.5 * kWallThickness + 0.02, y, z), kQuarter));
  }

  /// What most rooms have: plants by the eastern wall, a cabinet by the northern one, things on the walls.
  void common() {
    put(one_of({"cactus_medium_A.gltf", "cactus_medium_B.gltf"}), 2.45, -1.0, 0.0);
    put(one_of({"cactus_small_A.gltf", "cactus_small_B.gltf"}), 2.55, -1.75, 0.0);
    put(one_of({"cabinet_small_decorated.gltf", "cabinet_small.gltf"}), 2.55, -2.6, -kQuarter);
    put(one_of({"cabinet_medium_decorated.gltf", "cabinet_medium.gltf"}), -1.9, -3.50, 0.0);
    put("rug_oval_A.gltf", kDoorOffset - 0.1, kDoorOffset, 0.0);
    hang_north(one_of({"pictureframe_large_A.gltf", "pictureframe_large_B.gltf"}), -0.1, 1.75);
    hang_west(one_of({"pictureframe_medium.gltf", "pictureframe_small_A.gltf"}), 2.75, 1.75);
    hang_west(one_of({"pictureframe_small_B.gltf", "pictureframe_small_C.gltf"}), 3.35, 1.85);
    hang_west(one_of({"shelf_B_small_decorated.gltf", "shelf_A_small.gltf"}), 0.2, 1.55);
  }
  void chairs_around(const std::array<glm::dvec3, 4>& places) {
    for (const glm::dvec3& p : places) {
      const double turn = p.z + random_.uniform(-0.15, 0.15);
      put(one_of({"chair_A.gltf", "chair_B.gltf", "chair_A_wood.gltf"}), p.x, p.y, turn);
    }
  }

  void living() {
    common();
    put(one_of({"rug_rectangle_A.gltf", "rug_rectangle_stripes_A.gltf", "rug_oval_A.gltf"}), -1.2, -1.15, 0.0);
    put(one_of({"couch_pillows.gltf", "couch.gltf"}), -2.25, -1.15, kQuarter);
    put("table_low.gltf", -0.9, -1.15, kQuarter, 0.07);
    put("armchair_pillows.gltf", 0.45, -1.15, -kQuarter);
    put("lamp_standing.gltf", -2.4, -2.68, 0.0);
    put(one_of({"cabinet_small_decorated.gltf", "cabinet_medium_decorated.gltf"}), -1.5, 3.5, kPi);
  }
  void dining() {
    common();
    put("rug_oval_B.gltf", -0.9, -1.3, 0.0);
    put("table_medium_long.gltf", -0.9, -1.3, 0.0, 0.07);
    chairs_around({{{-1.4, -0.4, kPi}, {-0.4, -0.4, kPi}, {-1.4, -2.2, 0.0}, {-0.4, -2.2, 0.0}}});
    put("couch.gltf", -1.6, 3.3, kPi);
    put("lamp_standing.gltf", -0.1, 3.4, 0.0);
  }
  void bedroom() {
    common();
    put(one_of({"bed_double_A.gltf", "bed_double_B.gltf"}), -1.75, -0.9, kQuarter);
    put("cabinet_small.gltf", -2.5, -2.47, kQuarter);
    put("rug_rectangle_B.gltf", 0.3, -1.0, kQuarter);
    put("armchair.gltf", -1.9, 3.2, kPi);
    put("lamp_standing.gltf", -0.9, 3.4, 0.0);
  }
  void study() {
    common();
    put("table_medium.gltf", -1.0, -1.4, 0.0);
    put("chair_C.gltf", -1.0, -0.45, kPi);
    put("lamp_table.gltf", -1.3, -1.5, 0.0, 0.72);
    put("book_set.gltf", -0.65, -1.6, 0.3, 0.72);
    put("armchair_pillows.gltf", -2.2, 3.15, kPi);
    put_scanned("bookcase", -2.68, -2.5, kQuarter);
    put_scanned("bookcase", -2.68, -1.5, kQuarter);
  }
  void scanned_dining() {
    common();
    put_scanned("oakTable", -0.9, -1.4, 0.0);
    for (const auto& [x, z, turn] :
         {std::array{-0.9, -0.55, kPi}, {-0.9, -2.25, 0.0}, {-1.75, -1.4, kQuarter}, {-0.05, -1.4, -kQuarter}}) {
      put_scanned("oakChair", x, z, turn);
    }
    put_scanned("bookcase", -2.68, -2.2, kQuarter);
    put("couch_pillows.gltf", -1.6, 3.3, kPi);
  }
  void scanned_bedroom() {
    put_scanned("bedWithTexture", -1.0, -1.75, 0.0);
    put_scanned("wardrobeWithSlidingDoors", -1.6, 3.55, kPi);
    put("cactus_medium_A.gltf", 2.45, -1.0, 0.0);
    hang_west("pictureframe_large_B.gltf", 2.9, 1.75);
  }
  void games() {
    common();
    put_scanned("poolTable", -0.9, -1.3, 0.0);
    put("chair_stool.gltf", 0.75, -2.4, 0.4);
    put("chair_stool_wood.gltf", -2.4, -2.4, 1.0);
    put("couch.gltf", -1.6, 3.3, kPi);
  }

  Kit& kit_;
  Kit& scanned_;
  int room_;
  glm::dvec3 centre_;
  Random random_;
};

}  // namespace

Scene kit_rooms(const std::string& folder, const std::string& furniture_folder, std::uint64_t seed) {
  ModelScene scene("kit_rooms");
  Kit kit(scene, folder, 0.72), scanned(scene, furniture_folder, 0.01);
  constexpr int kKinds[kRooms] = {0, 4, 2, 1, 3, 6, 0, 5, 4, 1, 3, 2};
  for (int room = 0; room < kRooms; ++room) Room(kit, scanned, room, seed).furnish(kKinds[room]);
  add_room_walls(scene);
  add_room_walk(scene);
  return std::move(scene).take();
}

}  // namespace lode::geometry
