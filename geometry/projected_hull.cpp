#include "geometry/projected_hull.h"

#include <algorithm>
#include <cmath>
#include <limits>

namespace lode::geometry {
namespace {

/// How far in front of the near plane, z ≤ w (C4), in units of w.
double in_front(const glm::dvec4& p_clip) { return p_clip.w - p_clip.z; }

bool is_finite(const glm::dvec4& p) {
  return std::isfinite(p.x) && std::isfinite(p.y) && std::isfinite(p.z) && std::isfinite(p.w);
}

void add(ProjectedHull& hull, const glm::dvec4& p_clip, const glm::dvec2& size_px) {
  const double x = p_clip.x / p_clip.w, y = p_clip.y / p_clip.w, depth = p_clip.z / p_clip.w;
  hull.points_px.emplace_back((0.5 + 0.5 * x) * size_px.x, (0.5 - 0.5 * y) * size_px.y);
  hull.nearest_depth = std::max(hull.nearest_depth, depth);
  hull.farthest_depth = std::min(hull.farthest_depth, depth);
}

/// A float that is no less, or no greater, than the double.
float rounded(double x, bool up) {
  const float nearest = float(x);
  constexpr float kInfinity = std::numeric_limits<float>::infinity();
  if (up ? double(nearest) >= x : double(nearest) <= x) return nearest;
  return std::nextafter(nearest, up ? kInfinity : -kInfinity);
}

}  // namespace

ProjectedHull project_hull(std::span<const glm::vec3> p_object, const glm::dmat4& clip_from_object,
                           const glm::dvec2& size_px) {
  ProjectedHull hull;
  std::vector<glm::dvec4> front, behind;
  for (const glm::vec3& p : p_object) {
    const glm::dvec4 p_clip = clip_from_object * glm::dvec4(p, 1.0);
    if (!is_finite(p_clip)) return {NearPlane::crosses, {}, 1.0, 0.0};
    (in_front(p_clip) > 0.0 && p_clip.w > 0.0 ? front : behind).push_back(p_clip);
  }
  if (front.empty()) return hull;
  hull.near_plane = behind.empty() ? NearPlane::in_front : NearPlane::crosses;
  for (const glm::dvec4& a : front) {
    add(hull, a, size_px);
    for (const glm::dvec4& b : behind) {
      const double t = in_front(a) / (in_front(a) - in_front(b));
      const glm::dvec4 cut = a + t * (b - a);
      if (t <= 1.0 && cut.w > 0.0) add(hull, cut, size_px);
    }
  }
  return hull;
}

std::array<glm::vec3, 8> corners(const Bounds& box) {
  std::array<glm::vec3, 8> result;
  for (std::size_t i = 0; i < 8; ++i) {
    for (int axis = 0; axis < 3; ++axis) {
      const bool high = (i >> axis & 1) != 0;
      result[i][axis] = rounded((high ? box.high : box.low)[axis], high);
    }
  }
  return result;
}

}  // namespace lode::geometry
