#include "techniques/octahedral_impostors/hemi_octahedron.h"

#include <algorithm>
#include <cmath>
#include <glm/common.hpp>
#include <glm/geometric.hpp>

namespace lode::techniques {

glm::dvec2 octahedral_from_direction(const glm::dvec3& direction) {
  const double up = std::max(direction.y, 0.0), length = std::abs(direction.x) + std::abs(direction.z) + up;
  if (!(length > 0.0)) return glm::dvec2(0.0);
  const double x = direction.x / length, z = direction.z / length;
  return {x + z, x - z};
}

glm::dvec3 direction_from_octahedral(const glm::dvec2& point) {
  const glm::dvec2 p = glm::clamp(point, -1.0, 1.0);
  const double x = 0.5 * (p.x + p.y), z = 0.5 * (p.x - p.y);
  // |x| + |z| is the larger of the two: written so, the border is the horizon without rounding.
  return glm::normalize(glm::dvec3(x, 1.0 - std::max(std::abs(p.x), std::abs(p.y)), z));
}

glm::dvec3 grid_direction(const glm::ivec2& node, int n) {
  return direction_from_octahedral(2.0 * glm::dvec2(node) / double(n - 1) - 1.0);
}

GridTriangle grid_triangle(const glm::dvec3& direction, int n) {
  constexpr double kSteps = 0x1p20;
  const double last = n - 1;
  const glm::dvec2 in_cells = 0.5 * last * (octahedral_from_direction(direction) + 1.0);
  const glm::dvec2 position = glm::clamp(glm::floor(in_cells * kSteps + 0.5) / kSteps, 0.0, last);
  const glm::dvec2 cell = glm::min(glm::floor(position), last - 1.0), f = position - cell;
  const glm::ivec2 first(cell), middle = f.x >= f.y ? glm::ivec2(1, 0) : glm::ivec2(0, 1);
  const double larger = std::max(f.x, f.y), smaller = std::min(f.x, f.y);
  return {.nodes = {first, first + middle, first + 1}, .weights = {1.0 - larger, larger - smaller, smaller}};
}

}  // namespace lode::techniques
