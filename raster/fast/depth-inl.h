// The hierarchical depth: the least depth of each 8×8 block.
// Compiled once for each instruction set (Highway's re-included headers).

#include <algorithm>
#include <cmath>
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

float LeastOfBlock(const TileBuffers& tile, int block) {
  const Floats f;
  auto least = hn::Load(f, tile.depth + 64 * block);
  for (std::size_t i = hn::Lanes(f); i < 64; i += hn::Lanes(f))
    least = hn::Min(least, hn::Load(f, tile.depth + 64 * block + i));
  return hn::GetLane(hn::MinOfLanes(f, least));
}

float LeastDepth(TileBuffers& tile, int begin_x, int begin_y, int end_x, int end_y) {
  float least = 2.0f;
  for (int by = begin_y >> 3; by <= (end_y - 1) >> 3; ++by) {
    for (int bx = begin_x >> 3; bx <= (end_x - 1) >> 3; ++bx) {
      const int block = by * kBlocksPerRow + bx;
      if (tile.stale[block]) {
        tile.stale[block] = 0;
        tile.block_min[block] = LeastOfBlock(tile, block);
      }
      least = std::min(least, tile.block_min[block]);
      if (least < 0.0f) return least;
    }
  }
  return least;
}

}  // namespace HWY_NAMESPACE
}  // namespace lode::raster::fast
HWY_AFTER_NAMESPACE();

#endif  // per-target include guard
