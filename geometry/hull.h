#pragma once
/// The convex hull of points in space, exact for all finite inputs: whatever they have of coincident, collinear,
/// coplanar or cocircular points (C14). Barber, Dobkin & Huhdanpaa, "The quickhull algorithm for convex hulls", 1996.
/// In contrast to the paper no facet is thick and none is merged while it grows: signs are exact, and a point in a
/// facet's plane does not see it.

#include <array>
#include <cstdint>
#include <glm/vec3.hpp>
#include <span>
#include <vector>

namespace lode::geometry {

enum class HullKind : std::uint8_t { nothing, point, segment, polygon, polyhedron };

struct Hull {
  HullKind kind = HullKind::nothing;
  /// The extreme points, as indices of the input (of equal points the first): no other points are needed to make the
  /// hull, and all of these are. Ascending, but a polygon's in their order around it.
  std::vector<std::uint32_t> vertices;
  /// Of a polyhedron only: closed, outward (counter-clockwise from outside), none without area; faces with more than
  /// three corners are fans.
  std::vector<std::array<std::uint32_t, 3>> triangles;
};

/// The hull of the points. Its kind says what they span.
///
///   points    [n] finite (checked: std::logic_error), n < 2^31
///   cost      O(n log n) expected, O(n²) at worst
[[nodiscard]] Hull convex_hull(std::span<const glm::dvec3> points);

/// Whether p is in the closed polyhedron, exactly. Other kinds have no inside: false.
[[nodiscard]] bool contains(const Hull& hull, std::span<const glm::dvec3> points, const glm::dvec3& p);

}  // namespace lode::geometry
