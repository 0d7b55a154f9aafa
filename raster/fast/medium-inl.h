// Triangles up to 64 px: set up sixteen at a time, then walked one by one in 4×4 blocks, a sample a lane.
// Compiled once for each instruction set (Highway's re-included headers).

#include <algorithm>
#include <cstdint>
#include <limits>

#include "raster/fast/kernels.h"

#if defined(LODE_RASTER_FAST_MEDIUM_INL_H_) == defined(HWY_TARGET_TOGGLE)
#ifdef LODE_RASTER_FAST_MEDIUM_INL_H_
#undef LODE_RASTER_FAST_MEDIUM_INL_H_
#else
#define LODE_RASTER_FAST_MEDIUM_INL_H_
#endif

#include "raster/fast/edges-inl.h"
#include "raster/fast/lanes-inl.h"
#include "raster/fast/plane-inl.h"
#include "raster/fast/sift-inl.h"

HWY_BEFORE_NAMESPACE();
namespace lode::raster::fast {
namespace HWY_NAMESPACE {

/// A 4×4's old depths and owners against a triangle's new ones: writes the nearer; returns how many.
template <class Mask>
HWY_INLINE int KeepNearer(const RasterJob& job, TileBuffers& tile, int place, Mask covered, hn::Vec<Floats> z,
                          std::uint32_t owner) {
  const Floats f;
  const hn::RebindToUnsigned<Floats> u;
  const auto old = hn::Load(f, tile.depth + place);
  auto wins = hn::And(covered, hn::Gt(z, old));
  const auto equal = hn::And(covered, hn::Eq(z, old));
  if (HWY_UNLIKELY(!hn::AllFalse(f, equal))) {
    alignas(64) std::uint32_t flags[16];
    hn::Store(hn::VecFromMask(u, hn::RebindMask(u, equal)), u, flags);
    for (std::size_t i = 0; i < hn::Lanes(f); ++i) {
      flags[i] = flags[i] && job.key_before(job.context, owner, tile.owner[std::size_t(place) + i]) ? ~0u : 0u;
    }
    wins = hn::Or(wins, hn::RebindMask(f, hn::MaskFromVec(hn::BitCast(f, hn::Load(u, flags)))));
  }
  const auto n = hn::CountTrue(f, wins);
  if (n == 0) return 0;
  hn::Store(hn::IfThenElse(wins, z, old), f, tile.depth + place);
  hn::Store(hn::IfThenElse(hn::RebindMask(u, wins), hn::Set(u, owner), hn::Load(u, tile.owner + place)), u,
            tile.owner + place);
  return int(n);
}

/// Sixteen set-ups side by side, [16] each: from the first sample of the 4×4 block that holds the box's first pixel.
struct MediumSetups {
  alignas(64) std::int32_t at[3][16], right[3][16], down[3][16];
  alignas(64) std::int32_t begin_x[16], begin_y[16], end_x[16], end_y[16];  ///< pixels
  DepthPlanes planes;
};

/// One of them as the walk needs it.
struct MediumTriangle {
  std::int32_t cx[3], cy[3];
  double cz[3];
  std::uint32_t owner;
  int begin_x, begin_y, end_x, end_y;
};

/// Depths of the samples of some lanes by the exact way.
HWY_NOINLINE void FixDepths(const RasterJob& job, const MediumTriangle& t, int x_px, int y_px, std::size_t first_lane,
                            std::uint32_t doubtful, float* depths) {
  for (std::size_t i = 0; doubtful >> i != 0; ++i) {
    if ((doubtful >> i & 1) == 0) continue;
    const std::size_t lane = first_lane + i;
    depths[i] = ExactDepth(t.cx, t.cy, t.cz, x_px * 256 + kLaneX_fx8[lane] + job.sample_x_fx8,
                           y_px * 256 + kLaneY_fx8[lane] + job.sample_y_fx8);
  }
}

/// What the blocks of a triangle have in common: offsets of a 4×4's lanes from its first sample.
struct MediumLanes {
  alignas(64) std::int32_t edge[3][16];
  alignas(64) double depth[16];
  hn::Vec<Doubles> error;
  hn::Vec<Floats> z_most;  ///< of the whole triangle; what is nearer need not be looked at
  bool ragged;
};

/// One 4×4 block, from its first pixel; edges and depth at its first sample.
HWY_INLINE int DrawMediumBlock(const RasterJob& job, const MediumTriangle& t, const MediumLanes& lanes, int x_px,
                               int y_px, const std::int32_t (&edges)[3], double z, TileBuffers& tile,
                               RasterCounts& counts) {
  const Ints di;
  const Floats f;
  const Doubles d;
  const int place = place_in_tile(x_px, y_px);
  const auto z_block = hn::Set(d, z);
  int passed = 0;
  for (std::size_t l = 0; l < 16; l += hn::Lanes(di)) {
    // Nothing to do where what is there is nearer than the whole triangle.
    const auto hidden = hn::Gt(hn::Load(f, tile.depth + place + l), lanes.z_most);
    if (hn::AllTrue(f, hidden)) continue;
    const auto signs = hn::Or(hn::Or(hn::Add(hn::Set(di, edges[0]), hn::Load(di, lanes.edge[0] + l)),
                                     hn::Add(hn::Set(di, edges[1]), hn::Load(di, lanes.edge[1] + l))),
                              hn::Add(hn::Set(di, edges[2]), hn::Load(di, lanes.edge[2] + l)));
    auto inside = hn::Gt(signs, hn::Set(di, -1));
    if (lanes.ragged) {
      const auto lx = hn::Load(di, kLaneX + l), ly = hn::Load(di, kLaneY + l);
      inside = hn::And(inside,
                       hn::And(hn::Gt(lx, hn::Set(di, t.begin_x - x_px - 1)), hn::Lt(lx, hn::Set(di, t.end_x - x_px))));
      inside = hn::And(inside,
                       hn::And(hn::Gt(ly, hn::Set(di, t.begin_y - y_px - 1)), hn::Lt(ly, hn::Set(di, t.end_y - y_px))));
    }
    if (hn::AllFalse(di, inside)) continue;
    // Sample by sample, so that the count is the same however many are looked at together.
    counts.fragments += hn::CountTrue(f, hn::AndNot(hidden, hn::RebindMask(f, inside)));
    const RoundedDepths first = RoundBoth(hn::Add(z_block, hn::Load(d, lanes.depth + l)), lanes.error);
    const RoundedDepths second = RoundBoth(hn::Add(z_block, hn::Load(d, lanes.depth + l + hn::Lanes(d))), lanes.error);
    auto depth = BothHalves(f, first.low, second.low);
    const auto covered = hn::RebindMask(f, inside);
    const auto doubt = hn::And(covered, hn::Ne(depth, BothHalves(f, first.high, second.high)));
    if (HWY_UNLIKELY(!hn::AllFalse(f, doubt))) {
      alignas(64) float depths[16];
      hn::Store(depth, f, depths);
      FixDepths(job, t, x_px, y_px, l, BitsOf(f, doubt), depths);
      depth = hn::Load(f, depths);
    }
    passed += KeepNearer(job, tile, place + int(l), covered, depth, t.owner);
  }
  if (passed) tile.written[place >> 6] = kStale | kTouched;
  return passed;
}

/// Sixteen blocks at a time, four by four: first which of them the triangle can touch, then those.
int WalkBlocks(const RasterJob& job, const MediumSetups& setups, int lane_of_setup, const MediumTriangle& t,
               TileBuffers& tile, RasterCounts& counts) {
  constexpr int kWindow = 4;  // blocks
  const Ints di;
  const Doubles d;
  const int s = lane_of_setup;
  const int bx0 = t.begin_x >> 2, by0 = t.begin_y >> 2;
  const int columns = ((t.end_x - 1) >> 2) - bx0 + 1, rows = ((t.end_y - 1) >> 2) - by0 + 1;
  MediumLanes lanes;
  lanes.ragged = ((job.begin_x | job.begin_y | job.end_x | job.end_y) & 3) != 0;
  lanes.error = hn::Set(d, setups.planes.error[s]);
  const double z_most = std::max({t.cz[0], t.cz[1], t.cz[2]});
  lanes.z_most = hn::Set(Floats(), job.skips.blocks ? float(z_most) : std::numeric_limits<float>::infinity());
  std::int32_t most[3];  // what the best sample of a block adds to its first
  for (int k = 0; k < 3; ++k) {
    const std::int32_t x = setups.right[k][s], y = setups.down[k][s];
    most[k] = 3 * (std::max(x, 0) + std::max(y, 0));
    for (std::size_t l = 0; l < 16; l += hn::Lanes(di)) {
      hn::Store(
          hn::Add(hn::Mul(hn::Set(di, x), hn::Load(di, kLaneX + l)), hn::Mul(hn::Set(di, y), hn::Load(di, kLaneY + l))),
          di, lanes.edge[k] + l);
    }
  }
  const double z_x = setups.planes.x[s], z_y = setups.planes.y[s];
  StoreLanes(z_x, z_y, lanes.depth);
  int n_passed = 0;
  for (int wy = 0; wy < rows; wy += kWindow) {
    for (int wx = 0; wx < columns; wx += kWindow) {
      // A window's blocks lie to each other as a block's samples do, four times as far.
      alignas(64) std::int32_t edges[3][16];
      alignas(64) double depths[16];
      std::uint32_t touched = 0;
      for (std::size_t l = 0; l < 16; l += hn::Lanes(di)) {
        auto signs = hn::Zero(di);
        for (int k = 0; k < 3; ++k) {
          const std::int32_t at = setups.at[k][s] + 4 * (wx * setups.right[k][s] + wy * setups.down[k][s]);
          const auto edge = hn::Add(hn::Set(di, at), hn::ShiftLeft<2>(hn::Load(di, lanes.edge[k] + l)));
          hn::Store(edge, di, edges[k] + l);
          signs = hn::Or(signs, hn::Add(edge, hn::Set(di, most[k])));
        }
        touched |= BitsOf(di, hn::Gt(signs, hn::Set(di, -1))) << l;
      }
      const auto z_window = hn::Set(d, setups.planes.at[s] + (z_x * (4.0 * wx) + z_y * (4.0 * wy)));
      for (std::size_t l = 0; l < 16; l += hn::Lanes(d)) {
        hn::Store(hn::Add(z_window, hn::Mul(hn::Set(d, 4.0), hn::Load(d, lanes.depth + l))), d, depths + l);
      }
      const std::uint32_t of_row = (1u << std::min(kWindow, columns - wx)) - 1;
      const std::uint32_t there = of_row * 0x1111u & ((1u << 4 * std::min(kWindow, rows - wy)) - 1);
      if (!job.skips.blocks) touched = there;
      touched &= there;
      counts.blocks += hwy::PopCount(touched);
      counts.blocks_outside += hwy::PopCount(there & ~touched);
      for (; touched != 0; touched &= touched - 1) {
        const auto i = int(hwy::Num0BitsBelowLS1Bit_Nonzero32(touched));
        n_passed += DrawMediumBlock(job, t, lanes, 4 * (bx0 + wx + (i & 3)), 4 * (by0 + wy + (i >> 2)),
                                    {edges[0][i], edges[1][i], edges[2][i]}, depths[i], tile, counts);
      }
    }
  }
  return n_passed;
}

int RasterizeMedium(const RasterJob& job, const TriangleList& list, TileBuffers& tile, RasterCounts& counts) {
  const Ints di;
  constexpr int kReach = 68;
  MediumSetups setups;
  int passed = 0;
  for (int first = 0; first < list.n; first += int(hn::Lanes(di))) {
    const int n = std::min(int(hn::Lanes(di)), list.n - first);
    I x[3], y[3];
    alignas(64) double z[3][16];
    LoadCorners(job, list, first, n, x, y, z);
    const PixelBoxes box = BoxesOf(job, x, y);
    const auto area = DoubledArea(x, y);
    const auto px = hn::Add(hn::ShiftLeft<10>(hn::ShiftRight<2>(box.begin_x)), hn::Set(di, job.sample_x_fx8));
    const auto py = hn::Add(hn::ShiftLeft<10>(hn::ShiftRight<2>(box.begin_y)), hn::Set(di, job.sample_y_fx8));
    const LaneEdges e = EdgesOf(x, y, area, px, py);
    PlanesOf(e, area, z, kReach, kReach, setups.planes);
    for (int k = 0; k < 3; ++k) {
      hn::Store(hn::Sub(e.at[k], e.bias[k]), di, setups.at[k]);
      hn::Store(e.right[k], di, setups.right[k]);
      hn::Store(e.down[k], di, setups.down[k]);
    }
    hn::Store(box.begin_x, di, setups.begin_x), hn::Store(box.begin_y, di, setups.begin_y);
    hn::Store(box.end_x, di, setups.end_x), hn::Store(box.end_y, di, setups.end_y);
    for (int i = 0; i < n; ++i) {
      MediumTriangle t;
      t.owner = job.first_owner + std::uint32_t(list.triangle[first + i]);
      for (int k = 0; k < 3; ++k) t.cx[k] = list.x[k][first + i], t.cy[k] = list.y[k][first + i], t.cz[k] = z[k][i];
      t.begin_x = setups.begin_x[i], t.begin_y = setups.begin_y[i], t.end_x = setups.end_x[i],
      t.end_y = setups.end_y[i];
      if (t.begin_x >= t.end_x || t.begin_y >= t.end_y) continue;
      const int won = WalkBlocks(job, setups, i, t, tile, counts);
      if (won > 0) job.marks[list.triangle[first + i]] = kWon;
      passed += won;
    }
  }
  return passed;
}

}  // namespace HWY_NAMESPACE
}  // namespace lode::raster::fast
HWY_AFTER_NAMESPACE();

#endif  // per-target include guard
