#pragma once
/// What the reference pipeline asks of every primitive. Each kind (Triangle, Line, Square, Disc, Surfel) is a
/// plain struct made by its own `make_…` function from vertices, and has these five free functions:
///
///   PixelBox bounds_px(const T&, ivec2 sample_fx8)
///       pixels whose sample it may cover; conservative, may reach outside the target, empty if none
///   void for_each_covered(const T&, const PixelBox& window, ivec2 sample_fx8, Visit visit)
///       visit(ivec2 pixel) exactly once for each pixel in the window whose sample is covered, in any fixed order
///   float depth_at(const T&, ivec2 p_fx8)                        depth at a covered sample, [0, 1] (C5)
///   VertexWeights weights_at(const T&, ivec2 p_fx8)              perspective-correct weights of its vertices (C7)
///   Footprint footprint_at(const T&, const VertexUvs&, ivec2 p_fx8)   texture coordinate and its derivatives
///
/// A sample's position is p_fx8 = 256 · pixel + sample_fx8: window coordinates in 1/256 px, y down.

#include <algorithm>
#include <array>
#include <cstdint>
#include <glm/vec2.hpp>
#include <optional>

#include "raster/texture.h"

namespace lode::raster::reference {

/// Guard band: snapped coordinates lie in [−kGuard_fx8, kGuard_fx8] (C1).
inline constexpr std::int32_t kGuard_fx8 = 1 << 23;

/// Pixels begin ≤ p < end in both axes.
struct PixelBox {
  glm::ivec2 begin_px{0, 0};
  glm::ivec2 end_px{0, 0};
  [[nodiscard]] bool empty() const { return begin_px.x >= end_px.x || begin_px.y >= end_px.y; }
};

[[nodiscard]] inline PixelBox intersect(const PixelBox& a, const PixelBox& b) {
  return {{std::max(a.begin_px.x, b.begin_px.x), std::max(a.begin_px.y, b.begin_px.y)},
          {std::min(a.end_px.x, b.end_px.x), std::min(a.end_px.y, b.end_px.y)}};
}

[[nodiscard]] inline glm::ivec2 sample_position_fx8(glm::ivec2 pixel, glm::ivec2 sample_fx8) {
  return {pixel.x * 256 + sample_fx8.x, pixel.y * 256 + sample_fx8.y};
}

/// Pixels whose samples lie in the closed box [low, high] of window coordinates (fx8).
[[nodiscard]] inline PixelBox pixels_with_samples_in(glm::ivec2 low_fx8, glm::ivec2 high_fx8, glm::ivec2 sample_fx8) {
  const auto ceil_px = [](std::int32_t a) { return (a + 255) >> 8; };  // arithmetic shift: floor
  return {{ceil_px(low_fx8.x - sample_fx8.x), ceil_px(low_fx8.y - sample_fx8.y)},
          {((high_fx8.x - sample_fx8.x) >> 8) + 1, ((high_fx8.y - sample_fx8.y) >> 8) + 1}};
}

/// Weights of up to three vertices, in the order of the primitive's own vertex list; unused ones are 0.
using VertexWeights = std::array<double, 3>;

/// Texture coordinates of the primitive's vertices, or nothing where the draw has none (points, discs and
/// surfels then run from (0,0) to (1,1) across their square).
using VertexUvs = std::optional<std::array<glm::vec2, 3>>;

}  // namespace lode::raster::reference
