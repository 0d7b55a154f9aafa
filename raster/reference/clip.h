#pragma once
/// Vertices into clip space, clipping, and the snap to window coordinates (C1, C4). Everything here is in
/// double, in a written order, so that two primitives that share an edge compute the same bits for it.

#include <array>
#include <cstdint>
#include <glm/vec2.hpp>
#include <glm/vec4.hpp>

#include "raster/frame.h"
#include "raster/reference/primitive.h"

namespace lode::raster::reference {

/// Smallest w that is kept: the smallest positive float, so that no positive float w is ever cut.
inline constexpr double kMinW = 0x1p-149;

/// A vertex in clip space and its weights of the primitive's own vertices.
struct ClipVertex {
  glm::dvec4 position{0.0};
  VertexWeights weights{0.0, 0.0, 0.0};
};

/// Vertex i in clip space (ObjectVertices and ClipVertices). Infinities are read as large numbers (frame.h); a
/// NaN stays one.
[[nodiscard]] glm::dvec4 clip_position(const Vertices& vertices, std::uint32_t i);
[[nodiscard]] bool has_nan(const glm::dvec4& p);

/// Where clip space lands: window x = (x/w) · half.x + centre.x, y = −(y/w) · half.y + centre.y, in 1/256 px.
struct Viewport {
  glm::dvec2 centre_fx8{0.0, 0.0};
  glm::dvec2 half_fx8{0.0, 0.0};
};
[[nodiscard]] Viewport make_viewport(const Rect& rect);

/// Planes in their fixed order: near (z ≤ w), w ≥ kMinW, far (z ≥ 0), and the guard band's four sides.
inline constexpr int kClipPlanes = 7;

/// Bit k is set where the vertex lies outside plane k.
[[nodiscard]] std::uint32_t outside_planes(const Viewport& viewport, const glm::dvec4& p);

/// A convex polygon has at most 3 + kClipPlanes vertices; one that rounding made concave gains at most half
/// as many again at each plane: 3, 4, 6, 9, 13, 19, 28, 42.
struct ClipPolygon {
  std::array<ClipVertex, 42> vertices;
  int n = 0;
};

/// Sutherland & Hodgman, plane by plane in the fixed order. A new vertex is computed once per edge, from the end
/// nearer to the plane, at equal distances the one first in lexicographic order (−0 taken as +0), so both neighbours
/// of an edge get the same bits, and it is then put onto its plane exactly. Returns n = 0 if nothing is left.
[[nodiscard]] ClipPolygon clip_triangle(const Viewport& viewport, const std::array<glm::dvec4, 3>& corners);

/// The same for the segment a–b; returns n = 2, or 0. The ends keep their order.
[[nodiscard]] ClipPolygon clip_segment(const Viewport& viewport, const glm::dvec4& a, const glm::dvec4& b);

/// A vertex as the rasterizer sees it.
struct WindowVertex {
  glm::ivec2 p_fx8{0, 0};
  double z = 0.0;  ///< [0, 1]
  double w = 1.0;
};

/// Divide, viewport, one round-half-even snap to 1/256 px; p must have been clipped.
[[nodiscard]] WindowVertex window_vertex(const Viewport& viewport, const glm::dvec4& p);

/// A vertex given in window pixels; z is clamped to [0, 1], w is 1.
[[nodiscard]] WindowVertex window_vertex(const glm::dvec3& p_px);

/// True where a comes before b: by x, y, z, w as numbers; equal bits, or zeros of either sign, are equal.
[[nodiscard]] bool canonically_before(const glm::dvec4& a, const glm::dvec4& b);

}  // namespace lode::raster::reference
