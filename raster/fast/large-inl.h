// Triangles of any size, by themselves: edge values in double, where they are exact; blocks of 8×8 skipped by edges and
// by depth. Compiled once for each instruction set (Highway's re-included headers).

#include <algorithm>
#include <cmath>
#include <cstdint>

#include "raster/fast/kernels.h"

#if defined(LODE_RASTER_FAST_LARGE_INL_H_) == defined(HWY_TARGET_TOGGLE)
#ifdef LODE_RASTER_FAST_LARGE_INL_H_
#undef LODE_RASTER_FAST_LARGE_INL_H_
#else
#define LODE_RASTER_FAST_LARGE_INL_H_
#endif

#include "raster/fast/depth-inl.h"
#include "raster/fast/lanes-inl.h"
#include "raster/fast/medium-inl.h"
#include "raster/fast/plane-inl.h"

HWY_BEFORE_NAMESPACE();
namespace lode::raster::fast {
namespace HWY_NAMESPACE {

/// A triangle ready for its samples: canonical order, edge functions positive inside, all whole numbers below 2^49.
struct LargeSetup {
  double right[3], down[3];  ///< what a pixel adds
  double bias[3];
  double area;
  double z[3], z_low, z_high;
  std::int32_t x[3], y[3];
  int begin_x, begin_y, end_x, end_y;
  std::uint32_t owner;
};

/// False if it covers nothing.
bool SetUpLarge(const RasterJob& job, const LoneTriangle& t, LargeSetup& s) {
  const std::int64_t area = std::int64_t(t.x_fx8[1] - t.x_fx8[0]) * (t.y_fx8[2] - t.y_fx8[0]) -
                            std::int64_t(t.y_fx8[1] - t.y_fx8[0]) * (t.x_fx8[2] - t.x_fx8[0]);
  if (area == 0) return false;
  const double sign = area > 0 ? 1.0 : -1.0;
  s.area = double(area) * sign;
  for (std::size_t k = 0; k < 3; ++k) {
    const std::size_t a = (k + 1) % 3, b = (k + 2) % 3;
    const double dx = sign * (t.x_fx8[b] - t.x_fx8[a]), dy = sign * (t.y_fx8[b] - t.y_fx8[a]);
    s.right[k] = -256.0 * dy, s.down[k] = 256.0 * dx;
    s.bias[k] = dy < 0.0 || (dy == 0.0 && dx > 0.0) ? 0.0 : 1.0;
    s.x[k] = t.x_fx8[k], s.y[k] = t.y_fx8[k], s.z[k] = t.z[k];
  }
  const auto [x0, x1] = std::minmax({s.x[0], s.x[1], s.x[2]});
  const auto [y0, y1] = std::minmax({s.y[0], s.y[1], s.y[2]});
  s.begin_x = std::max(job.begin_x, (x0 - job.sample_x_fx8 + 255) >> 8);
  s.end_x = std::min(job.end_x, ((x1 - job.sample_x_fx8) >> 8) + 1);
  s.begin_y = std::max(job.begin_y, (y0 - job.sample_y_fx8 + 255) >> 8);
  s.end_y = std::min(job.end_y, ((y1 - job.sample_y_fx8) >> 8) + 1);
  s.z_low = std::min({s.z[0], s.z[1], s.z[2]}), s.z_high = std::max({s.z[0], s.z[1], s.z[2]});
  s.owner = t.owner;
  return s.begin_x < s.end_x && s.begin_y < s.end_y;
}

/// C5 for a vector of samples, by division.
HWY_INLINE hn::Vec<HalfFloats> DividedDepths(const LargeSetup& s, const hn::Vec<Doubles> (&e)[3]) {
  const Doubles d;
  const auto sum = hn::Add(hn::Add(hn::Mul(e[0], hn::Set(d, s.z[0])), hn::Mul(e[1], hn::Set(d, s.z[1]))),
                           hn::Mul(e[2], hn::Set(d, s.z[2])));
  const auto z = hn::Div(sum, hn::Set(d, s.area));
  return hn::DemoteTo(HalfFloats(), hn::Min(hn::Max(z, hn::Set(d, s.z_low)), hn::Set(d, s.z_high)));
}

/// Values at a block's first sample, and the lanes' offsets from there.
struct LargeWalk {
  alignas(64) double edge_lane[3][16];  ///< of a 4×4
  alignas(64) double depth_lane[16];
  double base[3];            ///< edges at the first sample of the first block
  double most[3], least[3];  ///< from a block's first sample to its best and its worst
  double z, z_right, z_down, z_gain, z_error;
};
HWY_INLINE void PrepareWalk(const RasterJob& job, const LargeSetup& s, int bx0, int by0, LargeWalk& walk) {
  const double px = bx0 * 2048 + job.sample_x_fx8, py = by0 * 2048 + job.sample_y_fx8;
  const double inverse = 1.0 / s.area;
  double sum = 0.0, right = 0.0, down = 0.0, terms = 0.0;
  for (int k = 0; k < 3; ++k) {
    const int a = (k + 1) % 3;  // any corner on the edge
    walk.base[k] = s.down[k] / 256.0 * (py - s.y[a]) + s.right[k] / 256.0 * (px - s.x[a]);
    walk.most[k] = 7.0 * (std::max(0.0, s.right[k]) + std::max(0.0, s.down[k]));
    walk.least[k] = 7.0 * (std::min(0.0, s.right[k]) + std::min(0.0, s.down[k]));
    StoreLanes(s.right[k], s.down[k], walk.edge_lane[k]);
    sum += walk.base[k] * s.z[k], right += s.right[k] * s.z[k], down += s.down[k] * s.z[k];
    terms += (std::fabs(walk.base[k]) + kTile_px * (std::fabs(s.right[k]) + std::fabs(s.down[k]))) * s.z[k];
  }
  walk.z = sum * inverse, walk.z_right = right * inverse, walk.z_down = down * inverse;
  walk.z_error = terms * inverse * kPlaneError;
  walk.z_gain = 7.0 * (std::max(0.0, walk.z_right) + std::max(0.0, walk.z_down)) + walk.z_error;
  StoreLanes(walk.z_right, walk.z_down, walk.depth_lane);
}

/// Half of the lanes of a 4×4, from lane `at`: which are covered, and how near they are.
struct LargeSamples {
  hn::Vec<HalfInts> inside;  ///< −1 or 0
  hn::Vec<HalfFloats> depth;
};
HWY_INLINE LargeSamples SampleHalf(const LargeSetup& s, const LargeWalk& walk, const double (&e)[3], double z, int x_px,
                                   int y_px, bool whole, std::size_t at) {
  const Doubles d;
  const HalfInts hi;
  const HalfFloats hf;
  hn::Vec<Doubles> edges[3];
  LargeSamples out;
  out.inside = hn::Set(hi, -1);
  if (!whole) {
    for (int k = 0; k < 3; ++k) edges[k] = hn::Add(hn::Set(d, e[k]), hn::Load(d, walk.edge_lane[k] + at));
    const auto in = hn::And(hn::And(hn::Ge(edges[0], hn::Set(d, s.bias[0])), hn::Ge(edges[1], hn::Set(d, s.bias[1]))),
                            hn::Ge(edges[2], hn::Set(d, s.bias[2])));
    const auto lx = hn::Load(hi, kLaneX + at), ly = hn::Load(hi, kLaneY + at);
    const auto in_box =
        hn::And(hn::And(hn::Gt(lx, hn::Set(hi, s.begin_x - x_px - 1)), hn::Lt(lx, hn::Set(hi, s.end_x - x_px))),
                hn::And(hn::Gt(ly, hn::Set(hi, s.begin_y - y_px - 1)), hn::Lt(ly, hn::Set(hi, s.end_y - y_px))));
    out.inside = hn::And(hn::VecFromMask(hi, in_box), hn::DemoteTo(hi, hn::IfThenElseZero(in, hn::Set(d, -1.0))));
  }
  const RoundedDepths r =
      RoundBoth(hn::Add(hn::Set(d, z), hn::Load(d, walk.depth_lane + at)), hn::Set(d, walk.z_error));
  out.depth = r.low;
  if (HWY_UNLIKELY(!hn::AllFalse(hf, hn::Ne(r.low, r.high)))) {
    for (int k = 0; k < 3; ++k) edges[k] = hn::Add(hn::Set(d, e[k]), hn::Load(d, walk.edge_lane[k] + at));
    out.depth = DividedDepths(s, edges);
  }
  return out;
}

/// One 4×4 of a block; e: edges at its first sample, z: the plane there.
HWY_INLINE int DrawQuarter(const RasterJob& job, const LargeSetup& s, const LargeWalk& walk, const double (&e)[3],
                           double z, int x_px, int y_px, bool whole, TileBuffers& tile, RasterCounts& counts) {
  const Ints di;
  const Floats f;
  const int place = place_in_tile(x_px, y_px);
  int passed = 0;
  for (std::size_t l = 0; l < 16; l += hn::Lanes(di)) {
    const LargeSamples first = SampleHalf(s, walk, e, z, x_px, y_px, whole, l);
    const LargeSamples second = SampleHalf(s, walk, e, z, x_px, y_px, whole, l + hn::Lanes(Doubles()));
    const auto inside = hn::MaskFromVec(BothHalves(di, first.inside, second.inside));
    const auto n = hn::CountTrue(di, inside);
    counts.fragments += n;
    if (n == 0) continue;
    passed += KeepNearer(job, tile, place + int(l), hn::RebindMask(f, inside), BothHalves(f, first.depth, second.depth),
                         s.owner);
  }
  return passed;
}

/// The same with an alpha test: only what nothing nearer hides is shaded for it.
HWY_INLINE int DrawTestedQuarter(const RasterJob& job, const LargeSetup& s, const LargeWalk& walk, const double (&e)[3],
                                 double z, int x_px, int y_px, bool whole, TileBuffers& tile, RasterCounts& counts) {
  const Ints di;
  const Floats f;
  const int place = place_in_tile(x_px, y_px);
  alignas(64) float depths[16];
  std::uint32_t covered = 0, visible = 0;
  for (std::size_t l = 0; l < 16; l += hn::Lanes(di)) {
    const LargeSamples first = SampleHalf(s, walk, e, z, x_px, y_px, whole, l);
    const LargeSamples second = SampleHalf(s, walk, e, z, x_px, y_px, whole, l + hn::Lanes(Doubles()));
    const auto inside = hn::RebindMask(f, hn::MaskFromVec(BothHalves(di, first.inside, second.inside)));
    const auto depth = BothHalves(f, first.depth, second.depth);
    hn::Store(depth, f, depths + l);
    covered |= BitsOf(f, inside) << l;
    visible |= BitsOf(f, hn::And(inside, hn::Ge(depth, hn::Load(f, tile.depth + place + l)))) << l;
  }
  counts.fragments += hwy::PopCount(covered);
  if (visible == 0) return 0;
  const std::uint32_t passing = job.passing(job.context, x_px, y_px, visible);
  counts.alpha_failed += hwy::PopCount(visible & ~passing);
  int passed = 0;
  for (std::size_t l = 0; l < 16 && passing >> l != 0; l += hn::Lanes(di)) {
    const auto passes = hn::TestBit(hn::Set(di, std::int32_t(passing)), hn::Load(di, kLaneBit + l));
    passed += KeepNearer(job, tile, place + int(l), hn::RebindMask(f, passes), hn::Load(f, depths + l), s.owner);
  }
  if (passed == 0 || !job.won) return passed;
  std::uint32_t won = 0;
  for (std::size_t l = 0; l < 16; l += hn::Lanes(di)) {
    const auto owners = hn::Load(di, reinterpret_cast<const std::int32_t*>(tile.owner + place + l));
    won |= BitsOf(di, hn::Eq(owners, hn::Set(di, std::int32_t(s.owner)))) << l;
  }
  job.won(job.context, x_px, y_px, won);
  return passed;
}

int RasterizeLarge(const RasterJob& job, const LoneTriangle& triangle, TileBuffers& tile, RasterCounts& counts) {
  LargeSetup s;
  if (!SetUpLarge(job, triangle, s)) return 0;
  const int bx0 = s.begin_x >> 3, by0 = s.begin_y >> 3, bx1 = (s.end_x - 1) >> 3, by1 = (s.end_y - 1) >> 3;
  LargeWalk walk;
  PrepareWalk(job, s, bx0, by0, walk);
  if (job.skips.blocks) {
    // The plane over the whole box first: of a tilted triangle, this part may be hidden though the nearest is not.
    const int across = 8 * (bx1 - bx0), down = 8 * (by1 - by0);
    const double most = walk.z + walk.z_gain + std::max(0.0, walk.z_right * across) + std::max(0.0, walk.z_down * down);
    const reference::PixelBox box = {{s.begin_x, s.begin_y}, {s.end_x, s.end_y}};
    if (Hidden(tile, box, float(std::min(s.z_high, most) * (1.0 + 0x1p-22)))) {
      counts.blocks_hidden += std::uint64_t(bx1 - bx0 + 1) * std::uint64_t(by1 - by0 + 1);
      return 0;
    }
  }
  int n_passed = 0;
  for (int by = by0; by <= by1; ++by) {
    for (int bx = bx0; bx <= bx1; ++bx) {
      const double right = 8.0 * (bx - bx0), down = 8.0 * (by - by0);
      double e[3];
      bool misses = false;
      bool whole = bx * 8 >= s.begin_x && bx * 8 + 8 <= s.end_x && by * 8 >= s.begin_y && by * 8 + 8 <= s.end_y;
      for (int k = 0; k < 3; ++k) {
        e[k] = walk.base[k] + s.right[k] * right + s.down[k] * down;
        misses |= e[k] + walk.most[k] < s.bias[k];
        whole &= e[k] + walk.least[k] >= s.bias[k];
      }
      const double z = walk.z + (walk.z_right * right + walk.z_down * down);
      const int block = by * kBlocksPerRow + bx;
      if (job.skips.blocks) {
        if (misses) {
          ++counts.blocks_outside;
          continue;
        }
        const double nearest = std::min(s.z_high, z + walk.z_gain) * (1.0 + 0x1p-22);
        if (BlockHidden(tile, block, float(nearest))) {
          ++counts.blocks_hidden;
          continue;
        }
      }
      ++counts.blocks;
      int passed = 0;
      for (int quarter = 0; quarter < 4; ++quarter) {
        const int qx = (quarter & 1) * 4, qy = (quarter >> 1) * 4;
        const double at[3] = {e[0] + s.right[0] * qx + s.down[0] * qy, e[1] + s.right[1] * qx + s.down[1] * qy,
                              e[2] + s.right[2] * qx + s.down[2] * qy};
        const double z_at = z + (walk.z_right * qx + walk.z_down * qy);
        passed += job.passing
                      ? DrawTestedQuarter(job, s, walk, at, z_at, bx * 8 + qx, by * 8 + qy, whole, tile, counts)
                      : DrawQuarter(job, s, walk, at, z_at, bx * 8 + qx, by * 8 + qy, whole, tile, counts);
      }
      if (passed) tile.written[block] = kStale | kTouched;
      n_passed += passed;
    }
  }
  return n_passed;
}

}  // namespace HWY_NAMESPACE
}  // namespace lode::raster::fast
HWY_AFTER_NAMESPACE();

#endif  // per-target include guard
