#pragma once
/// A triangle into the masked depth buffer: at the picture's samples it covers exactly what the renderer's triangle of
/// these vertices covers, and it is nowhere nearer.

#include <array>
#include <cstdint>
#include <glm/vec2.hpp>

#include "techniques/masked_occlusion/masked_depth.h"

namespace lode::techniques {

/// Vertices as the renderer snaps them.
struct ScreenTriangle {
  std::array<glm::ivec2, 3> p_fx8;  ///< 1/256 px, y down, within ±2^23
  std::array<double, 3> z;          ///< [0, 1], 1 near
};

/// Doubled area in 1/256² px²: positive if clockwise on screen. Exact.
[[nodiscard]] inline std::int64_t doubled_area(const ScreenTriangle& t) {
  const glm::ivec2 a = t.p_fx8[1] - t.p_fx8[0], b = t.p_fx8[2] - t.p_fx8[0];
  return std::int64_t(a.x) * b.y - std::int64_t(a.y) * b.x;
}

/// Coverage: samples at pixel centres, integer edge functions, top-left rule, either winding; zero area covers nothing.
/// Depth: one bound for the part in each subtile, from the plane through the vertices, less what its rounding can have
/// gained; never below the farthest vertex.
///   returns   subtiles that were given a part
///   cost      O(rows + subtiles)
std::uint64_t draw_triangle(const ScreenTriangle& triangle, MaskedDepth& buffer);

/// Samples that the triangle may cover, both ends included, in the buffer; none if last < first.
struct SampleBox {
  glm::ivec2 first, last;
  [[nodiscard]] bool empty() const { return last.x < first.x || last.y < first.y; }
};
[[nodiscard]] SampleBox sample_box(const ScreenTriangle& triangle, glm::ivec2 n_subtiles);

}  // namespace lode::techniques
