// Tiny triangles, one a lane: each lane walks the box of its own.
// Compiled once for each instruction set (Highway's re-included headers).

#include <algorithm>
#include <cstdint>
#include <cstring>

#include "raster/fast/kernels.h"

#if defined(LODE_RASTER_FAST_TINY_INL_H_) == defined(HWY_TARGET_TOGGLE)
#ifdef LODE_RASTER_FAST_TINY_INL_H_
#undef LODE_RASTER_FAST_TINY_INL_H_
#else
#define LODE_RASTER_FAST_TINY_INL_H_
#endif

#include "raster/fast/edges-inl.h"
#include "raster/fast/lanes-inl.h"
#include "raster/fast/plane-inl.h"
#include "raster/fast/sift-inl.h"

HWY_BEFORE_NAMESPACE();
namespace lode::raster::fast {
namespace HWY_NAMESPACE {

/// Samples that the lanes found, [n]: where, by whom, how near.
struct Fragments {
  static constexpr int kMost = 16 * kTinyWidth * kTowerHeight;
  alignas(64) std::int32_t step_and_lane[kMost + 16];
  alignas(64) std::int32_t place[kMost + 16];
  alignas(64) std::uint32_t owner[kMost + 16];
  alignas(64) float depth[kMost + 16];
  int n = 0;
};

/// Entries of a table of as many doubles as Ints has lanes.
HWY_INLINE hn::Vec<Doubles> FromTable(const double* table, hn::Vec<hn::RebindToSigned<Doubles>> index) {
  const Doubles d;
  const hn::RebindToSigned<Doubles> i64;
  const auto lanes = hn::Set(i64, std::int64_t(hn::Lanes(d)));
  const auto upper = hn::Gt(index, hn::Sub(lanes, hn::Set(i64, 1)));
  const auto within = hn::IndicesFromVec(d, hn::IfThenElse(upper, hn::Sub(index, lanes), index));
  return hn::IfThenElse(hn::RebindMask(d, upper), hn::TableLookupLanes(hn::LoadU(d, table + hn::Lanes(d)), within),
                        hn::TableLookupLanes(hn::LoadU(d, table), within));
}

/// Where a pixel of the tile is kept, as place_in_tile.
HWY_INLINE I PlacesOf(I x, I y) {
  const Ints di;
  const auto bits = [&](I v, int mask) HWY_ATTR { return hn::And(v, hn::Set(di, mask)); };
  const auto block = hn::Add(hn::ShiftLeft<4>(hn::ShiftRight<3>(y)), hn::ShiftRight<3>(x));
  const auto quarter = hn::Or(hn::ShiftLeft<3>(bits(y, 4)), hn::ShiftLeft<2>(bits(x, 4)));
  return hn::Or(hn::ShiftLeft<6>(block), hn::Or(quarter, hn::Or(hn::ShiftLeft<2>(bits(y, 3)), bits(x, 3))));
}

/// Keeps the nearest. Written without branches, as which one wins is hard to guess: depths are compared as the whole
/// numbers of their bits, whose order is the same from 0 on, with −1 below.
HWY_INLINE int Merge(const RasterJob& job, const Fragments& fragments, TileBuffers& tile, RasterCounts& counts) {
  std::uint32_t passed = 0, fresh = 0;
  for (int i = 0; i < fragments.n; ++i) {
    const std::int32_t place = fragments.place[i];
    std::uint32_t& owner = tile.owner[place];
    const std::uint32_t new_owner = fragments.owner[i];
    std::int32_t old_depth, depth;
    std::memcpy(&old_depth, &tile.depth[place], 4), std::memcpy(&depth, &fragments.depth[i], 4);
    auto wins = std::uint32_t(depth > old_depth);
    if (HWY_UNLIKELY(depth == old_depth)) wins = job.key_before(job.context, new_owner, owner) ? 1 : 0;
    const std::uint32_t kept = wins - 1;  // all bits, or none
    depth ^= (depth ^ old_depth) & std::int32_t(kept);
    std::memcpy(&tile.depth[place], &depth, 4);
    owner = new_owner ^ ((new_owner ^ owner) & kept);
    tile.written[place >> 6] = kStale | kTouched;
    job.marks[new_owner - job.first_owner] |= std::uint8_t(wins);
    passed += wins;
    fresh += std::uint32_t(old_depth) >> 31;
  }
  counts.fragments_kept += fresh;
  return int(passed);
}
static_assert(kWon == 1);

int RasterizeTiny(const RasterJob& job, const TriangleList& list, TileBuffers& tile, RasterCounts& counts) {
  const Ints di;
  const Doubles d;
  const HalfInts hi;
  const HalfFloats hf;
  const hn::RebindToSigned<Doubles> i64;
  constexpr int kReachX = kTinyWidth - 1, kReachY = kTowerHeight - 1;
  const int lanes = int(hn::Lanes(di));
  Fragments fragments;
  DepthPlanes planes;
  int passed = 0;
  for (int first = 0; first < list.n; first += lanes) {
    const int n = std::min(lanes, list.n - first);
    const auto exists = hn::Lt(hn::Iota(di, 0), hn::Set(di, n));
    I x[3], y[3];
    alignas(64) double z[3][16];
    LoadCorners(job, list, first, n, x, y, z);
    const PixelBoxes box = BoxesOf(job, x, y);
    const auto area = DoubledArea(x, y);
    const auto px = hn::Add(hn::ShiftLeft<8>(box.begin_x), hn::Set(di, job.sample_x_fx8));
    const auto py = hn::Add(hn::ShiftLeft<8>(box.begin_y), hn::Set(di, job.sample_y_fx8));
    LaneEdges e = EdgesOf(x, y, area, px, py);
    PlanesOf(e, area, z, kReachX, kReachY, planes);

    // The walk: which lane covers which step of its box.
    const auto w = hn::IfThenElseZero(exists, hn::Sub(box.end_x, box.begin_x)),
               h = hn::IfThenElseZero(exists, hn::Sub(box.end_y, box.begin_y));
    const int most_w = hn::GetLane(hn::MaxOfLanes(di, w)), most_h = hn::GetLane(hn::MaxOfLanes(di, h));
    for (int k = 0; k < 3; ++k) e.at[k] = hn::Sub(e.at[k], e.bias[k]);
    int found_n = 0;  // in a register
    for (int dy = 0; dy < most_h; ++dy) {
      const auto row = hn::Gt(h, hn::Set(di, dy));
      I at[3] = {e.at[0], e.at[1], e.at[2]};
      for (int dx = 0; dx < most_w; ++dx) {
        const auto inside = hn::And(hn::And(row, hn::Gt(w, hn::Set(di, dx))),
                                    hn::Gt(hn::Or(hn::Or(at[0], at[1]), at[2]), hn::Set(di, -1)));
        StoreTogether(hn::Add(hn::Iota(di, 0), hn::Set(di, (dy * kTinyWidth + dx) * 16)), inside,
                      fragments.step_and_lane + found_n);
        found_n += int(hn::CountTrue(di, inside));
        for (int k = 0; k < 3; ++k) at[k] = hn::Add(at[k], e.right[k]);
      }
      for (int k = 0; k < 3; ++k) e.at[k] = hn::Add(e.at[k], e.down[k]);
    }
    if (found_n == 0) continue;
    fragments.n = found_n;
    hn::StoreU(hn::Zero(di), di, fragments.step_and_lane + found_n);

    // Their places, owners and depths.
    const auto owners = hn::Add(hn::Set(di, std::int32_t(job.first_owner)), hn::LoadU(di, list.triangle + first));
    for (int f = 0; f < fragments.n; f += lanes) {
      const auto found = hn::LoadU(di, fragments.step_and_lane + f);
      const auto lane = hn::And(found, hn::Set(di, 15)), step = hn::ShiftRight<4>(found);
      const auto dx = hn::And(step, hn::Set(di, kTinyWidth - 1)), dy = hn::ShiftRight<2>(step);
      const auto of_lane = hn::IndicesFromVec(di, lane);
      const auto at_x = hn::Add(hn::TableLookupLanes(box.begin_x, of_lane), dx);
      const auto at_y = hn::Add(hn::TableLookupLanes(box.begin_y, of_lane), dy);
      hn::StoreU(PlacesOf(at_x, at_y), di, fragments.place + f);
      hn::StoreU(hn::TableLookupLanes(owners, of_lane), di, reinterpret_cast<std::int32_t*>(fragments.owner + f));
      for (int half = 0; half < lanes; half += int(hn::Lanes(d))) {
        const auto part = hn::LoadU(hi, fragments.step_and_lane + f + half);
        const auto index = hn::PromoteTo(i64, hn::And(part, hn::Set(hi, 15)));
        const auto part_step = hn::ShiftRight<4>(part);
        const auto x_px = hn::PromoteTo(d, hn::And(part_step, hn::Set(hi, kTinyWidth - 1)));
        const auto y_px = hn::PromoteTo(d, hn::ShiftRight<2>(part_step));
        const auto depth = hn::Add(hn::Add(FromTable(planes.at, index), hn::Mul(x_px, FromTable(planes.x, index))),
                                   hn::Mul(y_px, FromTable(planes.y, index)));
        const RoundedDepths rounded = RoundBoth(depth, FromTable(planes.error, index));
        hn::StoreU(rounded.low, hf, fragments.depth + f + half);
        const auto doubt = hn::Ne(rounded.low, rounded.high);
        if (HWY_LIKELY(hn::AllFalse(hf, doubt))) continue;
        alignas(64) float high[8];
        hn::StoreU(rounded.high, hf, high);
        for (int i = 0; i < std::min(int(hn::Lanes(d)), fragments.n - f - half); ++i) {
          if (high[i] == fragments.depth[f + half + i]) continue;
          const std::int32_t code = fragments.step_and_lane[f + half + i], l = code & 15;
          std::int32_t cx[3], cy[3];
          double cz[3];
          for (int k = 0; k < 3; ++k) cx[k] = list.x[k][first + l], cy[k] = list.y[k][first + l], cz[k] = z[k][l];
          alignas(64) std::int32_t begin_x[16], begin_y[16];
          hn::StoreU(px, di, begin_x), hn::StoreU(py, di, begin_y);
          fragments.depth[f + half + i] =
              ExactDepth(cx, cy, cz, begin_x[l] + (code >> 4 & (kTinyWidth - 1)) * 256, begin_y[l] + (code >> 6) * 256);
        }
      }
    }
    counts.fragments += std::uint64_t(fragments.n);
    passed += Merge(job, fragments, tile, counts);
  }
  return passed;
}

}  // namespace HWY_NAMESPACE
}  // namespace lode::raster::fast
HWY_AFTER_NAMESPACE();

#endif  // per-target include guard
