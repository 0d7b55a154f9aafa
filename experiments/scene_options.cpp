#include "experiments/scene_options.h"

#include <CLI/CLI.hpp>
#include <cmath>
#include <filesystem>
#include <glm/common.hpp>

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

/// Beyond the rasterizer's range of clip coordinates (raster/frame.h: 2^300, and w from 2^-149 up) a picture would be a
/// wrong one.
void check_range(const SceneView& view) {
  if (view.bounds.empty()) return;
  const glm::dmat4 m = geometry::clip_from_world(view.camera, view.size_px);
  const glm::dvec3 far = glm::max(glm::abs(view.bounds.low), glm::abs(view.bounds.high));
  double largest = 0.0;
  for (int row = 0; row < 4; ++row) {
    const double sum = (std::abs(m[0][row]) * far.x + std::abs(m[1][row]) * far.y) +
                       (std::abs(m[2][row]) * far.z + std::abs(m[3][row]));
    largest = sum > largest || std::isnan(sum) ? sum : largest;
  }
  const auto fail = [&](const std::string& message) {
    throw Error(Status::bad_input, view.scene.name + ": with this camera " + message);
  };
  if (!(largest < 0x1p280)) {
    fail("clip coordinates are too large to draw: expected a wider view, or a scene nearer to the origin");
  }
  if (view.camera.projection == geometry::Projection::perspective && view.camera.near < 0x1p-140) {
    fail("the near plane is at less than 1e-42: expected a larger --near, or a larger scene");
  }
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
  check_range(view);
  return view;
}

}  // namespace lode::experiments
