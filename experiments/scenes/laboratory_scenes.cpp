#include "experiments/scenes/laboratory_scenes.h"

#include "geometry/procedural/furniture.h"

namespace lode::experiments {
namespace {

using geometry::Scene;

Scene only(const geometry::Model& model) {
  geometry::ModelScene scene(model.name);
  scene.place(model, model.name);
  return std::move(scene).take();
}

}  // namespace

std::vector<BuiltinScene> laboratory_scenes() {
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
  };
}

}  // namespace lode::experiments
