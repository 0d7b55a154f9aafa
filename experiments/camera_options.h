#pragma once
/// The camera of a command: the scene's own, or one that the command line places, or one that frames the scene.

#include <optional>
#include <string>

#include "geometry/scene.h"

namespace CLI {
class App;
}

namespace lode::experiments {

/// As the words stand on the command line.
struct CameraOptions {
  std::optional<std::string> camera, eye, look_at, up, fov, ortho, near, far;
};

void add_camera_options(CLI::App& app, CameraOptions& options);

/// A camera that the command line places; what it leaves open depends on the scene.
struct PlacedCamera {
  glm::dvec3 eye{0.0}, target{0.0}, up{0.0, 1.0, 0.0};
  double fov_deg = 45.0;               ///< vertical; perspective
  std::optional<double> ortho_height;  ///< orthographic where given
  std::optional<double> near;          ///< default: a thousandth of the scene's diagonal, or of 1 where that is 0
  std::optional<double> far;  ///< default: infinite; orthographic: a thousandth of the diagonal behind the scene's end
};

/// What the words ask for: at most one of the two, and with neither the scene's first camera, or one that frames it.
struct CameraChoice {
  std::optional<std::string> name;  ///< or index
  std::optional<PlacedCamera> placed;
};

/// Throws Error (wrong_usage): a value out of range, or options that contradict each other.
[[nodiscard]] CameraChoice read_camera_options(const CameraOptions& options);

/// Throws Error: bad_input where the scene has no such camera; wrong_usage where near and far do not fit.
[[nodiscard]] geometry::Camera choose_camera(const CameraChoice& choice, const geometry::Scene& scene,
                                             const geometry::Bounds& bounds, glm::ivec2 size_px);

}  // namespace lode::experiments
