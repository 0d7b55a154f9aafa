// Tiles to the image: four neighbours of a row lie together in a tile.
// Compiled once for each instruction set (Highway's re-included headers).

#include <algorithm>
#include <cstdint>
#include <cstring>

#include "raster/fast/kernels.h"

#if defined(LODE_RASTER_FAST_WRITE_INL_H_) == defined(HWY_TARGET_TOGGLE)
#ifdef LODE_RASTER_FAST_WRITE_INL_H_
#undef LODE_RASTER_FAST_WRITE_INL_H_
#else
#define LODE_RASTER_FAST_WRITE_INL_H_
#endif

#include "raster/fast/lanes-inl.h"

HWY_BEFORE_NAMESPACE();
namespace lode::raster::fast {
namespace HWY_NAMESPACE {

void WriteTile(const WriteJob& job) {
  const hn::CappedTag<float, 4> f;
  const auto* from = static_cast<const float*>(job.from);
  auto* to = static_cast<float*>(job.to);
  for (int y = 0; y < job.height_px; ++y) {
    float* row = to + std::size_t(y) * job.pitch_px;
    const int whole = hn::Lanes(f) == 4 ? job.width_px & ~3 : 0;
    for (int x = 0; x < whole; x += 4) {
      if (job.depths) {
        const auto v = hn::Load(f, from + place_in_tile(x, y));
        hn::StoreU(hn::IfThenElseZero(hn::Gt(v, hn::Zero(f)), v), f, row + x);  // of a zero, the positive one
      } else {
        std::memcpy(row + x, from + place_in_tile(x, y), 16);
      }
    }
    for (int x = whole; x < job.width_px; ++x) {
      float v;
      std::memcpy(&v, from + place_in_tile(x, y), 4);
      if (job.depths) v = v > 0.0f ? v : 0.0f;
      std::memcpy(row + x, &v, 4);
    }
  }
}

}  // namespace HWY_NAMESPACE
}  // namespace lode::raster::fast
HWY_AFTER_NAMESPACE();

#endif  // per-target include guard
