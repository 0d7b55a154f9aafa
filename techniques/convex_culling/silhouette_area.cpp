#include "techniques/convex_culling/silhouette_area.h"

#include <algorithm>
#include <limits>

namespace lode::techniques::convex_culling {
namespace {

Lines lines_over(std::span<const glm::vec3> positions, std::span<const std::uint32_t> vertices, int axis, int n) {
  Lines lines = {std::numeric_limits<double>::infinity(), -std::numeric_limits<double>::infinity(), n};
  for (const std::uint32_t v : vertices) {
    const double x = along_axis(positions[v], axis).x;
    lines.left = std::min(lines.left, x);
    lines.right = std::max(lines.right, x);
  }
  if (vertices.empty()) lines.left = lines.right = 0.0;
  return lines;
}

}  // namespace

SilhouetteArea::Areas SilhouetteArea::of_both(std::span<const glm::vec3> positions, std::span<const Triangle> triangles,
                                              std::span<const std::uint32_t> vertices,
                                              std::span<const std::vector<std::uint32_t>> hulls) {
  Areas areas;
  for (int axis = 0; axis < 3; ++axis) {
    const Lines lines = lines_over(positions, vertices, axis, n_lines_);
    lines_.clear(lines);
    for (const Triangle& t : triangles) {
      lines_.add_triangle(along_axis(positions[t[0]], axis), along_axis(positions[t[1]], axis),
                          along_axis(positions[t[2]], axis));
    }
    areas.model += lines_.area();
    lines_.clear(lines);
    for (const std::vector<std::uint32_t>& hull : hulls) {
      flat_.clear();
      for (const std::uint32_t v : hull) flat_.push_back(along_axis(positions[v], axis));
      lines_.add_hull(flat_);
    }
    areas.hulls += lines_.area();
  }
  return areas;
}

double SilhouetteArea::of_triangles(std::span<const glm::vec3> positions, std::span<const Triangle> triangles,
                                    std::span<const std::uint32_t> vertices) {
  return of_both(positions, triangles, vertices, {}).model;
}

}  // namespace lode::techniques::convex_culling
