#include "geometry/procedural/interior.h"

#include <string>
#include <utility>

#include "geometry/error.h"
#include "geometry/procedural/furniture.h"
#include "geometry/procedural/parts.h"
#include "geometry/procedural/room_models.h"
#include "geometry/procedural/rooms.h"
#include "geometry/random.h"
#include "geometry/trigonometry.h"

namespace lode::geometry {
namespace {

constexpr double kQuarter = 0.5 * kPi;

/// Puts furniture into rooms. Doors are kDoorOffset east and south of the walls' middles: the ways between them, 1.2 m
/// wide, stay free, and so does the eastern part of each room.
class Furnisher {
 public:
  Furnisher(ModelScene& scene, std::uint64_t seed) : scene_(scene), seed_(seed) {}

  void furnish() {
    add_models();
    for (int room = 0; room < kRooms; ++room) {
      add_dining_group(room);
      add_along_walls(room);
    }
  }

 private:
  void add_models() {
    table_ = scene_.add(table());
    chair_ = scene_.add(chair());
    cupboard_ = scene_.add(cupboard());
    lamp_ = scene_.add(standard_lamp());
    const Material fabrics[] = {paint("slate fabric", 0.10f, 0.15f, 0.21f), paint("moss fabric", 0.15f, 0.20f, 0.10f),
                                paint("wine fabric", 0.26f, 0.06f, 0.07f), paint("sand fabric", 0.48f, 0.40f, 0.29f)};
    for (int k = 0; k < 3; ++k) sofas_[k] = scene_.add(sofa(fabrics[k], k == 0 ? fabrics[3] : fabrics[k]));
    for (std::uint64_t k = 0; k < 4; ++k) bookcases_[k] = scene_.add(bookcase(seed_ * 4 + k));
    for (std::uint64_t k = 0; k < 3; ++k) plants_[k] = scene_.add(potted_plant(seed_ * 3 + k));
  }

  /// A table with four chairs, two on either long side, none of them quite straight.
  void add_dining_group(int room) {
    Random random(seed_, 1, std::uint64_t(room));
    const glm::dmat4 group =
        turned_frame(room_centre(room) + glm::dvec3(-0.9, 0.0, -1.45), random.uniform(-0.06, 0.06));
    place(table_, "table", group);
    for (int k = 0; k < 4; ++k) {
      const double side = k < 2 ? 1.0 : -1.0, x = (k % 2 == 0 ? -0.38 : 0.38) + random.uniform(-0.04, 0.04);
      const glm::dvec3 at(x, 0.0, side * (0.60 + random.uniform(0.0, 0.14)));
      place(chair_, "chair", group * turned_frame(at, (side > 0 ? kPi : 0.0) + random.uniform(-0.22, 0.22)));
    }
  }

  void add_along_walls(int room) {
    Random random(seed_, 2, std::uint64_t(room));
    const auto in_room = [&](double x, double z, double yaw) {
      return turned_frame(room_centre(room) + glm::dvec3(x, 0.0, z), yaw);
    };
    place(bookcases_[random.below(4)], "bookcase", in_room(-2.71, -2.75, kQuarter));
    if (room == 4 || room == 11) place(bookcases_[random.below(4)], "bookcase", in_room(-2.71, -1.5, kQuarter));
    place(cupboard_, "cupboard", in_room(-1.55, -3.60, 0.0));
    // Each number in a statement of its own: the order of a call's arguments is the compiler's.
    const auto shift = [&] { return random.uniform(-0.05, 0.05); };
    const auto turn = [&] { return random.uniform(0.0, 2.0 * kPi); };
    const std::uint32_t plant = random.below(3), fabric = random.below(3);
    const double plant_x = 2.35 + shift(), plant_turn = turn(), sofa_x = -1.55 + shift(), lamp_x = -0.12 + shift();
    place(plants_[plant], "plant", in_room(plant_x, -0.7, plant_turn));
    if (room == 3 || room == 8) return;  // ten sofas and ten lamps for twelve rooms
    place(sofas_[fabric], "sofa", in_room(sofa_x, 3.36, kPi));
    place(lamp_, "lamp", in_room(lamp_x, 3.45, turn()));
  }

  void place(std::size_t model, const std::string& name, const glm::dmat4& at) {
    scene_.place(model, name + " " + std::to_string(scene_.scene().objects.size()), at);
  }

  ModelScene& scene_;
  std::uint64_t seed_;
  std::size_t table_ = 0, chair_ = 0, cupboard_ = 0, lamp_ = 0;
  std::size_t sofas_[3] = {}, bookcases_[4] = {}, plants_[3] = {};
};

void expect_totals(const Scene& scene) {
  std::size_t n = 0;
  for (const SceneObject& object : scene.objects) n += n_triangles(scene, object);
  if (scene.objects.size() == kInteriorModels && n == kInteriorTriangles) return;
  throw Error(ErrorKind::bad_input, "interior: expected 124 models and 629336 triangles, found " +
                                        std::to_string(scene.objects.size()) + " and " + std::to_string(n));
}

}  // namespace

Scene interior(std::uint64_t seed) {
  ModelScene scene("interior124");
  Furnisher(scene, seed).furnish();
  add_room_walls(scene);
  add_room_walk(scene);
  expect_totals(scene.scene());
  return std::move(scene).take();
}

}  // namespace lode::geometry
