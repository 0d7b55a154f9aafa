#pragma once
/// Axis-aligned boxes.

#include <glm/common.hpp>
#include <glm/geometric.hpp>
#include <glm/vec3.hpp>
#include <limits>

namespace lode::geometry {

/// The closed box [low, high]; a new one is empty and grows by what is added to it.
struct Bounds {
  glm::dvec3 low{std::numeric_limits<double>::infinity()};
  glm::dvec3 high{-std::numeric_limits<double>::infinity()};

  [[nodiscard]] bool empty() const { return !(low.x <= high.x && low.y <= high.y && low.z <= high.z); }
  [[nodiscard]] glm::dvec3 centre() const { return empty() ? glm::dvec3(0.0) : 0.5 * low + 0.5 * high; }
  [[nodiscard]] double diagonal() const { return empty() ? 0.0 : glm::length(high - low); }

  /// A point with a NaN adds nothing.
  void add(const glm::dvec3& p) {
    if (!(p.x == p.x && p.y == p.y && p.z == p.z)) return;
    low = glm::min(low, p);
    high = glm::max(high, p);
  }
};

}  // namespace lode::geometry
