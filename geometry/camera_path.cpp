#include "geometry/camera_path.h"

#include <algorithm>
#include <cmath>
#include <glm/geometric.hpp>

#include "geometry/error.h"

namespace lode::geometry {
namespace {

void check_path(const CameraPath& path, int frame) {
  const auto fail = [&](const std::string& message) {
    throw Error(ErrorKind::bad_input, "camera path " + path.name + ": " + message);
  };
  if (path.points.size() < 2) fail("expected 2 points or more, found " + std::to_string(path.points.size()));
  if (path.n_frames < 2) fail("expected 2 frames or more, found " + std::to_string(path.n_frames));
  if (frame < 0 || frame >= path.n_frames) {
    fail("expected a frame 0 to " + std::to_string(path.n_frames - 1) + ", found " + std::to_string(frame));
  }
  if (!(path.look_ahead > 0.0)) fail("expected a look_ahead above 0, found " + std::to_string(path.look_ahead));
}

}  // namespace

double length(const CameraPath& path) {
  double sum = 0.0;
  for (std::size_t i = 1; i < path.points.size(); ++i) sum += glm::distance(path.points[i - 1], path.points[i]);
  return sum;
}

glm::dvec3 point_along(const CameraPath& path, double distance) {
  std::size_t i = 0;
  double begin = 0.0;
  for (;; ++i) {
    const double side = glm::distance(path.points[i], path.points[i + 1]);
    if (distance <= begin + side || i + 2 == path.points.size()) {
      return path.points[i] + (path.points[i + 1] - path.points[i]) * ((distance - begin) / side);
    }
    begin += side;
  }
}

Camera camera_at(const CameraPath& path, int frame) {
  check_path(path, frame);
  const double distance = length(path) * (double(frame) / double(path.n_frames - 1));
  Camera camera = walking_camera();
  look_at(camera, point_along(path, distance), path.target.value_or(point_along(path, distance + path.look_ahead)));
  return camera;
}

std::vector<glm::dvec3> rounded_corners(std::span<const glm::dvec3> points, double radius) {
  constexpr int kPieces = 8;
  std::vector<glm::dvec3> result = {points.front()};
  for (std::size_t i = 1; i + 1 < points.size(); ++i) {
    const glm::dvec3 before = points[i - 1] - points[i], after = points[i + 1] - points[i];
    const double reach = std::min({radius, 0.499 * glm::length(before), 0.499 * glm::length(after)});
    const glm::dvec3 from = points[i] + glm::normalize(before) * reach, to = points[i] + glm::normalize(after) * reach;
    for (int k = 0; k <= kPieces; ++k) {
      const double t = double(k) / kPieces, s = 1.0 - t;
      result.push_back(s * s * from + 2.0 * s * t * points[i] + t * t * to);
    }
  }
  result.push_back(points.back());
  return result;
}

Camera walking_camera() {
  Camera camera;
  camera.tan_half_fov_y = std::sqrt(1.0 / 3.0);  // of 30°
  camera.near = 0.1;
  return camera;
}

}  // namespace lode::geometry
