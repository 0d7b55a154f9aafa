#pragma once
/// A conservative window box of a surfel: its axis-aligned box in object space, projected.

#include <glm/vec2.hpp>
#include <optional>

#include "raster/reference/exact_surfel.h"

namespace lode::raster::reference {

/// Closed, in 1/256 px; never empty.
struct WindowBox {
  glm::ivec2 low_fx8, high_fx8;
};

/// Contains every sample in the guard band that the disc covers. Nothing if all of the disc is surely behind
/// the eye, nearer than the near plane or beyond the far plane, or outside the guard band; the whole guard band
/// where a corner of the box may lie behind the eye. O(1).
[[nodiscard]] std::optional<WindowBox> surfel_bounds(const SurfelInput& s);

/// The power of two that brings the matrix's largest element to [1, 2): 2^-(the result) times the matrix.
[[nodiscard]] int matrix_exponent(const glm::dmat4& m);

}  // namespace lode::raster::reference
