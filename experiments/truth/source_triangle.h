#pragma once
/// A triangle as it was handed to the renderer, and its corners in clip space: in double with a bound on the rounding,
/// and exactly.
///
/// The exact corner is M·p for the matrix M and the float vertex p as they are. The renderer computes the same product
/// in double, ((m₀x + m₁y) + m₂z) + m₃; so does this file, and both are within `error` of the exact one: four roundings
/// of at most u = 2^-53 of a partial sum each, |error| ≤ ((1 + u)^4 − 1)·Σ|mᵢpᵢ| (Higham, Accuracy and Stability of
/// Numerical Algorithms, 2nd ed., sec. 3.1); 5u covers that and the rounding of the bound itself.

#include <array>
#include <glm/mat4x4.hpp>
#include <glm/vec2.hpp>
#include <glm/vec3.hpp>
#include <glm/vec4.hpp>

#include "experiments/truth/rational.h"
#include "raster/frame.h"

namespace lode::experiments::truth {

struct SourceTriangle {
  const glm::dmat4* clip_from_object = nullptr;
  std::array<glm::vec3, 3> p_object{};
  raster::Cull cull = raster::Cull::none;
};

/// Unit roundoff of double.
inline constexpr double kRoundoff = 0x1p-53;

/// |exact − p| ≤ error, component by component.
struct ClipCorner {
  glm::dvec4 p{0.0};
  glm::dvec4 error{0.0};
};
[[nodiscard]] ClipCorner clip_corner(const glm::dmat4& clip_from_object, const glm::vec3& p_object);

using ExactCorner = std::array<Rational, 4>;
[[nodiscard]] ExactCorner exact_clip_corner(const glm::dmat4& clip_from_object, const glm::vec3& p_object);

/// How sure it is that the renderer keeps a triangle when it culls by facing (C3): the sign of det(x, y, w) of its
/// corners, which the renderer computes in double.
enum class Facing : std::uint8_t { dropped, doubtful, kept };
[[nodiscard]] Facing facing(raster::Cull cull, const std::array<ClipCorner, 3>& corners);

}  // namespace lode::experiments::truth
