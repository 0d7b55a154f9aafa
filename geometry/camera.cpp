#include "geometry/camera.h"

#include <cmath>
#include <glm/geometric.hpp>
#include <string>

#include "geometry/error.h"
#include "geometry/trigonometry.h"

namespace lode::geometry {
namespace {

bool finite(const glm::dvec3& v) { return std::isfinite(v.x) && std::isfinite(v.y) && std::isfinite(v.z); }

[[noreturn]] void fail(const std::string& message) { throw Error(ErrorKind::bad_input, "camera: " + message); }

/// Unit length, whatever the magnitude: scaled first, so that no square overflows or vanishes.
glm::dvec3 unit(const glm::dvec3& v) {
  const double largest = std::fmax(std::fabs(v.x), std::fmax(std::fabs(v.y), std::fabs(v.z)));
  const glm::dvec3 scaled = v / largest;
  return scaled / std::sqrt(glm::dot(scaled, scaled));
}

bool is_zero(const glm::dvec3& v) { return v.x == 0.0 && v.y == 0.0 && v.z == 0.0; }

/// Right is along up × back; where that (nearly) vanishes, up is replaced by the axis that is least along the view.
void set_frame(Camera& camera, const glm::dvec3& back, const glm::dvec3& up) {
  camera.back = unit(back);
  const glm::dvec3 a = glm::abs(camera.back);
  const glm::dvec3 least =
      a.x <= a.y && a.x <= a.z ? glm::dvec3(1, 0, 0) : (a.y <= a.z ? glm::dvec3(0, 1, 0) : glm::dvec3(0, 0, 1));
  const glm::dvec3 wanted = is_zero(up) ? least : unit(up);
  glm::dvec3 right = glm::cross(wanted, camera.back);
  if (!(glm::dot(right, right) > 1e-20)) right = glm::cross(least, camera.back);
  camera.right = unit(right);
  camera.up = glm::cross(camera.back, camera.right);
}

}  // namespace

glm::dmat4 camera_from_world(const Camera& camera) {
  const auto row = [&](const glm::dvec3& axis) { return glm::dvec4(axis, -glm::dot(axis, camera.eye)); };
  return glm::transpose(glm::dmat4(row(camera.right), row(camera.up), row(camera.back), glm::dvec4(0, 0, 0, 1)));
}

glm::dvec2 half_extent(const Camera& camera, glm::ivec2 size_px) {
  const double aspect = size_px.y > 0 ? double(size_px.x) / double(size_px.y) : 1.0;
  const double y = camera.projection == Projection::perspective ? camera.tan_half_fov_y : 0.5 * camera.height;
  return {y * (aspect > 0.0 ? aspect : 1.0), y};
}

glm::dmat4 clip_from_camera(const Camera& camera, glm::ivec2 size_px) {
  const glm::dvec2 half = half_extent(camera, size_px);
  const double n = camera.near, f = camera.far;
  glm::dmat4 m(0.0);  // columns; camera z is −d
  m[0][0] = 1.0 / half.x;
  m[1][1] = 1.0 / half.y;
  if (camera.projection == Projection::orthographic) {  // depth (f − d)/(f − n), w = 1
    m[2][2] = 1.0 / (f - n);
    m[3][2] = f / (f - n);
    m[3][3] = 1.0;
    return m;
  }
  m[2][3] = -1.0;  // w = d
  if (std::isinf(f)) {
    m[3][2] = n;  // n/d
  } else {        // n(f − d)/(f − n), over w = d
    m[2][2] = n / (f - n);
    m[3][2] = n * (f / (f - n));
  }
  return m;
}

glm::dmat4 clip_from_world(const Camera& camera, glm::ivec2 size_px) {
  return clip_from_camera(camera, size_px) * camera_from_world(camera);
}

ViewRay view_ray(const Camera& camera, glm::ivec2 size_px, glm::dvec2 p_px) {
  const glm::dvec2 half = half_extent(camera, size_px);
  const double x = half.x * (2.0 * p_px.x / double(size_px.x) - 1.0);
  const double y = half.y * (1.0 - 2.0 * p_px.y / double(size_px.y));
  if (camera.projection == Projection::orthographic) return {{x, y, 0.0}, {0.0, 0.0, -1.0}};
  return {{0.0, 0.0, 0.0}, {x, y, -1.0}};
}

void look_at(Camera& camera, const glm::dvec3& eye, const glm::dvec3& target, const glm::dvec3& up) {
  if (!finite(eye) || !finite(target) || !finite(up)) fail("eye, target and up: expected finite numbers");
  const glm::dvec3 back = 0.5 * eye - 0.5 * target;  // halved: no overflow
  if (is_zero(back)) fail("the eye is at the point looked at: expected two different points");
  camera.eye = eye;
  set_frame(camera, back, up);
}

Camera framing_camera(const Bounds& bounds, glm::ivec2 size_px) {
  const glm::dvec3 centre = bounds.centre();
  const double diagonal = bounds.diagonal() > 0.0 && std::isfinite(bounds.diagonal()) ? bounds.diagonal() : 1.0;
  Camera camera;
  camera.near = diagonal / 1000.0;
  const SinCos above = sin_cos(kPi / 12.0);
  set_frame(camera, glm::dvec3(0.0, above.sin, above.cos), glm::dvec3(0.0, 1.0, 0.0));
  // As near as shows every corner with a twentieth of the picture to spare: |x| ≤ 0.9 half.x (distance − z), likewise y.
  const glm::dvec2 half = 0.9 * half_extent(camera, size_px);
  double distance = 2.0 * camera.near;
  const glm::dvec3 to_corner = bounds.diagonal() > 0.0 && std::isfinite(bounds.diagonal())
                                   ? 0.5 * bounds.high - 0.5 * bounds.low
                                   : glm::dvec3(0.5);
  for (int i = 0; i < 8; ++i) {
    const glm::dvec3 corner = to_corner * glm::dvec3(i & 1 ? 1 : -1, i & 2 ? 1 : -1, i & 4 ? 1 : -1);
    const double x = std::fabs(glm::dot(corner, camera.right)), y = std::fabs(glm::dot(corner, camera.up));
    distance = std::fmax(distance, glm::dot(corner, camera.back) + std::fmax(x / half.x, y / half.y));
    distance = std::fmax(distance, glm::dot(corner, camera.back) + 2.0 * camera.near);
  }
  camera.eye = centre + distance * camera.back;
  return camera;
}

Camera orbited(const Camera& camera, const glm::dvec3& centre, double angle_rad) {
  const SinCos t = sin_cos(angle_rad);
  const auto turned = [&](const glm::dvec3& v) {
    return glm::dvec3(t.cos * v.x + t.sin * v.z, v.y, t.cos * v.z - t.sin * v.x);
  };
  Camera result = camera;
  result.eye = centre + turned(camera.eye - centre);
  result.right = turned(camera.right);
  result.up = turned(camera.up);
  result.back = turned(camera.back);
  return result;
}

void check(const Camera& camera) {
  if (!finite(camera.eye)) fail("eye: expected finite numbers");
  const bool perspective = camera.projection == Projection::perspective;
  if (perspective && !(camera.tan_half_fov_y > 0.0 && std::isfinite(camera.tan_half_fov_y))) {
    fail("field of view: expected an angle between 0 and 180 degrees");
  }
  if (!perspective && !(camera.height > 0.0 && std::isfinite(camera.height))) fail("height: expected a number above 0");
  if (!std::isfinite(camera.near) || (perspective && !(camera.near > 0.0))) fail("near: expected a number above 0");
  if (!perspective && std::isinf(camera.far)) fail("far: expected a finite number for an orthographic view");
  if (!(camera.far > camera.near)) {
    fail("far: expected a number above near, which is " + std::to_string(camera.near) + ", found " +
         std::to_string(camera.far));
  }
}

}  // namespace lode::geometry
