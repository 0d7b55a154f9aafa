#pragma once
/// render(frame, image) is a pure function of the frame: the same bytes for any number of threads, any tile
/// size, any processor, compiler and build type. notes/rasterization.md has the rules.

#include <cstddef>
#include <functional>
#include <span>

#include "raster/frame.h"
#include "raster/image.h"
#include "raster/stats.h"

namespace lode::raster {

/// Changes only when a rule that decides pixels changes; notes/pixel_contract.md says which pixels moved.
inline constexpr int kPixelContract = 1;

/// Neither the number of threads nor the tile size moves a pixel.
struct RenderOptions {
  int threads = 0;         ///< 0: one per processor; at most 256 are used
  int tile_size_px = 64;   ///< 8…256, a power of two; counters depend on it
  std::span<DrawStats> per_draw = {};  ///< empty, or one element a draw, overwritten
  bool ids_from_ordered_draws = false;  ///< draws that write no depth leave their ids too (for `draw --print`)
  /// Called once for each finished tile, from any worker; must not throw. n_tiles(…) says how many there are.
  std::function<void()> on_tile = {};
};

/// Tiles that a picture of this size is drawn in.
[[nodiscard]] inline std::size_t n_tiles(glm::ivec2 size_px, const RenderOptions& options) {
  const int tile = options.tile_size_px;
  return std::size_t((size_px.x + tile - 1) / tile) * std::size_t((size_px.y + tile - 1) / tile);
}

/// Clears the image and draws the frame into it. On an exception the image is as it was before.
/// Throws Error: bad_input (the message names draw and element), out_of_memory.
FrameStats render(const Frame& frame, Image& image, const RenderOptions& options = {});

}  // namespace lode::raster
