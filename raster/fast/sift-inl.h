// Triangles of a cluster, sixteen at a time: those without samples, turned away or without area are dropped, the
// others sorted by how they will be walked.
// Compiled once for each instruction set (Highway's re-included headers).

#include <algorithm>
#include <cstdint>

#include "raster/fast/kernels.h"

#if defined(LODE_RASTER_FAST_SIFT_INL_H_) == defined(HWY_TARGET_TOGGLE)
#ifdef LODE_RASTER_FAST_SIFT_INL_H_
#undef LODE_RASTER_FAST_SIFT_INL_H_
#else
#define LODE_RASTER_FAST_SIFT_INL_H_
#endif

#include "raster/fast/lanes-inl.h"

HWY_BEFORE_NAMESPACE();
namespace lode::raster::fast {
namespace HWY_NAMESPACE {

HWY_INLINE I Least(I a, I b, I c) { return hn::Min(hn::Min(a, b), c); }
HWY_INLINE I Most(I a, I b, I c) { return hn::Max(hn::Max(a, b), c); }

/// Stores the lanes of the mask next to each other. (Compressing in a register: to memory it is slow on some machines.)
template <class Mask>
HWY_INLINE void StoreTogether(I v, Mask mask, std::int32_t* to) {
  hn::StoreU(hn::Compress(v, mask), Ints(), to);
}

/// Triangles to be walked in one way, [n] and padding.
struct TriangleList {
  static constexpr int kMost = kMaxClusterTriangles + 16;
  alignas(64) std::int32_t x[3][kMost], y[3][kMost];  ///< corners in the order of the mesh, from the tile's corner
  alignas(64) std::int32_t triangle[kMost];
  int n = 0;

  template <class Mask>
  HWY_INLINE void Add(const I (&cx)[3], const I (&cy)[3], I t, Mask mask) {
    const auto count = int(hn::CountTrue(Ints(), mask));
    if (count == 0) return;
    for (int k = 0; k < 3; ++k) {
      StoreTogether(cx[k], mask, x[k] + n);
      StoreTogether(cy[k], mask, y[k] + n);
    }
    StoreTogether(t, mask, triangle + n);
    n += count;
  }
};

/// Most pixels of a tiny triangle's box: four across, and four, eight or sixteen down.
constexpr int kTinyWidth = 4, kFlatHeight = 4, kTallHeight = 8, kTowerHeight = 16;

struct Sifted {
  TriangleList flat, tall, tower;             ///< tiny
  TriangleList medium;                        ///< corners at most 64 px apart
  std::int32_t others[kMaxClusterTriangles];  ///< larger, or so thin that their facing is in doubt
  int n_others = 0;
};

/// Pixels whose samples the triangles' boxes hold, inside what may be written.
struct PixelBoxes {
  I begin_x, begin_y, end_x, end_y;
};
HWY_INLINE PixelBoxes BoxesOf(const RasterJob& job, const I (&x)[3], const I (&y)[3]) {
  const Ints di;
  const auto sx = hn::Set(di, job.sample_x_fx8), sy = hn::Set(di, job.sample_y_fx8), up = hn::Set(di, 255),
             one = hn::Set(di, 1);
  const auto x0 = Least(x[0], x[1], x[2]), x1 = Most(x[0], x[1], x[2]);
  const auto y0 = Least(y[0], y[1], y[2]), y1 = Most(y[0], y[1], y[2]);
  return {hn::Max(hn::Set(di, job.begin_x), hn::ShiftRight<8>(hn::Add(hn::Sub(x0, sx), up))),
          hn::Max(hn::Set(di, job.begin_y), hn::ShiftRight<8>(hn::Add(hn::Sub(y0, sy), up))),
          hn::Min(hn::Set(di, job.end_x), hn::Add(hn::ShiftRight<8>(hn::Sub(x1, sx)), one)),
          hn::Min(hn::Set(di, job.end_y), hn::Add(hn::ShiftRight<8>(hn::Sub(y1, sy)), one))};
}

/// Corners of the n triangles of a list from `first`, a triangle a lane, and their depths.
HWY_INLINE void LoadCorners(const RasterJob& job, const TriangleList& list, int first, int n, I (&x)[3], I (&y)[3],
                            double (&z)[3][16]) {
  const Ints di;
  for (int k = 0; k < 3; ++k) x[k] = hn::LoadU(di, list.x[k] + first), y[k] = hn::LoadU(di, list.y[k] + first);
  for (int i = 0; i < n; ++i) {
    const std::uint8_t* corners = job.corners + 3 * list.triangle[first + i];
    for (int k = 0; k < 3; ++k) z[k][i] = job.vertices->z[corners[k]];
  }
}

/// Doubled areas; exact where the corners are at most 2^14 apart, otherwise anything.
HWY_INLINE I DoubledArea(const I (&x)[3], const I (&y)[3]) {
  return hn::Sub(hn::Mul(hn::Sub(x[1], x[0]), hn::Sub(y[2], y[0])), hn::Mul(hn::Sub(y[1], y[0]), hn::Sub(x[2], x[0])));
}

void Sift(const RasterJob& job, RasterCounts& counts, Sifted& out) {
  const Ints di;
  // Corners side by side. Reading eight bytes a corner beats gathers.
  alignas(64) std::uint64_t corners[3][TriangleList::kMost];
  for (int t = 0; t < job.n_triangles; ++t) {
    for (int k = 0; k < 3; ++k) corners[k][t] = job.vertices->xy_fx8[job.corners[3 * t + k]];
  }
  const auto zero = hn::Zero(di);
  const auto none = hn::Lt(zero, zero);
  for (int first = 0; first < job.n_triangles; first += int(hn::Lanes(di))) {
    const auto triangle = hn::Add(hn::Set(di, first), hn::Iota(di, 0));
    auto alive = hn::Lt(triangle, hn::Set(di, job.n_triangles));
    if (job.wanted) {
      const auto bits = std::int32_t(job.wanted[first >> 6] >> (first & 63) & 0xFFFF);
      const auto bit = hn::Shl(hn::Set(di, 1), hn::Iota(di, 0));
      alive = hn::And(alive, hn::Ne(hn::And(hn::Set(di, bits), bit), zero));
    }
    const auto n_in = hn::CountTrue(di, alive);
    if (n_in == 0) continue;
    counts.triangles_in += n_in;
    I x[3], y[3];
    for (int k = 0; k < 3; ++k) {
      hn::LoadInterleaved2(di, reinterpret_cast<const std::int32_t*>(corners[k] + first), x[k], y[k]);
    }
    const PixelBoxes box = BoxesOf(job, x, y);
    const auto w = hn::Sub(box.end_x, box.begin_x), h = hn::Sub(box.end_y, box.begin_y);
    if (job.skips.samples) {
      alive = hn::And(alive, hn::And(hn::Gt(w, zero), hn::Gt(h, zero)));
      counts.no_sample += n_in - hn::CountTrue(di, alive);
      if (hn::AllFalse(di, alive)) continue;
    }
    const auto extent_x = hn::Sub(Most(x[0], x[1], x[2]), Least(x[0], x[1], x[2]));
    const auto extent_y = hn::Sub(Most(y[0], y[1], y[2]), Least(y[0], y[1], y[2]));
    const auto narrow = hn::And(alive, hn::Lt(hn::Max(extent_x, extent_y), hn::Set(di, 64 * 256)));
    // The area is exact where narrow; the others are looked at one by one.
    const auto area = DoubledArea(x, y);
    const auto empty = hn::And(narrow, hn::Eq(area, zero));
    auto dropped = empty;
    auto doubtful = none;
    counts.empty += hn::CountTrue(di, empty);
    if (job.cull != Cull::none) {
      // Counter-clockwise as seen has a negative area with y down. A corner moves by half a sub-pixel when it snaps, a
      // difference of two by less than 1, so beyond the doubt the unsnapped determinant has the area's sign.
      const auto wanted = job.cull == Cull::back ? hn::Neg(area) : area;
      const auto away = hn::And(narrow, hn::Lt(wanted, zero));
      counts.facing += hn::CountTrue(di, away);
      dropped = hn::Or(dropped, away);
      const auto doubt = hn::Add(hn::ShiftLeft<1>(hn::Add(extent_x, extent_y)), hn::Set(di, 4));
      doubtful = hn::And(narrow, hn::Not(hn::Gt(wanted, doubt)));
    }
    const auto plain = hn::AndNot(hn::Or(dropped, doubtful), narrow);
    const auto thin = hn::And(plain, hn::Not(hn::Gt(w, hn::Set(di, kTinyWidth))));
    const auto flat = hn::And(thin, hn::Not(hn::Gt(h, hn::Set(di, kFlatHeight))));
    const auto tall = hn::And(thin, hn::Not(hn::Gt(h, hn::Set(di, kTallHeight))));
    const auto tiny = hn::And(thin, hn::Not(hn::Gt(h, hn::Set(di, kTowerHeight))));
    out.flat.Add(x, y, triangle, flat);
    out.tall.Add(x, y, triangle, hn::AndNot(flat, tall));
    out.tower.Add(x, y, triangle, hn::AndNot(tall, tiny));
    out.medium.Add(x, y, triangle, hn::AndNot(tiny, plain));
    const auto others = hn::AndNot(hn::Or(dropped, plain), alive);
    if (hn::AllFalse(di, others)) continue;
    alignas(64) std::int32_t list[16];
    StoreTogether(triangle, others, list);
    const auto n_others = int(hn::CountTrue(di, others));
    std::copy_n(list, n_others, out.others + out.n_others);
    out.n_others += n_others;
  }
}

}  // namespace HWY_NAMESPACE
}  // namespace lode::raster::fast
HWY_AFTER_NAMESPACE();

#endif  // per-target include guard
