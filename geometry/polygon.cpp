#include "geometry/polygon.h"

#include <algorithm>
#include <cmath>
#include <glm/geometric.hpp>
#include <glm/vec2.hpp>

#include "geometry/predicates.h"

namespace lode::geometry {
namespace {

/// Twice the areas of the polygon's projections along x, y and z. Newell's method, from the first corner, so that large
/// coordinates do not cancel.
glm::dvec3 newell_normal(std::span<const glm::vec3> corners) {
  glm::dvec3 normal(0.0);
  const glm::dvec3 origin(corners[0]);
  for (std::size_t i = 1; i + 1 < corners.size(); ++i) {
    normal += glm::cross(glm::dvec3(corners[i]) - origin, glm::dvec3(corners[i + 1]) - origin);
  }
  return normal;
}

/// The corners seen against the normal's greatest component: counter-clockwise.
std::vector<glm::dvec2> projected(std::span<const glm::vec3> corners, const glm::dvec3& normal) {
  const glm::dvec3 size = glm::abs(normal);
  const int axis = size.x >= size.y && size.x >= size.z ? 0 : size.y >= size.z ? 1 : 2;
  int u = (axis + 1) % 3, v = (axis + 2) % 3;
  if (normal[axis] < 0.0) std::swap(u, v);
  std::vector<glm::dvec2> points;
  points.reserve(corners.size());
  for (const glm::vec3& p : corners) points.emplace_back(p[u], p[v]);
  return points;
}

/// Cuts ears off until three corners are left.
class EarClipper {
 public:
  explicit EarClipper(const std::vector<glm::dvec2>& points) : points_(points), n_left_(points.size()) {
    for (std::uint32_t i = 0; i < points.size(); ++i) {
      previous_.push_back(i == 0 ? std::uint32_t(points.size() - 1) : i - 1);
      next_.push_back(i + 1 == points.size() ? 0 : i + 1);
    }
    for (std::uint32_t i = 0; i < points.size(); ++i) turns_left_.push_back(turn(i) > 0);
    n_tests_left_ = 4 * points.size() * points.size();
  }

  [[nodiscard]] bool is_convex() const {
    for (std::uint32_t i = 0; i < points_.size(); ++i) {
      if (turn(i) < 0) return false;
    }
    return true;
  }

  void clip(std::vector<std::uint32_t>& triangles) {
    std::uint32_t at = 0;
    std::size_t n_refused = 0;  // since the last ear; after a whole turn, any corner will do
    while (n_left_ > 3) {
      if (n_refused < n_left_ && n_tests_left_ > 0 && !is_ear(at)) {
        at = next_[at];
        ++n_refused;
        continue;
      }
      triangles.insert(triangles.end(), {previous_[at], at, next_[at]});
      at = remove(at);
      n_refused = 0;
    }
    triangles.insert(triangles.end(), {previous_[at], at, next_[at]});
  }

  [[nodiscard]] std::uint64_t n_tests() const { return n_tests_; }

 private:
  [[nodiscard]] int turn(std::uint32_t i) const {
    return orientation(points_[previous_[i]], points_[i], points_[next_[i]]);
  }

  /// A corner that turns left, with no other corner in the closed triangle that it would take away. Corners at the
  /// places of that triangle's own do not count: an edge to a hole and back has its ends twice.
  bool is_ear(std::uint32_t i) {
    if (!turns_left_[i]) return false;
    const glm::dvec2 &a = points_[previous_[i]], &b = points_[i], &c = points_[next_[i]];
    for (std::uint32_t k = next_[next_[i]]; k != previous_[i]; k = next_[k]) {
      if (n_tests_left_ > 0) --n_tests_left_;
      ++n_tests_;
      const glm::dvec2& p = points_[k];
      if (turns_left_[k] || p == a || p == b || p == c) continue;  // if any is inside, one that turns right is
      if (orientation(a, b, p) >= 0 && orientation(b, c, p) >= 0 && orientation(c, a, p) >= 0) return false;
    }
    return true;
  }

  /// Returns the corner before the one removed: in a narrow strip the next ear is there, or one further.
  std::uint32_t remove(std::uint32_t i) {
    const std::uint32_t before = previous_[i], after = next_[i];
    next_[before] = after;
    previous_[after] = before;
    --n_left_;
    turns_left_[before] = turn(before) > 0;
    turns_left_[after] = turn(after) > 0;
    return before;
  }

  const std::vector<glm::dvec2>& points_;
  std::vector<std::uint32_t> previous_, next_;  ///< around the corners that are left
  std::vector<bool> turns_left_;
  std::size_t n_left_, n_tests_left_ = 0;
  std::uint64_t n_tests_ = 0;
};

void append_fan(std::size_t n, std::vector<std::uint32_t>& triangles) {
  for (std::uint32_t i = 1; i + 1 < n; ++i) triangles.insert(triangles.end(), {0u, i, i + 1});
}

}  // namespace

bool triangulate(std::span<const glm::vec3> corners, std::vector<std::uint32_t>& triangles, std::uint64_t* n_tests) {
  const glm::dvec3 normal = corners.size() > 3 ? newell_normal(corners) : glm::dvec3(0.0);
  if (normal == glm::dvec3(0.0)) {
    append_fan(corners.size(), triangles);
    return true;
  }
  const std::vector<glm::dvec2> points = projected(corners, normal);
  EarClipper clipper(points);
  if (clipper.is_convex()) {
    append_fan(corners.size(), triangles);
  } else if (corners.size() > kMaxConcaveCorners) {
    return false;
  } else {
    clipper.clip(triangles);
    if (n_tests) *n_tests += clipper.n_tests();
  }
  return true;
}

}  // namespace lode::geometry
