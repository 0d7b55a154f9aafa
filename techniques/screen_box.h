#pragma once
/// What a box in the world can reach at most on the screen: which samples, and how near. Whoever holds a depth buffer
/// of what is drawn anyway can leave out an object whose box is behind it everywhere.

#include <glm/mat4x4.hpp>
#include <glm/vec2.hpp>
#include <optional>

#include "geometry/bounds.h"

namespace lode::techniques {

/// Pixels of the picture, both ends included; none if last < first in x or in y.
struct ScreenBox {
  glm::ivec2 first_px{0, 0}, last_px{-1, -1};
  float nearest = 0.0f;  ///< depth, 1 near: no fragment of what is in the box has a greater one, as the renderer rounds
  [[nodiscard]] bool empty() const { return last_px.x < first_px.x || last_px.y < first_px.y; }
};

/// Bounds every sample at a pixel's centre that triangles, lines or points of the box can cover, and its depth there.
/// Nothing if that cannot be told: the box reaches the near plane or the eye, is not finite, or lies partly where the
/// renderer cuts (its guard band). An empty box covers nothing.
///
/// Rounding is on the safe side. A vertex snaps by 1/512 px at most, a line or a point of one pixel reaches half a
/// pixel beyond it; the rectangle is a whole pixel wider on every side. The depth is the nearest corner's, which bounds
/// every vertex (z/w falls along the view and fragments stay between their vertices), plus what the terms of clip space
/// can have lost: 2^-36 of their magnitude. A matrix product in double loses 2^-50; the rest is for objects whose
/// vertices lie far from their own origin (up to 2^14 times as far as the box from the world's).
///   clip_from_world   depth 1 near, 0 far (geometry::clip_from_world)
///   size_px           of the picture, each at most 32768
///
/// `whole_screen_box` also tells of pixels beyond the picture.
[[nodiscard]] std::optional<ScreenBox> whole_screen_box(const glm::dmat4& clip_from_world, glm::ivec2 size_px,
                                                        const geometry::Bounds& box);
[[nodiscard]] std::optional<ScreenBox> screen_box(const glm::dmat4& clip_from_world, glm::ivec2 size_px,
                                                  const geometry::Bounds& box);

}  // namespace lode::techniques
