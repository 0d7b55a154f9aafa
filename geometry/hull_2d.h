#pragma once
/// The convex hull of points in a plane, exact for all finite inputs. Andrew, "Another efficient algorithm for convex
/// hulls in two dimensions", 1979, with exact orientations.

#include <cstdint>
#include <glm/vec2.hpp>
#include <span>
#include <vector>

namespace lode::geometry {

/// Indices of the hull's corners, counter-clockwise (y up), from the lexicographically smallest point. No corner lies
/// on the segment between two others; of equal points the first is taken. One index if all points are equal, two if all
/// are collinear, none if there are none.
///
///   points    [n] finite (checked: std::logic_error)
///   cost      O(n log n); depends on the order of the points only in which of equal ones is named
[[nodiscard]] std::vector<std::uint32_t> convex_hull_2d(std::span<const glm::dvec2> points);

}  // namespace lode::geometry
