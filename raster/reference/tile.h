#pragma once
/// One tile of the picture: order-free draws into a visibility buffer, each visible sample shaded once, then
/// the ordered draws in submission order, and all of it for every sample position.

#include <cstdint>
#include <span>
#include <vector>

#include "raster/blend.h"
#include "raster/reference/assemble.h"
#include "raster/render.h"

namespace lode::raster::reference {

/// What a worker needs to draw tiles; allocated before the first tile, so that no tile can fail.
struct TileScratch {
  TileScratch(const Frame& frame, const Image& image, int tile_size_px, bool per_draw_stats);

  std::vector<float> depth;
  std::vector<std::uint32_t> owner;  ///< piece that last wrote depth, or kNoPiece: the clear loses to every fragment
  std::vector<Ids> ids;
  std::vector<glm::u8vec4> rgba8;
  std::vector<glm::vec4> rgba32f;
  std::vector<glm::uvec4> sum_rgba8;     ///< over samples, if there are several
  std::vector<glm::dvec4> sum_rgba32f;
  FrameStats stats;
  std::vector<DrawStats> per_draw;
};

struct TileJob {
  const Frame& frame;
  std::span<const Piece> pieces;
  std::span<const std::uint32_t> bin;  ///< pieces that may touch the tile's row, in submission order
  PixelBox box;                        ///< the tile's pixels
  bool ids_from_ordered_draws = false;
};

void draw_tile(const TileJob& job, TileScratch& scratch, Image& image);

}  // namespace lode::raster::reference
