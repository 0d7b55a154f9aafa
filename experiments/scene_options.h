#pragma once
/// What `render`, `truth` and `explain` are all asked for: a scene, a camera in it, a size, samples.

#include <glm/vec2.hpp>
#include <string>
#include <vector>

#include "experiments/camera_options.h"
#include "geometry/scene.h"

namespace CLI {
class App;
}

namespace lode::experiments {

/// As the words stand on the command line.
struct SceneOptions {
  std::string scene;
  CameraOptions camera;
  std::string size = "1280x720";
  std::string samples = "1";
};

/// SCENE, the camera, --size, --samples.
void add_scene_options(CLI::App& app, SceneOptions& options);

/// The options as far as they can be understood without the scene.
struct ViewRequest {
  std::string scene;
  CameraChoice camera;
  glm::ivec2 size_px{1280, 720};
  int n_samples = 1;  ///< a power of two, 1…128
};

/// Throws Error (wrong_usage).
[[nodiscard]] ViewRequest read_scene_options(const SceneOptions& options);

/// A scene as it is to be seen.
struct SceneView {
  geometry::Scene scene;
  geometry::Bounds bounds;  ///< of the scene
  geometry::Camera camera;
  glm::ivec2 size_px{0, 0};
  std::vector<glm::ivec2> samples_fx8;  ///< positions in a pixel
};

/// Reads or makes the scene: a built-in name (scenes/builtin_scene.h), otherwise a model file.
/// Throws Error or geometry::Error (bad_input).
[[nodiscard]] SceneView open_view(const ViewRequest& request);

}  // namespace lode::experiments
