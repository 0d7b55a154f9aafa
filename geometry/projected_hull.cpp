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

bool is_in_front(const glm::dvec4& p_clip) { return in_front(p_clip) > 0.0 && p_clip.w > 0.0; }

/// Where the lines between points on either side meet the near plane.
void add_cuts(std::span<const glm::vec3> p_object, const glm::dmat4& clip_from_object, const glm::dvec2& size_px,
              ProjectedHull& hull) {
  for (const glm::vec3& p : p_object) {
    const glm::dvec4 a = clip_from_object * glm::dvec4(p, 1.0);
    if (!is_in_front(a)) continue;
    for (const glm::vec3& q : p_object) {
      const glm::dvec4 b = clip_from_object * glm::dvec4(q, 1.0);
      if (is_in_front(b)) continue;
      const double t = in_front(a) / (in_front(a) - in_front(b));
      const glm::dvec4 cut = a + t * (b - a);
      if (t <= 1.0 && cut.w > 0.0) add(hull, cut, size_px);
    }
  }
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
  project_hull(p_object, clip_from_object, size_px, hull);
  return hull;
}

void project_hull(std::span<const glm::vec3> p_object, const glm::dmat4& clip_from_object, const glm::dvec2& size_px,
                  ProjectedHull& hull) {
  hull.near_plane = NearPlane::behind;
  hull.points_px.clear();
  hull.nearest_depth = 0.0;
  hull.farthest_depth = 1.0;
  std::size_t n_behind = 0;
  for (const glm::vec3& p : p_object) {
    const glm::dvec4 p_clip = clip_from_object * glm::dvec4(p, 1.0);
    if (!is_finite(p_clip)) {
      hull = {NearPlane::crosses, {}, 1.0, 0.0};
      return;
    }
    if (is_in_front(p_clip)) {
      add(hull, p_clip, size_px);
    } else {
      ++n_behind;
    }
  }
  if (n_behind == p_object.size()) return;
  hull.near_plane = n_behind == 0 ? NearPlane::in_front : NearPlane::crosses;
  if (n_behind > 0) add_cuts(p_object, clip_from_object, size_px, hull);
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
