#pragma once
/// FLIP's colour pipeline, a pixel at a time (Andersson et al. 2020, sec. 4.1): the opponent space YCxCz that the eye's
/// contrast sensitivity is applied in, and the difference of two filtered colours in Hunt-adjusted L*a*b*.

#include <glm/vec3.hpp>

namespace lode::experiments::flip {

/// Linear sRGB to YCxCz, relative to the D65 white of the same matrix.
[[nodiscard]] glm::dvec3 ycxcz_from_linear(const glm::dvec3& linear);

/// The relative luminance in [0, 1] of YCxCz: what edges and points are sought in.
[[nodiscard]] inline double luminance_of(double y) { return (y + 16.0) / 116.0; }

/// ΔE_c in [0, 1] of two filtered YCxCz colours: clamped to the gamut, HyAB distance to the power of 0.7, and the
/// distances from 0 to 0.4 of the largest one, which is that of green and blue, stretched over 0 to 0.95.
[[nodiscard]] double color_difference(const glm::dvec3& reference, const glm::dvec3& test);

}  // namespace lode::experiments::flip
