#include "experiments/scene_options.h"

#include <CLI/CLI.hpp>
#include <filesystem>

#include "experiments/error.h"
#include "experiments/option_values.h"
#include "experiments/sample_positions.h"
#include "experiments/scenes/builtin_scene.h"
#include "geometry/model_file.h"

namespace lode::experiments {
namespace {

geometry::Scene open_scene(const std::string& name) {
  std::error_code ignored;
  const bool is_file = geometry::is_model_file(name) || std::filesystem::exists(name, ignored);
  if (names_builtin_scene(name) || !is_file) return make_builtin_scene(name);
  return geometry::read_model_file(name);
}

}  // namespace

void add_scene_options(CLI::App& app, SceneOptions& options) {
  app.add_option("SCENE", options.scene,
                 "A model file (.gltf, .glb, .obj, .ply, .stl), or a built-in scene: NAME[:k=v,...]")
      ->required();
  add_camera_options(app, options.camera);
  app.add_option("--size", options.size, "Of the picture, in pixels (default 1280x720)")->option_text("WxH");
  app.add_option("--samples", options.samples, "Samples a pixel, averaged: a power of two up to 128 (default 1)")
      ->option_text("N");
}

ViewRequest read_scene_options(const SceneOptions& options) {
  ViewRequest request;
  request.scene = options.scene;
  request.camera = read_camera_options(options.camera);
  request.size_px = read_size("--size", options.size);
  const std::optional<std::int64_t> n = whole_number_in(options.samples);
  if (!n || *n < 1 || *n > 128 || (*n & (*n - 1)) != 0) {
    fail_value("--samples", "a power of two up to 128", options.samples);
  }
  request.n_samples = int(*n);
  return request;
}

SceneView open_view(const ViewRequest& request) {
  SceneView view;
  view.scene = open_scene(request.scene);
  view.bounds = view.scene.bounds();
  view.camera = choose_camera(request.camera, view.scene, view.bounds, request.size_px);
  view.size_px = request.size_px;
  view.samples_fx8 = sample_positions_fx8(request.n_samples);
  return view;
}

}  // namespace lode::experiments
