// Tiles to the image: four neighbours of a row lie together in a tile.
// Compiled once for each instruction set (Highway's re-included headers).

#include <algorithm>
#include <cstdint>

#include "raster/fast/kernels.h"

#if defined(LODE_RASTER_FAST_WRITE_INL_H_) == defined(HWY_TARGET_TOGGLE)
#ifdef LODE_RASTER_FAST_WRITE_INL_H_
#undef LODE_RASTER_FAST_WRITE_INL_H_
#else
#define LODE_RASTER_FAST_WRITE_INL_H_
#endif

#include <hwy/cache_control.h>

#include "raster/fast/lanes-inl.h"

HWY_BEFORE_NAMESPACE();
namespace lode::raster::fast {
namespace HWY_NAMESPACE {

/// Pixels of a row of the tile, beginning with x (a multiple of four), from the fours that lie together.
template <class Tag>
HWY_INLINE hn::Vec<Tag> PixelsOfRow(Tag tag, const std::int32_t* from, int x, int y) {
  if constexpr (hn::MaxLanes(Tag()) > 4) {
    const hn::Half<Tag> half;
    return hn::Combine(tag, PixelsOfRow(half, from, x + int(hn::MaxLanes(Tag())) / 2, y), PixelsOfRow(half, from, x, y));
  } else {
    return hn::Load(tag, from + place_in_tile(x, y));
  }
}

/// What nothing owns has depth 0, and of a zero, the positive one is written.
HWY_INLINE I AsWritten(I v, bool depths) {
  const Floats f;
  const Ints di;
  if (!depths) return v;
  return hn::BitCast(di, hn::IfThenElseZero(hn::Gt(hn::BitCast(f, v), hn::Zero(f)), hn::BitCast(f, v)));
}

/// Strips of two blocks side by side are written together: a row of both is a line of the cache.
constexpr int kStrip_px = 2 * kBlock_px;

/// A whole strip; from: its first pixel in the tile, null for the clear's.
HWY_INLINE void WriteStrip(const std::int32_t* from, std::int32_t* to, std::size_t pitch_px, I clear, bool depths, bool stream) {
  const Ints di;
  constexpr int kLanes = int(hn::MaxLanes(Ints()));
  for (int y = 0; y < kBlock_px; ++y) {
    for (int x = 0; x < kStrip_px; x += kLanes) {
      const auto v = from ? AsWritten(PixelsOfRow(di, from, x, y), depths) : clear;
      if (stream) {
        hn::Stream(v, di, to + std::size_t(y) * pitch_px + x);
      } else {
        hn::StoreU(v, di, to + std::size_t(y) * pitch_px + x);
      }
    }
  }
}

void WriteTile(const WriteJob& job) {
  const Ints di;
  const auto* from = static_cast<const std::int32_t*>(job.from);
  auto* to = static_cast<std::int32_t*>(job.to);
  const auto clear = hn::Set(di, std::int32_t(job.clear));
  const bool stream = job.stream && (reinterpret_cast<std::uintptr_t>(to) | job.pitch_px * 4) % 64 == 0;
  const auto touched = [&](int x, int y) {
    return !job.written || (job.written[y / kBlock_px * kBlocksPerRow + x / kBlock_px] & kTouched) != 0;
  };
  for (int y = 0; y < job.height_px; y += kBlock_px) {
    for (int x = 0; x < job.width_px; x += kStrip_px) {
      const bool any = from && (touched(x, y) || touched(x + kBlock_px, y));
      std::int32_t* at = to + std::size_t(y) * job.pitch_px + x;
      if (job.width_px - x >= kStrip_px && job.height_px - y >= kBlock_px) {
        if (!any) {
          WriteStrip(nullptr, at, job.pitch_px, clear, false, stream);
        } else {
          WriteStrip(from + place_in_tile(x, y), at, job.pitch_px, clear, job.depths, stream);
        }
        continue;
      }
      for (int dy = 0; dy < std::min(kBlock_px, job.height_px - y); ++dy) {
        for (int dx = 0; dx < std::min(kStrip_px, job.width_px - x); ++dx) {
          std::int32_t v = any ? from[place_in_tile(x + dx, y + dy)] : std::int32_t(job.clear);
          if (job.depths && v < 0) v = 0;  // of floats: negative, or the negative zero
          at[std::size_t(dy) * job.pitch_px + std::size_t(dx)] = v;
        }
      }
    }
  }
  if (stream) hwy::FlushStream();  // before anybody is told that the tile is done
}

void Clear(std::uint32_t* to, std::size_t n, std::uint32_t value) { Fill(to, n, value); }

}  // namespace HWY_NAMESPACE
}  // namespace lode::raster::fast
HWY_AFTER_NAMESPACE();

#endif  // per-target include guard
