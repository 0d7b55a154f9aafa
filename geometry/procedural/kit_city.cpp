#include "geometry/procedural/kit.h"
#include "geometry/procedural/kit_scenes.h"
#include "geometry/procedural/parts.h"
#include "geometry/random.h"
#include "geometry/trigonometry.h"

namespace lode::geometry {
namespace {

// A unit of the kit is 5 m: its cars are 0.9 long, its tiles 2 × 2. Tile (i, j) is a street where i is a multiple of 5
// or j of 3: blocks are 4 × 2 houses back to back.
constexpr double kUnit = 5.0, kTile = 2.0 * kUnit;
constexpr int kTilesX = 21, kTilesZ = 13;
constexpr double kRoadHeight = 0.05 * kUnit, kPavementHeight = 0.1 * kUnit;

glm::dvec3 tile(double i, double j) {
  return {(i - 0.5 * (kTilesX - 1)) * kTile, 0.0, (j - 0.5 * (kTilesZ - 1)) * kTile};
}

bool along_z(int i) { return i % 5 == 0; }  // a street along z goes through the tiles of this column
bool along_x(int j) { return j % 3 == 0; }

std::string numbered(const char* before, const char* letters, Random& random, const char* after) {
  const std::string all = letters;
  return before + std::string(1, all[random.below(std::uint32_t(all.size()))]) + after;
}

/// Which piece of road a crossing of streets is, by how many arms it has, and its turn.
void add_crossing(Kit& kit, int i, int j) {
  const bool west = i > 0, east = i + 1 < kTilesX, north = j > 0, south = j + 1 < kTilesZ;
  const int arms = int(west) + int(east) + int(north) + int(south);
  if (arms == 4) return kit.place("road_junction.gltf", turned_frame(tile(i, j), 0.0));
  const double quarter = 0.5 * kPi;
  if (arms == 3) {
    const double turn = !south ? 0.0 : (!east ? quarter : (!north ? 2.0 * quarter : 3.0 * quarter));
    return kit.place("road_tsplit.gltf", turned_frame(tile(i, j), turn));
  }
  const double turn = south && east ? 0.0 : (north && east ? quarter : (north && west ? 2.0 * quarter : 3.0 * quarter));
  kit.place("road_corner.gltf", turned_frame(tile(i, j), turn));
}

void add_tiles(Kit& kit, std::uint64_t seed) {
  for (int j = 0; j < kTilesZ; ++j) {
    for (int i = 0; i < kTilesX; ++i) {
      Random random(seed, 1, std::uint64_t(j * kTilesX + i));
      if (along_z(i) && along_x(j)) {
        add_crossing(kit, i, j);
      } else if (along_z(i) || along_x(j)) {
        const bool walk = along_x(j) && (i % 5 == 1 || i % 5 == 4) && random.below(2) == 0;
        kit.place(walk ? "road_straight_crossing.gltf" : "road_straight.gltf",
                  turned_frame(tile(i, j), along_x(j) ? 0.5 * kPi : 0.0));
      } else {
        const bool faces_north = j % 3 == 1;
        kit.place(numbered("building_", "ABCDEFGH", random, ".gltf"),
                  turned_frame(tile(i, j), faces_north ? kPi : 0.0));
      }
    }
  }
}

void add_cars(Kit& kit, std::uint64_t seed) {
  const char* cars[] = {"car_hatchback.gltf", "car_police.gltf", "car_sedan.gltf", "car_stationwagon.gltf",
                        "car_taxi.gltf"};
  // Four in ten of the places: three a block on either side of each street along x.
  constexpr int kPlaces = 3;
  for (int k = 0; k < 5 * 4 * kPlaces * 2; ++k) {
    Random random(seed, 2, std::uint64_t(k));
    if (random.below(10) >= 4) continue;
    const int street = 3 * (k % 5), column = k / 5 % 4, place = k / 20 % kPlaces;
    const double side = k / 20 / kPlaces == 0 ? 1.0 : -1.0,
                 i = 5.0 * column + 1.2 + 1.3 * place + random.uniform(-0.2, 0.2);
    const glm::dvec3 at = tile(i, street) + glm::dvec3(0.0, kRoadHeight, side * 0.42 * kUnit);
    kit.stand(cars[random.below(5)], turned_frame(at, side * 0.5 * kPi));
  }
}

void add_street_furniture(Kit& kit, std::uint64_t seed) {
  const char* small[] = {"firehydrant.gltf", "bench.gltf", "trash_A.gltf", "bush.gltf", "box_A.gltf", "dumpster.gltf"};
  for (int j = 0; j < kTilesZ; j += 3) {
    for (int i = 0; i < kTilesX; ++i) {
      if (along_z(i)) continue;
      Random random(seed, 3, std::uint64_t(j * kTilesX + i));
      const double pavement = 0.86 * kUnit;
      for (const double side : {-1.0, 1.0}) {
        if ((j == 0 && side < 0.0) || (j + 1 == kTilesZ && side > 0.0)) continue;  // the edge of the city
        const glm::dvec3 edge = tile(i, j) + glm::dvec3(0.0, kPavementHeight, side * pavement);
        if (i % 2 == 0)
          kit.place("streetlight.gltf", turned_frame(edge, -side * 0.5 * kPi));  // its arm over the street
        if (random.below(3) != 0) continue;
        const glm::dvec3 beside = edge + glm::dvec3(random.uniform(1.5, 3.5), 0.0, side * 0.15 * kUnit);
        kit.stand(small[random.below(6)], turned_frame(beside, side > 0.0 ? kPi : 0.0));
      }
    }
  }
}

}  // namespace

Scene kit_city(const std::string& folder, std::uint64_t seed) {
  ModelScene scene("kit_city");
  Kit kit(scene, folder, kUnit);
  add_tiles(kit, seed);
  add_cars(kit, seed);
  add_street_furniture(kit, seed);
  constexpr double kEye = 1.7;
  const auto on = [&](double i, double j) { return tile(i, j) + glm::dvec3(0.0, kEye, 0.0); };
  const std::vector<glm::dvec3> street = {on(0.5, 3), on(10, 3), on(10, 9), on(19.5, 9)};
  scene.add_path({"street", rounded_corners(street, 4.0), 600, 8.0});
  for (int j = 0; j < kTilesZ; j += 3) {
    const double half = 0.3 * kTile;
    scene.add_free_space({tile(0, j) + glm::dvec3(0.0, 1.2, -half), tile(kTilesX - 1, j) + glm::dvec3(0.0, 2.2, half)});
  }
  return std::move(scene).take();
}

}  // namespace lode::geometry
