#include "experiments/scenes/laboratory_scenes.h"

#include <cstdlib>
#include <string>

#include "experiments/error.h"
#include "geometry/procedural/furniture.h"
#include "geometry/procedural/house.h"
#include "geometry/procedural/houses.h"
#include "geometry/procedural/interior.h"
#include "geometry/procedural/kit_scenes.h"
#include "geometry/procedural/town.h"

namespace lode::experiments {
namespace {

using geometry::Scene;

Scene only(const geometry::Model& model) {
  geometry::ModelScene scene(model.name);
  scene.place(model, model.name);
  return std::move(scene).take();
}

/// A folder of the models that LODESTONE_ASSETS names.
std::string assets(const std::string& scene, const std::string& folder) {
  const char* root = std::getenv("LODESTONE_ASSETS");
  if (root == nullptr || *root == '\0') {
    throw Error(Status::bad_input, "scene " + scene + ": LODESTONE_ASSETS: expected the folder of the models, with " +
                                       folder + " in it, found nothing");
  }
  return std::string(root) + "/" + folder;
}

Scene rows_of_houses(int n_rows, int n_in_row, const SceneValues& v) {
  return geometry::houses({.n_rows = n_rows,
                           .n_in_row = n_in_row,
                           .n_each = std::size_t(v.at("each")) / 2 * 2,
                           .seed = std::uint64_t(v.at("seed"))});
}

}  // namespace

std::vector<BuiltinScene> laboratory_scenes() {
  const Parameter seed = {"seed", "of the random numbers", 0, 9007199254740992.0, 1, true};
  const Parameter each = {
      "each", "triangles of a house; an odd number is one less", double(geometry::kFewestHouseTriangles), 1e6, 4000,
      true};
  return {
      {"table",
       "A table of 3948 triangles and 2080 vertices",
       {},
       [](const SceneValues&) { return only(geometry::table()); }},
      {"chair",
       "A chair of 4617 triangles and 2390 vertices",
       {},
       [](const SceneValues&) { return only(geometry::chair()); }},
      {"sofa",
       "A sofa of 9280 triangles and 4652 vertices",
       {},
       [](const SceneValues&) { return only(geometry::sofa()); }},
      {"town179",
       "A town of 179 models and 973103 triangles, with two walks: street, roofs",
       {seed},
       [](const SceneValues& v) { return geometry::town(std::uint64_t(v.at("seed"))); }},
      {"interior124",
       "A flat of 124 models and 629336 triangles in 12 rooms, with a walk: rooms",
       {seed},
       [](const SceneValues& v) { return geometry::interior(std::uint64_t(v.at("seed"))); }},
      {"houses24",
       "A street of 24 houses, with two walks: approach, sideways",
       {each, seed},
       [](const SceneValues& v) { return rows_of_houses(2, 12, v); }},
      {"houses200",
       "200 houses in five streets, with two walks: approach, sideways",
       {each, seed},
       [](const SceneValues& v) { return rows_of_houses(10, 20, v); }},
      {"kit_city",
       "A street grid assembled from kits/kaykit-city in LODESTONE_ASSETS, with a walk: street",
       {seed},
       [](const SceneValues& v) {
         return geometry::kit_city(assets("kit_city", "kits/kaykit-city/gltf"), std::uint64_t(v.at("seed")));
       }},
      {"kit_dungeon",
       "Rooms and a corridor assembled from kits/kaykit-dungeon in LODESTONE_ASSETS, with a walk: rooms",
       {seed},
       [](const SceneValues& v) {
         return geometry::kit_dungeon(assets("kit_dungeon", "kits/kaykit-dungeon/glb"), std::uint64_t(v.at("seed")));
       }},
      {"kit_rooms",
       "A flat furnished from kits/kaykit-furniture and furniture-cc0 in LODESTONE_ASSETS, with a walk: rooms",
       {seed},
       [](const SceneValues& v) {
         return geometry::kit_rooms(assets("kit_rooms", "kits/kaykit-furniture/gltf"),
                                    assets("kit_rooms", "furniture-cc0"), std::uint64_t(v.at("seed")));
       }},
  };
}

}  // namespace lode::experiments
