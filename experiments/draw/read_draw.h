#pragma once
/// Reads one element of a picture's "draws": exactly one geometry key, then material and state.

#include <glm/mat4x4.hpp>

#include "experiments/draw/picture.h"
#include "geometry/json/json_view.h"

namespace lode::experiments {

/// What a draw takes over from its picture.
struct DrawContext {
  bool in_fx8 = false;  ///< window coordinates, radii and sizes are whole 1/256 px instead of decimal px
  glm::dmat4 clip_from_world{1.0};
};

/// All throw Error (bad_input) at the place that is wrong.
[[nodiscard]] PictureDraw read_draw(const geometry::JsonView& view, const DrawContext& context);
/// [x, y, width, height] in px; empty and outside are fine, negative sizes are not.
[[nodiscard]] raster::Rect read_rect(const geometry::JsonView& view);
/// 16 numbers, column-major.
[[nodiscard]] glm::dmat4 read_matrix(const geometry::JsonView& view);

}  // namespace lode::experiments
