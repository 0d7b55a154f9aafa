#include "geometry/hull.h"

#include <algorithm>
#include <cmath>
#include <glm/geometric.hpp>
#include <optional>
#include <stdexcept>
#include <tuple>

#include "geometry/hull_2d.h"
#include "geometry/hull_facets.h"
#include "geometry/predicates.h"

namespace lode::geometry {
namespace {

using Points = std::span<const glm::dvec3>;

/// Without one coordinate; a set in a plane that is not along that axis keeps all its orientations, up to one sign.
glm::dvec2 dropped(const glm::dvec3& p, int axis) { return {p[(axis + 1) % 3], p[(axis + 2) % 3]}; }

/// An axis along which a, b and c are seen as a triangle; nothing if they are collinear.
std::optional<int> axis_that_sees(const glm::dvec3& a, const glm::dvec3& b, const glm::dvec3& c) {
  for (int axis = 0; axis < 3; ++axis) {
    if (orientation(dropped(a, axis), dropped(b, axis), dropped(c, axis)) != 0) return axis;
  }
  return std::nullopt;
}

/// Of the points that pass an exact test, about the one with the greatest measure; the first of equal ones.
template <class Measure, class Test>
std::optional<std::uint32_t> greatest(Points points, Measure measure, Test test) {
  std::optional<std::uint32_t> best;
  double most = -1.0;
  for (std::uint32_t i = 0; i < points.size(); ++i) {
    const double m = measure(points[i]);
    if ((best && !(m > most)) || !test(points[i])) continue;
    best = i;
    most = m;
  }
  return best;
}

/// Corners of the hull of points in one plane that is seen along the axis, counter-clockwise as seen so.
std::vector<std::uint32_t> planar_hull(Points points, std::span<const std::uint32_t> subset, int axis) {
  std::vector<glm::dvec2> flat;
  flat.reserve(subset.size());
  for (const std::uint32_t i : subset) flat.push_back(dropped(points[i], axis));
  std::vector<std::uint32_t> corners = convex_hull_2d(flat);
  for (std::uint32_t& i : corners) i = subset[i];
  return corners;
}

/// The facets in the plane of facet f that hang together with it; all are marked. Their corners, once each.
std::vector<std::uint32_t> face_corners(Points points, std::span<const HullFacets::Facet> facets, std::uint32_t f,
                                        std::vector<bool>& done) {
  const HullFacets::Triangle& own = facets[f].corners;
  std::vector<std::uint32_t> face = {f}, corners;
  done[f] = true;
  for (std::size_t k = 0; k < face.size(); ++k) {
    const HullFacets::Facet& facet = facets[face[k]];
    corners.insert(corners.end(), facet.corners.begin(), facet.corners.end());
    for (const std::uint32_t neighbour : facet.neighbours) {
      if (done[neighbour]) continue;
      const HullFacets::Triangle& other = facets[neighbour].corners;
      const bool in_plane = std::ranges::all_of(other, [&](std::uint32_t p) {
        return orientation(points[own[0]], points[own[1]], points[own[2]], points[p]) == 0;
      });
      if (!in_plane) continue;
      done[neighbour] = true;
      face.push_back(neighbour);
    }
  }
  std::ranges::sort(corners);
  corners.erase(std::unique(corners.begin(), corners.end()), corners.end());
  return corners;
}

/// Faces are found exactly and cut anew, so that no corner is left in the middle of an edge or of a face.
Hull polyhedron(Points points, const std::array<std::uint32_t, 4>& tetrahedron) {
  HullFacets grown(points, tetrahedron);
  grown.grow();
  const std::span<const HullFacets::Facet> facets = grown.facets();
  Hull hull{HullKind::polyhedron, {}, {}};
  std::vector<bool> done(facets.size());
  for (std::uint32_t f = 0; f < facets.size(); ++f) {
    if (!facets[f].alive || done[f]) continue;
    const auto [a, b, c] = facets[f].corners;
    const std::vector<std::uint32_t> all = face_corners(points, facets, f, done);
    const int axis = axis_that_sees(points[a], points[b], points[c]).value();
    std::vector<std::uint32_t> corners = planar_hull(points, all, axis);
    if (orientation(dropped(points[a], axis), dropped(points[b], axis), dropped(points[c], axis)) < 0) {
      std::ranges::reverse(corners);
    }
    for (std::size_t i = 1; i + 1 < corners.size(); ++i) {
      hull.triangles.push_back({corners[0], corners[i], corners[i + 1]});
    }
    hull.vertices.insert(hull.vertices.end(), corners.begin(), corners.end());
  }
  std::ranges::sort(hull.vertices);
  hull.vertices.erase(std::unique(hull.vertices.begin(), hull.vertices.end()), hull.vertices.end());
  return hull;
}

}  // namespace

Hull convex_hull(std::span<const glm::dvec3> points) {
  for (const glm::dvec3& p : points) {
    if (!std::isfinite(p.x) || !std::isfinite(p.y) || !std::isfinite(p.z)) {
      throw std::logic_error("convex_hull: expected finite points");
    }
  }
  if (points.empty()) return {};
  std::vector<std::uint32_t> order(points.size());
  for (std::uint32_t i = 0; i < order.size(); ++i) order[i] = i;
  const auto key = [&](std::uint32_t i) { return std::tuple(points[i].x, points[i].y, points[i].z); };
  const std::uint32_t first = *std::ranges::min_element(order, {}, key);
  const std::uint32_t last = *std::ranges::max_element(order, {}, key);  // of equal ones, both take the first
  if (points[first] == points[last]) return {HullKind::point, {first}, {}};

  const glm::dvec3 &a = points[first], &b = points[last];
  const auto third = greatest(
      points, [&](const glm::dvec3& p) { return glm::length(glm::cross(b - a, p - a)); },
      [&](const glm::dvec3& p) { return axis_that_sees(a, b, p).has_value(); });
  if (!third) return {HullKind::segment, {std::min(first, last), std::max(first, last)}, {}};

  const glm::dvec3& c = points[*third];
  const glm::dvec3 normal = glm::cross(b - a, c - a);
  const auto fourth = greatest(
      points, [&](const glm::dvec3& p) { return std::fabs(glm::dot(normal, p - a)); },
      [&](const glm::dvec3& p) { return orientation(a, b, c, p) != 0; });
  if (!fourth) return {HullKind::polygon, planar_hull(points, order, axis_that_sees(a, b, c).value()), {}};
  return polyhedron(points, {first, last, *third, *fourth});
}

bool contains(const Hull& hull, std::span<const glm::dvec3> points, const glm::dvec3& p) {
  return hull.kind == HullKind::polyhedron && std::ranges::all_of(hull.triangles, [&](const auto& t) {
           return orientation(points[t[0]], points[t[1]], points[t[2]], p) <= 0;
         });
}

}  // namespace lode::geometry
