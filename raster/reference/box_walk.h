#pragma once
/// for_each_covered of the primitives that have nothing better than a test of each sample, `covers(primitive,
/// p_fx8)`: squares, discs, surfels.

#include <glm/vec2.hpp>

#include "raster/reference/primitive.h"

namespace lode::raster::reference {

template <class Primitive>
concept TestedBySample = requires(const Primitive& primitive, glm::ivec2 p_fx8) {
  covers(primitive, p_fx8);
};

/// Row by row. O(pixels of the bounds in the window).
template <TestedBySample Primitive, class Visit>
void for_each_covered(const Primitive& primitive, const PixelBox& window, glm::ivec2 sample_fx8, Visit visit) {
  const PixelBox box = intersect(bounds_px(primitive, sample_fx8), window);
  for (int y = box.begin_px.y; y < box.end_px.y; ++y) {
    for (int x = box.begin_px.x; x < box.end_px.x; ++x) {
      if (covers(primitive, sample_position_fx8({x, y}, sample_fx8))) visit(glm::ivec2{x, y});
    }
  }
}

}  // namespace lode::raster::reference
