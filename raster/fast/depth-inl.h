// The hierarchical depth: the least depth of each 8×8 block.
// Compiled once for each instruction set (Highway's re-included headers).

#include <algorithm>
#include <cstdint>

#include "raster/fast/kernels.h"

#if defined(LODE_RASTER_FAST_DEPTH_INL_H_) == defined(HWY_TARGET_TOGGLE)
#ifdef LODE_RASTER_FAST_DEPTH_INL_H_
#undef LODE_RASTER_FAST_DEPTH_INL_H_
#else
#define LODE_RASTER_FAST_DEPTH_INL_H_
#endif

#include "raster/fast/lanes-inl.h"

HWY_BEFORE_NAMESPACE();
namespace lode::raster::fast {
namespace HWY_NAMESPACE {

HWY_INLINE float LeastOfBlock(const TileBuffers& tile, int block) {
  const Floats f;
  auto least = hn::Load(f, tile.depth + 64 * block);
  for (std::size_t i = hn::Lanes(f); i < 64; i += hn::Lanes(f))
    least = hn::Min(least, hn::Load(f, tile.depth + 64 * block + i));
  return hn::GetLane(hn::MinOfLanes(f, least));
}

/// True if every sample of the block is nearer than that. Depths only grow, so what was found is a bound while it is
/// stale, and a stale block is looked at again only where the bound does not tell.
HWY_INLINE bool BlockHidden(TileBuffers& tile, int block, float nearest) {
  if (nearest < tile.block_min[block]) return true;
  if ((tile.written[block] & kStale) == 0) return false;
  tile.written[block] = kTouched;
  tile.block_min[block] = LeastOfBlock(tile, block);
  return nearest < tile.block_min[block];
}

bool Hidden(TileBuffers& tile, const reference::PixelBox& pixels, float nearest) {
  const int x0 = pixels.begin_px.x >> 3, y0 = pixels.begin_px.y >> 3;
  const int x1 = (pixels.end_px.x - 1) >> 3, y1 = (pixels.end_px.y - 1) >> 3;
  for (int y = y0; y <= y1; ++y) {
    for (int x = x0; x <= x1; ++x) {
      if (!BlockHidden(tile, y * kBlocksPerRow + x, nearest)) return false;
    }
  }
  return true;
}

}  // namespace HWY_NAMESPACE
}  // namespace lode::raster::fast
HWY_AFTER_NAMESPACE();

#endif  // per-target include guard
