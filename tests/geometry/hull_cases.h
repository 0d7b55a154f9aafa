#pragma once
/// Point sets that are nearly all degenerate, and what must hold of their hulls, by brute force.

#include <algorithm>
#include <array>
#include <cstdint>
#include <map>
#include <set>
#include <string>
#include <vector>

#include "geometry/hull.h"
#include "geometry/predicates.h"
#include "geometry/random.h"

namespace lode::geometry::test {

using Points3 = std::vector<glm::dvec3>;

/// Case i: up to 24 points of a small integer grid, sheared so that they stay integers, sometimes far out. Many
/// coincide; some grids have one step along an axis or more, so that points, segments and polygons come too.
inline Points3 grid_points(std::uint64_t i) {
  Random random(5, 79, i);
  const std::uint32_t side = 1 + random.below(4), n = 1 + random.below(24);
  const glm::dvec3 sides(random.below(4) ? side : 1, random.below(5) ? side : 1, random.below(6) ? side : 1);
  const double shear = random.below(3), far = random.below(4) ? 0.0 : 0x1p40;
  Points3 points;
  for (std::uint32_t k = 0; k < n; ++k) {
    const double x = random.below(std::uint32_t(sides.x)), y = random.below(std::uint32_t(sides.y));
    const double z = random.below(std::uint32_t(sides.z));
    points.emplace_back(x + shear * y + far, y + z * shear, z + 2 * x);
  }
  return points;
}

/// On the closed segment from a to b, exactly: on its line as seen along each axis, and within its box.
inline bool is_on_segment(const glm::dvec3& p, const glm::dvec3& a, const glm::dvec3& b) {
  const auto flat = [](const glm::dvec3& q, int axis) { return glm::dvec2(q[(axis + 1) % 3], q[(axis + 2) % 3]); };
  for (int axis = 0; axis < 3; ++axis) {
    if (orientation(flat(a, axis), flat(b, axis), flat(p, axis)) != 0) return false;
    if (p[axis] < std::min(a[axis], b[axis]) || p[axis] > std::max(a[axis], b[axis])) return false;
  }
  return true;
}

/// "" if all of the following hold: every point is in the hull; the surface is closed and its triangles have an area;
/// Euler's formula; each corner of it is listed, ascending; each vertex is needed: the hull of the other vertices does
/// not hold it. Otherwise the claim that fails.
inline std::string wrong_with(const Hull& hull, const Points3& points) {
  if (hull.kind != HullKind::polyhedron) return hull.triangles.empty() ? "" : "triangles of no polyhedron";
  std::map<std::pair<std::uint32_t, std::uint32_t>, int> edges;
  std::set<std::uint32_t> corners;
  for (const auto& t : hull.triangles) {
    for (const glm::dvec3& p : points) {
      if (orientation(points[t[0]], points[t[1]], points[t[2]], p) > 0) return "a point is outside";
    }
    bool area = false;
    for (const std::uint32_t v : hull.vertices) {
      area = area || orientation(points[t[0]], points[t[1]], points[t[2]], points[v]) != 0;
    }
    if (!area) return "a triangle without area";
    for (int k = 0; k < 3; ++k) ++edges[{t[std::size_t(k)], t[std::size_t(k + 1) % 3]}];
    corners.insert(t.begin(), t.end());
  }
  for (const auto& [edge, n] : edges) {
    const auto back = edges.find({edge.second, edge.first});
    if (n != 1 || back == edges.end()) return "the surface is not closed";
  }
  if (corners.size() + hull.triangles.size() != 2 + edges.size() / 2) return "not Euler's formula";
  if (!std::ranges::equal(corners, hull.vertices)) return "the vertices are not the corners";
  for (const std::uint32_t v : hull.vertices) {
    Points3 others;
    for (const std::uint32_t w : hull.vertices) {
      if (w != v) others.push_back(points[w]);
    }
    const Hull rest = convex_hull(others);
    if (contains(rest, others, points[v])) return "a vertex that is not extreme";
    // In a plane, the point must be off it or off the polygon: on no segment between two corners, at least.
    for (const glm::dvec3& a : others) {
      for (const glm::dvec3& b : others) {
        if (is_on_segment(points[v], a, b)) return "a vertex on a segment";
      }
    }
  }
  return "";
}

}  // namespace lode::geometry::test
