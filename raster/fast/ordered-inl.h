// Ordered draws of textured triangles: coverage, depth test, texels and blending over a tile.
// Compiled once for each instruction set (Highway's re-included headers).

#include <algorithm>
#include <bit>
#include <cstdint>

#include "raster/fast/kernels.h"

#if defined(LODE_RASTER_FAST_ORDERED_INL_H_) == defined(HWY_TARGET_TOGGLE)
#ifdef LODE_RASTER_FAST_ORDERED_INL_H_
#undef LODE_RASTER_FAST_ORDERED_INL_H_
#else
#define LODE_RASTER_FAST_ORDERED_INL_H_
#endif

#include "raster/fast/affine-inl.h"
#include "raster/fast/blend-inl.h"
#include "raster/fast/tint-inl.h"

HWY_BEFORE_NAMESPACE();
namespace lode::raster::fast {
namespace HWY_NAMESPACE {

/// Edge functions over blocks of 8×8 samples, in double: exact, as they are whole numbers below 2^53.
struct EdgeWalk {
  double step_x[3], step_y[3];  ///< per pixel
  double least[3], most[3];     ///< from a block's first sample to its least and greatest one
  alignas(64) double lane[3][16];
};

HWY_INLINE void SetEdgeWalk(const TexturedTriangle& t, EdgeWalk& w) {
  for (std::size_t i = 0; i < 3; ++i) {
    w.step_x[i] = 256.0 * t.edge_x[i];
    w.step_y[i] = 256.0 * t.edge_y[i];
    w.least[i] = 7.0 * (std::min(0.0, w.step_x[i]) + std::min(0.0, w.step_y[i]));
    w.most[i] = 7.0 * (std::max(0.0, w.step_x[i]) + std::max(0.0, w.step_y[i]));
    StoreLanes(w.step_x[i], w.step_y[i], w.lane[i]);
  }
}

/// Samples of a 4×4 inside the triangle; e: its first sample's edge values.
HWY_INLINE std::uint32_t CoveredLanes(const TexturedTriangle& t, const EdgeWalk& w, const double (&e)[3]) {
  const Doubles d;
  std::uint32_t lanes = 0;
  for (std::size_t l = 0; l < 16; l += hn::Lanes(d)) {
    const auto inside = [&](std::size_t i) HWY_ATTR {
      return hn::Ge(hn::Add(hn::Set(d, e[i]), hn::Load(d, w.lane[i] + l)), hn::Set(d, t.bias[i]));
    };
    lanes |= BitsOf(d, hn::And(hn::And(inside(0), inside(1)), inside(2))) << l;
  }
  return lanes;
}

/// Samples of a 4×4 at pixels [begin, end), counted from its first one.
inline std::uint32_t BoxLanes(int begin_x, int begin_y, int end_x, int end_y) {
  if (begin_x >= 4 || begin_y >= 4 || end_x <= 0 || end_y <= 0) return 0;
  const auto bits = [](int begin, int end) {
    return ((1u << std::min(end, 4)) - 1) & ~((1u << std::max(begin, 0)) - 1);
  };
  const std::uint32_t columns = bits(begin_x, end_x) * 0x1111u;
  std::uint32_t rows = 0;
  for (int y = 0; y < 4; ++y) rows |= (bits(begin_y, end_y) >> y & 1) * (0xFu << (4 * y));
  return columns & rows;
}

/// Of `lanes`, those strictly nearer than the tile's samples at `place`; samples that nothing owns have depth −1.
HWY_INLINE std::uint32_t NearerLanes(const TexturedTriangle& t, const EdgeWalk& w, const double (&e)[3],
                                     const float* depth, std::uint32_t lanes) {
  const Floats f;
  bool all_clear = true;
  for (std::size_t l = 0; l < 16; l += hn::Lanes(f)) {
    all_clear = all_clear && hn::AllTrue(f, hn::Lt(hn::Load(f, depth + l), hn::Zero(f)));
  }
  if (all_clear) return lanes;
  const Doubles d;
  const HalfFloats hf;
  std::uint32_t nearer = 0;
  for (std::size_t l = 0; l < 16; l += hn::Lanes(d)) {
    const auto edge = [&](std::size_t i) HWY_ATTR { return hn::Add(hn::Set(d, e[i]), hn::Load(d, w.lane[i] + l)); };
    const auto z = hn::Div(hn::Add(hn::Add(hn::Mul(edge(0), hn::Set(d, t.z[0])), hn::Mul(edge(1), hn::Set(d, t.z[1]))),
                                   hn::Mul(edge(2), hn::Set(d, t.z[2]))),
                           hn::Set(d, t.area));  // C5
    const auto inside = hn::DemoteTo(hf, hn::Min(hn::Max(z, hn::Set(d, t.z_low)), hn::Set(d, t.z_high)));
    nearer |= BitsOf(hf, hn::Gt(inside, hn::Load(hf, depth + l))) << l;
  }
  return lanes & nearer;
}

/// One triangle over a tile.
struct OrderedPainter {
  const OrderedJob& job;
  const TexturedTriangle& t;
  OrderedCounts& counts;
  AffineTexture affine;
  EdgeWalk walk;

  /// Blends the 4×4's samples in `lanes` at (x, y) of the tile.
  HWY_INLINE void Paint(int x, int y, std::uint32_t lanes, std::uint32_t* rgba8) {
    const int x_fx8 = x * 256 + job.sample_x_fx8, y_fx8 = y * 256 + job.sample_y_fx8;
    alignas(64) std::uint32_t bytes[16];
    std::uint32_t doubtful = 0;
    if (affine.n_levels > 0 && AffineTexelsOf(t, affine, x_fx8 / 256.0, y_fx8 / 256.0, bytes, doubtful)) {
      const std::uint32_t doubts = doubtful & lanes;
      counts.texels_read += std::uint64_t(4 * affine.n_levels) * std::uint64_t(std::popcount(lanes & ~doubts));
      if (HWY_UNLIKELY(doubts != 0)) counts.texels_read += ExactTexels(t, x_fx8, y_fx8, doubts, bytes);
    } else {
      counts.texels_read += TexelsOf(t, x_fx8, y_fx8, lanes, bytes);
    }
    if (t.has_color || t.has_vertex_colors) Tint(t, x_fx8, y_fx8, bytes);
    for (std::size_t l = 0; l < 16; l += hn::Lanes(Uints())) {
      const Uints du;
      const auto under = hn::Load(du, rgba8 + l);
      const auto over = Blended(job.blend, hn::Load(du, bytes + l), under);
      hn::Store(hn::IfThenElse(hn::RebindMask(du, LanesOf(lanes >> l)), over, under), du, rgba8 + l);
    }
    const auto n = std::uint64_t(std::popcount(lanes));
    counts.shaded += n;
    if (job.blend != Blend::none) counts.blended += n;
  }

  /// An 8×8 that is covered, not tested, not tinted and inside the picture; false, with nothing done, if it is not.
  HWY_INLINE bool PaintWhole(int x0, int y0, std::uint32_t* rgba8) {
    const Ints di;
    const Uints du;
    if (affine.n_levels == 0 || job.depth_test || t.has_color || t.has_vertex_colors) return false;
    const int x_fx8 = x0 * 256 + job.sample_x_fx8, y_fx8 = y0 * 256 + job.sample_y_fx8;
    std::int64_t x[2], y[2];
    for (int i = 0; i < affine.n_levels; ++i) {
      const AffineLevel& level = affine.levels[i];
      if (!StartAt(level.x, x_fx8 / 256.0, y_fx8 / 256.0, level.x.least_8x8, level.x.most_8x8, x[i]) ||
          !StartAt(level.y, x_fx8 / 256.0, y_fx8 / 256.0, level.y.least_8x8, level.y.most_8x8, y[i])) {
        return false;
      }
    }
    std::uint64_t n_exact = 0;
    for (std::size_t k = 0; k < 64; k += hn::Lanes(di)) {
      const std::size_t quarter = k / 16, lane = k % 16;
      I doubtful = hn::Zero(di);
      U texels = AffineTexelsAt(t, affine, x, y, quarter, lane, doubtful);
      if (HWY_UNLIKELY(!hn::AllFalse(di, hn::Ne(doubtful, hn::Zero(di))))) {
        alignas(64) std::uint32_t bytes[16];
        hn::Store(texels, du, bytes + lane);
        const std::uint32_t doubts = BitsOf(doubtful) << lane;
        n_exact += std::uint64_t(std::popcount(doubts));
        counts.texels_read +=
            ExactTexels(t, x_fx8 + 1024 * int(quarter & 1), y_fx8 + 1024 * int(quarter >> 1), doubts, bytes);
        texels = hn::Load(du, bytes + lane);
      }
      hn::Store(Blended(job.blend, texels, hn::Load(du, rgba8 + k)), du, rgba8 + k);
    }
    counts.covered += 64;
    counts.shaded += 64;
    if (job.blend != Blend::none) counts.blended += 64;
    counts.texels_read += std::uint64_t(4 * affine.n_levels) * (64 - n_exact);
    return true;
  }

  HWY_INLINE void Block(int bx, int by, const double (&first)[3]) {
    const int x0 = bx * kBlock_px, y0 = by * kBlock_px;
    bool whole = job.begin_x <= x0 && job.begin_y <= y0 && x0 + kBlock_px <= job.end_x && y0 + kBlock_px <= job.end_y;
    for (std::size_t i = 0; i < 3; ++i) whole = whole && first[i] + walk.least[i] >= t.bias[i];
    if (whole && PaintWhole(x0, y0, job.rgba8 + (by * kBlocksPerRow + bx) * 64)) return;
    for (int quarter = 0; quarter < 4; ++quarter) {
      const int x = x0 + (quarter & 1) * 4, y = y0 + (quarter >> 1) * 4;
      const int place = (by * kBlocksPerRow + bx) * 64 + quarter * 16;
      double e[3];
      for (std::size_t i = 0; i < 3; ++i) {
        e[i] = first[i] + walk.step_x[i] * double(x - x0) + walk.step_y[i] * double(y - y0);
      }
      std::uint32_t lanes = 0xFFFF;
      if (!whole) {
        lanes = CoveredLanes(t, walk, e) & BoxLanes(job.begin_x - x, job.begin_y - y, job.end_x - x, job.end_y - y);
      }
      const int n_covered = std::popcount(lanes);
      counts.covered += std::uint64_t(n_covered);
      if (job.depth_test && lanes != 0) {
        lanes = NearerLanes(t, walk, e, job.tile->depth + place, lanes);
        counts.depth_failed += std::uint64_t(n_covered - std::popcount(lanes));
      }
      if (lanes != 0) Paint(x, y, lanes, job.rgba8 + place);
    }
  }

  void Tile() {
    const int bx0 = job.begin_x >> 3, by0 = job.begin_y >> 3, bx1 = (job.end_x - 1) >> 3, by1 = (job.end_y - 1) >> 3;
    for (int by = by0; by <= by1; ++by) {
      for (int bx = bx0; bx <= bx1; ++bx) {
        const double x_fx8 = bx * 2048 + job.sample_x_fx8, y_fx8 = by * 2048 + job.sample_y_fx8;
        double first[3];
        bool misses = false;
        for (std::size_t i = 0; i < 3; ++i) {
          first[i] = t.edge_x[i] * x_fx8 + t.edge_y[i] * y_fx8 + t.edge_c[i];
          misses = misses || first[i] + walk.most[i] < t.bias[i];
        }
        if (!misses) Block(bx, by, first);
      }
    }
  }
};

void DrawTextured(const OrderedJob& job, OrderedCounts& counts) {
  if (job.begin_x >= job.end_x || job.begin_y >= job.end_y) return;
  OrderedPainter painter{job, *job.triangle, counts, {}, {}};
  SetAffineTexture(*job.triangle, painter.affine);
  SetEdgeWalk(*job.triangle, painter.walk);
  painter.Tile();
}

}  // namespace HWY_NAMESPACE
}  // namespace lode::raster::fast
HWY_AFTER_NAMESPACE();

#endif  // per-target include guard
