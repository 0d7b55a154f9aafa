#pragma once
/// A view frustum as its planes, and whether a box lies wholly outside of it.

#include <array>
#include <glm/mat4x4.hpp>
#include <glm/vec4.hpp>

#include "geometry/bounds.h"

namespace lode::geometry {

/// Planes with the inside at plane · (p, 1) ≥ 0, in the space that the matrix starts from: left, right, bottom, top,
/// near, far. Not normalized. With an infinite far plane the last one is (0, 0, 0, n): everything is inside.
struct Frustum {
  std::array<glm::dvec4, 6> planes;
  std::array<glm::dvec4, 6> magnitudes;  ///< of the terms that each plane is the sum of: bounds their rounding
};

/// The frustum of clip space |x| ≤ w, |y| ≤ w, 0 ≤ z ≤ w (depth 1 near). Gribb & Hartmann 2001.
[[nodiscard]] Frustum frustum(const glm::dmat4& clip_from_space);

/// True only if every point of the box is outside one and the same plane; sure also under rounding (a bound on the
/// sum's error is added), so that what it drops is never seen. An empty box is outside.
[[nodiscard]] bool is_outside(const Frustum& frustum, const Bounds& box);

}  // namespace lode::geometry
