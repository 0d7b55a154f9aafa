#pragma once
/// A walk through a scene: a camera that goes along points at constant speed and looks at where it will be,
/// or at one point.

#include <glm/vec3.hpp>
#include <optional>
#include <span>
#include <string>
#include <vector>

#include "geometry/camera.h"

namespace lode::geometry {

/// A polyline, walked from end to end in n_frames cameras, whose eyes are equally far apart along it. The camera looks
/// at the point `look_ahead` further along (beyond the end, straight on). Vertical field of view 60°, near 0.1, far
/// infinite.
struct CameraPath {
  std::string name;
  std::vector<glm::dvec3> points;         ///< [≥ 2], world, neighbours not equal
  int n_frames = 600;                     ///< ≥ 2
  double look_ahead = 6.0;                ///< along the path, world units, > 0
  std::optional<glm::dvec3> target = {};  ///< looked at all the way instead
};

/// In world units.
[[nodiscard]] double length(const CameraPath& path);

/// The point at a distance along the path; beyond its ends it goes straight on. O(points).
[[nodiscard]] glm::dvec3 point_along(const CameraPath& path, double distance);

/// Frame 0 stands at the first point, frame n_frames − 1 at the last. Deterministic: + − × ÷ √ alone.
/// Throws Error (bad_input) for a path or a frame that is out of range.
[[nodiscard]] Camera camera_at(const CameraPath& path, int frame);

/// The polyline with each corner replaced by a curve (a parabola's arc in eight pieces) that leaves and meets the sides
/// at most `radius` from the corner, and at most half of the side away.
[[nodiscard]] std::vector<glm::dvec3> rounded_corners(std::span<const glm::dvec3> points, double radius);

/// The camera that all paths and viewpoints share, not yet placed.
[[nodiscard]] Camera walking_camera();

}  // namespace lode::geometry
