#include "experiments/truth/tour.h"

#include <cmath>
#include <cstdio>
#include <glm/geometric.hpp>

#include "geometry/camera.h"

namespace lode::experiments::truth {
namespace {

std::string text(double number) {
  char digits[32];
  std::snprintf(digits, sizeof digits, "%.17g", number);
  return digits;
}

std::string text(const glm::dvec3& p) { return text(p.x) + "," + text(p.y) + "," + text(p.z); }

constexpr glm::dvec3 kUp{0.125, 1.0, 0.0625};  // rolled a little

CameraOptions from_to(const glm::dvec3& eye, const glm::dvec3& target) {
  CameraOptions options;
  options.eye = text(eye);
  options.look_at = text(target);
  options.up = text(kUp);
  return options;
}

/// Aims half a pixel beside the centre, at the corner of four pixels, so that a sample falls on the centre.
TourStop far_away(const glm::dvec3& centre, double d, glm::ivec2 size_px) {
  const double distance = 1000.0 * d;
  const glm::dvec3 eye = centre + distance * glm::normalize(glm::dvec3(0.4, 0.3, 1.0));
  geometry::Camera camera;
  geometry::look_at(camera, eye, centre, kUp);
  const double half_px = distance * geometry::half_extent(camera, size_px).y / size_px.y;
  return {"far_away", from_to(eye, centre + half_px * (camera.right + camera.up))};
}

}  // namespace

std::vector<TourStop> tour(const geometry::Bounds& bounds, glm::ivec2 size_px) {
  const bool sized = bounds.diagonal() > 0.0 && std::isfinite(bounds.diagonal());
  const double d = sized ? bounds.diagonal() : 1.0;
  const glm::dvec3 centre = bounds.centre();
  const auto beside = [&](const glm::dvec3& direction, double distance) {
    return from_to(centre + distance * d * glm::normalize(direction), centre);
  };
  std::vector<TourStop> stops;

  const geometry::Camera front = geometry::framing_camera(bounds, size_px);
  stops.push_back({"front", from_to(front.eye, front.eye - d * front.back)});
  stops.push_back({"diagonal_1", beside({1.0, 0.7, 1.1}, 1.2)});
  stops.push_back({"diagonal_2", beside({-1.3, -0.4, -0.8}, 1.2)});
  TourStop above{"above", beside({0.0, 1.0, 0.0}, 1.2)};
  above.options.up = "0.31,0,-0.95";
  stops.push_back(above);
  stops.push_back({"inside", from_to(centre, centre + d * glm::dvec3(0.3, -0.2, -1.0))});
  TourStop near_cut{"near_cut", beside({0.7, 0.5, 1.0}, 0.8)};
  near_cut.options.near = text(0.8 * d);
  stops.push_back(near_cut);
  stops.push_back(far_away(centre, d, size_px));
  TourStop orthographic{"orthographic", beside({0.9, 0.6, 1.3}, 1.2)};
  orthographic.options.ortho = text(1.1 * d);
  stops.push_back(orthographic);
  return stops;
}

std::string command_line(const CameraOptions& o) {
  std::string line;
  const auto add = [&](const char* name, const std::optional<std::string>& value) {
    if (value) line += std::string(" ") + name + " " + *value;
  };
  add("--camera", o.camera);
  add("--eye", o.eye);
  add("--look-at", o.look_at);
  add("--up", o.up);
  add("--fov", o.fov);
  add("--ortho", o.ortho);
  add("--near", o.near);
  add("--far", o.far);
  return line;
}

}  // namespace lode::experiments::truth
