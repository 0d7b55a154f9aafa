#pragma once
/// Where the picture of an object goes: the rectangle of pixels around its box, and the plate in the world that stands
/// for it, in the plane through the box's centre that is parallel to the picture.

#include <array>
#include <cstdint>
#include <glm/vec2.hpp>
#include <glm/vec3.hpp>
#include <optional>

#include "geometry/bounds.h"
#include "raster/frame.h"
#include "techniques/technique.h"

namespace lode::techniques {

/// corrected: the plate keeps the place of the rectangle around the centre of the box, so that at the pose of the
/// capture every texel lies on the pixel that it was. literal: the middle of the rectangle is put where the centre of
/// the box is, as the paper says; the picture jumps by the distance of the two.
enum class PlatePlacement : std::uint8_t { corrected, literal };

/// Sides of a plate, world units from the centre of the box along the camera's right and down.
struct PlateSides {
  double left = 0.0, top = 0.0, right = 0.0, bottom = 0.0;
  double pixel = 0.0;  ///< width of a pixel of the capture, world units
};

/// The pixels that a box reaches, with one more on every side. Nothing if the box reaches the near plane or lies too
/// far outside the picture to tell.
[[nodiscard]] std::optional<raster::Rect> capture_window(const View& view, const geometry::Bounds& box);

/// Whether the plane through a point that is parallel to the picture lies between the near plane and the far one.
[[nodiscard]] bool plane_in_view(const View& view, const glm::dvec3& point);

/// World units per pixel, right and down, in the plane through a point. Positive if the point is in front of the eye.
[[nodiscard]] glm::dvec2 pixel_size_at(const View& view, const glm::dvec3& point);

/// The plate of a picture of the window.
[[nodiscard]] PlateSides plate_sides(const View& view, const glm::dvec3& centre, const raster::Rect& window_px,
                                     PlatePlacement placement);

/// Corners as Stage::plate takes them, facing the view.
[[nodiscard]] std::array<glm::dvec3, 4> plate_corners(const View& view, const glm::dvec3& centre,
                                                      const PlateSides& sides);

}  // namespace lode::techniques
