#pragma once
/// A convex hull on the screen: its points in pixels and the depths that it spans, cut at the near plane.

#include <array>
#include <cstdint>
#include <glm/mat4x4.hpp>
#include <glm/vec2.hpp>
#include <glm/vec3.hpp>
#include <span>
#include <vector>

#include "geometry/bounds.h"

namespace lode::geometry {

/// Against the near plane: all in front of it, on both sides, or (what touches it included) nothing beyond it.
enum class NearPlane : std::uint8_t { in_front, crosses, behind };

struct ProjectedHull {
  NearPlane near_plane = NearPlane::behind;
  /// Window coordinates, y down: their convex hull is the picture of the part in front of the near plane.
  std::vector<glm::dvec2> points_px;
  /// Depths as they are written (1 near, 0 far) of that part, up to rounding.
  double nearest_depth = 0.0;
  double farthest_depth = 1.0;
};

/// The convex hull of the points, under a matrix to a clip space with reversed depth (camera.h). Nothing but the near
/// plane cuts. A point where the matrix gives a NaN or an infinity has the hull count as `crosses` without points: it
/// is no occluder, and as an occludee it is visible.
///
///   p_object  [n]
///   cost      O(n), or O(n_front · n_behind) if it crosses: an edge list is not needed, since every cut between a
///   point
///             in front and one behind lies in the hull
[[nodiscard]] ProjectedHull project_hull(std::span<const glm::vec3> p_object, const glm::dmat4& clip_from_object,
                                         const glm::dvec2& size_px);

/// The same into a hull that was projected before, whose memory is used again.
void project_hull(std::span<const glm::vec3> p_object, const glm::dmat4& clip_from_object, const glm::dvec2& size_px,
                  ProjectedHull& hull);

/// The corners of a box, x changing fastest. The box is not empty.
[[nodiscard]] std::array<glm::vec3, 8> corners(const Bounds& box);

}  // namespace lode::geometry
