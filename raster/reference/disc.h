#pragma once
/// Points (squares) and screen discs (C12), both flat in depth and exact in integers. Their sizes are snapped to
/// 1/256 px like positions. A square has its left and top side but not its right and bottom one, so squares that
/// touch neither overlap nor leave a gap; a disc has its whole rim.

#include <cstdint>
#include <glm/vec2.hpp>
#include <optional>

#include "raster/reference/box_walk.h"
#include "raster/reference/primitive.h"

namespace lode::raster::reference {

/// Larger sizes are drawn at this one: from any centre it covers the whole guard band.
inline constexpr std::int32_t kMaxSize_fx8 = 1 << 25;

struct Square {
  glm::ivec2 centre_fx8{0, 0};  ///< within the guard band
  std::int32_t size_fx8 = 256;  ///< 1…kMaxSize_fx8
  double z = 0.0;               ///< [0, 1]
};
struct Disc {
  glm::ivec2 centre_fx8{0, 0};
  std::int32_t radius_fx8 = 256;  ///< 1…kMaxSize_fx8
  double z = 0.0;
};

/// Rounded half to even. Nothing if NaN or ≤ 0, or if it rounds to 0.
[[nodiscard]] std::optional<std::int32_t> snap_size(double size_px);
[[nodiscard]] std::optional<Square> make_square(glm::ivec2 centre_fx8, double size_px, double z);
[[nodiscard]] std::optional<Disc> make_disc(glm::ivec2 centre_fx8, double radius_px, double z);

/// Doubled, so that odd sizes need no rounding.
[[nodiscard]] inline bool covers(const Square& s, glm::ivec2 p_fx8) {
  const glm::ivec2 from_low = 2 * p_fx8 - (2 * s.centre_fx8 - s.size_fx8);
  return from_low.x >= 0 && from_low.y >= 0 && from_low.x < 2 * s.size_fx8 && from_low.y < 2 * s.size_fx8;
}
[[nodiscard]] inline bool covers(const Disc& d, glm::ivec2 p_fx8) {
  const std::int64_t dx = std::int64_t(p_fx8.x) - d.centre_fx8.x, dy = std::int64_t(p_fx8.y) - d.centre_fx8.y;
  return dx * dx + dy * dy <= std::int64_t(d.radius_fx8) * d.radius_fx8;
}

[[nodiscard]] PixelBox bounds_px(const Square& s, glm::ivec2 sample_fx8);
[[nodiscard]] PixelBox bounds_px(const Disc& d, glm::ivec2 sample_fx8);

[[nodiscard]] inline float depth_at(const Square& s, glm::ivec2) { return static_cast<float>(s.z); }
[[nodiscard]] inline float depth_at(const Disc& d, glm::ivec2) { return static_cast<float>(d.z); }
[[nodiscard]] inline VertexWeights weights_at(const Square&, glm::ivec2) { return {1.0, 0.0, 0.0}; }
[[nodiscard]] inline VertexWeights weights_at(const Disc&, glm::ivec2) { return {1.0, 0.0, 0.0}; }

/// (0,0) at the upper left corner of the square (around the disc), (1,1) at the lower right one; the vertex's
/// own coordinate where it has one.
[[nodiscard]] Footprint footprint_at(const Square& s, const VertexUvs& uvs, glm::ivec2 p_fx8);
[[nodiscard]] Footprint footprint_at(const Disc& d, const VertexUvs& uvs, glm::ivec2 p_fx8);

}  // namespace lode::raster::reference
