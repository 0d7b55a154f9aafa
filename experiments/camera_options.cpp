#include "experiments/camera_options.h"

#include <CLI/CLI.hpp>
#include <algorithm>
#include <cmath>
#include <limits>

#include "experiments/error.h"
#include "experiments/option_values.h"
#include "geometry/error.h"
#include "geometry/trigonometry.h"

namespace lode::experiments {
namespace {

[[noreturn]] void fail(const std::string& message) { throw Error(Status::wrong_usage, message); }

/// Options that only say how a placed camera sees are nothing without its place.
void check_combination(const CameraOptions& o) {
  const std::pair<const char*, const std::optional<std::string>*> placing[] = {
      {"--eye", &o.eye},     {"--look-at", &o.look_at}, {"--up", &o.up},  {"--fov", &o.fov},
      {"--ortho", &o.ortho}, {"--near", &o.near},       {"--far", &o.far}};
  for (const auto& [name, value] : placing) {
    if (!*value) continue;
    if (o.camera)
      fail("--camera and " + std::string(name) + ": expected one of the scene's cameras, or one placed by --eye");
    if (!o.eye || !o.look_at) fail(std::string(name) + ": expected --eye and --look-at with it");
  }
  if (o.fov && o.ortho) fail("--fov and --ortho: expected one of them");
}

double read_positive(const char* option, const std::string& text) {
  const double value = read_number(option, text);
  if (!(value > 0.0)) fail_value(option, "a number above 0", text);
  return value;
}

PlacedCamera read_placed(const CameraOptions& o) {
  PlacedCamera placed;
  placed.eye = read_vector("--eye", *o.eye);
  placed.target = read_vector("--look-at", *o.look_at);
  if (placed.eye == placed.target)
    fail("--eye and --look-at: expected two different points, found " + *o.eye + " twice");
  if (o.up) placed.up = read_vector("--up", *o.up);
  if (placed.up == glm::dvec3(0.0)) fail_value("--up", "a direction, not 0,0,0", *o.up);
  if (o.fov) placed.fov_deg = read_number("--fov", *o.fov);
  if (!(placed.fov_deg > 0.0 && placed.fov_deg < 180.0)) fail_value("--fov", "degrees between 0 and 180", *o.fov);
  if (o.ortho) placed.ortho_height = read_positive("--ortho", *o.ortho);
  if (o.near) placed.near = o.ortho ? read_number("--near", *o.near) : read_positive("--near", *o.near);
  if (o.far && *o.far == "inf") {
    if (o.ortho) fail("--ortho with --far inf: expected a finite far plane");
    placed.far = std::numeric_limits<double>::infinity();
  } else if (o.far) {
    const std::optional<double> far = number_in(*o.far);
    if (!far) fail_value("--far", "a number or inf", *o.far);
    placed.far = far;
  }
  return placed;
}

/// The view distance of the box's farthest corner.
double farthest(const geometry::Camera& camera, const geometry::Bounds& bounds) {
  double distance = -std::numeric_limits<double>::infinity();
  for (int corner = 0; corner < 8; ++corner) {
    const glm::dvec3 p((corner & 1) ? bounds.high.x : bounds.low.x, (corner & 2) ? bounds.high.y : bounds.low.y,
                       (corner & 4) ? bounds.high.z : bounds.low.z);
    distance = std::max(distance, -glm::dot(camera.back, p - camera.eye));
  }
  return distance;
}

geometry::Camera place(const PlacedCamera& placed, const geometry::Bounds& bounds) {
  geometry::Camera camera;
  const double extent = bounds.diagonal() > 0.0 && std::isfinite(bounds.diagonal()) ? bounds.diagonal() : 1.0;
  geometry::look_at(camera, placed.eye, placed.target, placed.up);
  camera.near = placed.near.value_or(extent / 1000.0);
  if (placed.ortho_height) {
    camera.projection = geometry::Projection::orthographic;
    camera.height = *placed.ortho_height;
    const double end = bounds.empty() ? camera.near : std::max(farthest(camera, bounds), camera.near);
    camera.far = placed.far.value_or(end + extent / 1000.0);
  } else {
    camera.tan_half_fov_y = geometry::tangent(placed.fov_deg * geometry::kPi / 360.0);
    camera.far = placed.far.value_or(std::numeric_limits<double>::infinity());
  }
  try {
    geometry::check(camera);
  } catch (const geometry::Error& error) {
    fail(error.what());
  }
  return camera;
}

/// "PATH FRAME": any frame of a walk.
std::optional<geometry::Camera> camera_on_path(const std::string& name, const geometry::Scene& scene) {
  const std::size_t space = name.rfind(' ');
  if (space == std::string::npos) return std::nullopt;
  const std::optional<std::int64_t> frame = whole_number_in(std::string_view(name).substr(space + 1));
  for (const geometry::CameraPath& path : scene.paths) {
    if (frame && *frame < path.n_frames && name.substr(0, space) == path.name) return camera_at(path, int(*frame));
  }
  return std::nullopt;
}

geometry::Camera named_camera(const std::string& name, const geometry::Scene& scene) {
  for (const geometry::SceneCamera& c : scene.cameras) {
    if (c.name == name) return c.camera;
  }
  const std::optional<std::int64_t> index = whole_number_in(name);
  if (index && std::size_t(*index) < scene.cameras.size()) return scene.cameras[std::size_t(*index)].camera;
  if (const std::optional<geometry::Camera> camera = camera_on_path(name, scene)) return *camera;
  std::string known;
  for (std::size_t i = 0; i < scene.cameras.size() && known.size() < 200; ++i) {
    known += (i == 0 ? "" : ", ") + std::to_string(i) + " \"" + shortened(scene.cameras[i].name, 40) + "\"";
  }
  for (const geometry::CameraPath& path : scene.paths) {
    known += std::string(known.empty() ? "" : ", ") + "\"" + shortened(path.name, 40) + " FRAME\" up to " +
             std::to_string(path.n_frames - 1);
  }
  throw Error(Status::bad_input, scene.name + ": no camera \"" + shortened(name, 60) +
                                     "\": " + (known.empty() ? "the scene has none" : "expected one of " + known));
}

}  // namespace

void add_camera_options(CLI::App& app, CameraOptions& o) {
  const auto add = [&](const char* name, std::optional<std::string>& value, const char* type, const char* help) {
    app.add_option(name, value, help)->option_text(type)->group("Camera");
  };
  add("--camera", o.camera, "NAME|INDEX",
      "One of the scene's cameras, or \"PATH FRAME\" of a walk (default the first; with none, one that frames the "
      "scene)");
  add("--eye", o.eye, "X,Y,Z", "A camera here instead: right-handed, y up");
  add("--look-at", o.look_at, "X,Y,Z", "... that looks there");
  add("--up", o.up, "X,Y,Z", "... with this direction up (default 0,1,0)");
  add("--fov", o.fov, "DEG", "... with this vertical field of view (default 45)");
  add("--ortho", o.ortho, "HEIGHT", "... or orthographic, with this height of the view");
  add("--near", o.near, "N", "Near plane (default a thousandth of the scene's diagonal)");
  add("--far", o.far, "F|inf", "Far plane (default inf; with --ortho just behind the scene)");
}

CameraChoice read_camera_options(const CameraOptions& options) {
  check_combination(options);
  CameraChoice choice;
  choice.name = options.camera;
  if (options.eye) choice.placed = read_placed(options);
  return choice;
}

geometry::Camera choose_camera(const CameraChoice& choice, const geometry::Scene& scene, const geometry::Bounds& bounds,
                               glm::ivec2 size_px) {
  if (choice.placed) return place(*choice.placed, bounds);
  if (choice.name) return named_camera(*choice.name, scene);
  if (!scene.cameras.empty()) return scene.cameras.front().camera;
  return geometry::framing_camera(bounds, size_px);
}

}  // namespace lode::experiments
