#pragma once
/// Pictures that are taken of an object once, from chosen directions: by parallel projection, since the distance from
/// which they will be seen is not known yet, each just as large as the object's box is from there.

#include <glm/vec2.hpp>
#include <glm/vec3.hpp>
#include <optional>

#include "geometry/bounds.h"
#include "techniques/technique.h"

namespace lode::techniques {

/// How such a picture is taken: Stage::capture(objects, camera, size_px).
struct ParallelPicture {
  /// Its eye is the box's centre, half of the depth range before it and half behind.
  geometry::Camera camera;
  glm::ivec2 size_px{0, 0};
  glm::dvec2 half_extent{0.0};  ///< of the picture, world units along the camera's right and up
};

/// Of a box, from where `direction` points: the box's outline lies within the picture, whose pixels are square.
///   direction   of any length but 0; up in the picture is up in the world, or, seen from straight above, some
///   direction texels      along the longer side, 1…16384
/// Nothing if the box is empty, a point, or not finite.
[[nodiscard]] std::optional<ParallelPicture> parallel_picture(const geometry::Bounds& box, const glm::dvec3& direction,
                                                              int texels);

/// From a point to the eye, of any length; where the view is orthographic, against the direction of all its rays.
[[nodiscard]] glm::dvec3 towards_viewer(const View& view, const glm::dvec3& point);

/// Whether all within a distance of a point is beyond the near plane, and so is the point's own direction to the eye
/// one to look from.
[[nodiscard]] bool beyond_near_plane(const View& view, const glm::dvec3& point, double reach);

}  // namespace lode::techniques
