#pragma once
/// Cameras: right-handed, y up, looking down −z; clip space with reversed depth, 1 near and 0 far (raster's).
///
/// For view distance d (along the viewing direction) the depth is n/d with an infinite far plane,
/// n(f − d)/(d(f − n)) with a finite one, and (f − d)/(f − n) orthographic.

#include <cstdint>
#include <glm/mat4x4.hpp>
#include <glm/vec2.hpp>
#include <glm/vec3.hpp>
#include <limits>

#include "geometry/bounds.h"

namespace lode::geometry {

enum class Projection : std::uint8_t { perspective, orthographic };

struct Camera {
  // Where it stands: an orthonormal frame in the world.
  glm::dvec3 eye{0.0};
  glm::dvec3 right{1.0, 0.0, 0.0};
  glm::dvec3 up{0.0, 1.0, 0.0};
  glm::dvec3 back{0.0, 0.0, 1.0};  ///< against the viewing direction

  Projection projection = Projection::perspective;
  double tan_half_fov_y = 0.41421356237309503;           ///< perspective; > 0; default 45°
  double height = 1.0;                                   ///< orthographic: of the view, world units; > 0
  double near = 0.1;                                     ///< perspective: > 0; orthographic: any below far
  double far = std::numeric_limits<double>::infinity();  ///< > near; infinite only with perspective
};

/// World to camera space: x right, y up, z back.
[[nodiscard]] glm::dmat4 camera_from_world(const Camera& camera);
/// Camera space to clip space. The vertical field of view (or height) holds, the horizontal follows the size.
[[nodiscard]] glm::dmat4 clip_from_camera(const Camera& camera, glm::ivec2 size_px);
[[nodiscard]] glm::dmat4 clip_from_world(const Camera& camera, glm::ivec2 size_px);

/// The half extents of the view at view distance 1 (perspective) or at any distance (orthographic).
[[nodiscard]] glm::dvec2 half_extent(const Camera& camera, glm::ivec2 size_px);

/// A ray in camera space through a point of the target, origin + t·direction: direction.z is −1, so that t is the view
/// distance; where the scene begins and ends, t is near and far.
struct ViewRay {
  glm::dvec3 origin;
  glm::dvec3 direction;
};
[[nodiscard]] ViewRay view_ray(const Camera& camera, glm::ivec2 size_px, glm::dvec2 p_px);

/// Turns to look from `eye` at `target`. Where `up` is along the view, another direction stands in for it.
/// Throws Error (bad_input) if the two points are equal or anything is not finite.
void look_at(Camera& camera, const glm::dvec3& eye, const glm::dvec3& target, const glm::dvec3& up = {0.0, 1.0, 0.0});

/// A perspective camera that sees all of the box from the front, slightly above; near is a thousandth of the diagonal,
/// far is infinite. An empty box, or one that is a point, counts as a box of side 1.
[[nodiscard]] Camera framing_camera(const Bounds& bounds, glm::ivec2 size_px);

/// Turned by the angle about the vertical axis through the centre; `angle_rad` > 0 is counter-clockwise from above.
[[nodiscard]] Camera orbited(const Camera& camera, const glm::dvec3& centre, double angle_rad);

/// Throws Error (bad_input), saying which value is wrong, unless every range above holds.
void check(const Camera& camera);

}  // namespace lode::geometry
