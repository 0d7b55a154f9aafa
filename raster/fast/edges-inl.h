// Edge functions and depth planes of sixteen triangles at once.
// Compiled once for each instruction set (Highway's re-included headers).

#include <cstdint>

#include "raster/fast/kernels.h"

#if defined(LODE_RASTER_FAST_EDGES_INL_H_) == defined(HWY_TARGET_TOGGLE)
#ifdef LODE_RASTER_FAST_EDGES_INL_H_
#undef LODE_RASTER_FAST_EDGES_INL_H_
#else
#define LODE_RASTER_FAST_EDGES_INL_H_
#endif

#include "raster/fast/lanes-inl.h"
#include "raster/fast/plane-inl.h"

HWY_BEFORE_NAMESPACE();
namespace lode::raster::fast {
namespace HWY_NAMESPACE {

/// Sixteen triangles' depth planes: z(dx, dy) = at + dx·x + dy·y, in pixels from the first sample.
struct DepthPlanes {
  alignas(64) double at[16], x[16], y[16], error[16];
};

/// Edge functions of the lanes' triangles, positive inside: at the first sample, and what a pixel to the right or down
/// adds. All fit 32 bits: corners are at most 64 px apart, and at most 68 px from the first sample.
struct LaneEdges {
  I at[3], right[3], down[3], bias[3];
};
HWY_INLINE LaneEdges EdgesOf(const I (&x)[3], const I (&y)[3], I area, I px, I py) {
  const Ints di;
  const auto negative = hn::Lt(area, hn::Zero(di));
  LaneEdges e;
  for (int k = 0; k < 3; ++k) {
    const int a = (k + 1) % 3, b = (k + 2) % 3;
    auto dx = hn::Sub(x[b], x[a]), dy = hn::Sub(y[b], y[a]);
    dx = hn::IfThenElse(negative, hn::Neg(dx), dx);
    dy = hn::IfThenElse(negative, hn::Neg(dy), dy);
    e.at[k] = hn::Sub(hn::Mul(dx, hn::Sub(py, y[a])), hn::Mul(dy, hn::Sub(px, x[a])));
    e.right[k] = hn::ShiftLeft<8>(hn::Neg(dy));
    e.down[k] = hn::ShiftLeft<8>(dx);
    const auto top_left = hn::Or(hn::Lt(dy, hn::Zero(di)), hn::And(hn::Eq(dy, hn::Zero(di)), hn::Gt(dx, hn::Zero(di))));
    e.bias[k] = hn::IfThenZeroElse(top_left, hn::Set(di, 1));
  }
  return e;
}

/// z [3][16]: depths at the corners; reach_x, reach_y: how many pixels from the first sample the planes will be asked.
HWY_INLINE void PlanesOf(const LaneEdges& e, I area, const double (&z)[3][16], int reach_x, int reach_y,
                         DepthPlanes& planes) {
  const Ints di;
  const Doubles d;
  const HalfInts hi;
  alignas(64) std::int32_t at[3][16], right[3][16], down[3][16], areas[16];
  for (int k = 0; k < 3; ++k) {
    hn::Store(e.at[k], di, at[k]), hn::Store(e.right[k], di, right[k]), hn::Store(e.down[k], di, down[k]);
  }
  hn::Store(hn::Abs(area), di, areas);
  for (std::size_t half = 0; half < hn::Lanes(di); half += hn::Lanes(d)) {
    const auto inverse = hn::Div(hn::Set(d, 1.0), hn::PromoteTo(d, hn::LoadU(hi, areas + half)));
    auto sum = hn::Zero(d), sum_x = hn::Zero(d), sum_y = hn::Zero(d), terms = hn::Zero(d);
    for (int k = 0; k < 3; ++k) {
      const auto zk = hn::LoadU(d, z[k] + half);
      const auto a = hn::PromoteTo(d, hn::LoadU(hi, at[k] + half)),
                 x = hn::PromoteTo(d, hn::LoadU(hi, right[k] + half)),
                 y = hn::PromoteTo(d, hn::LoadU(hi, down[k] + half));
      sum = hn::Add(sum, hn::Mul(a, zk));
      sum_x = hn::Add(sum_x, hn::Mul(x, zk));
      sum_y = hn::Add(sum_y, hn::Mul(y, zk));
      const auto most = hn::Add(
          hn::Abs(a), hn::Add(hn::Mul(hn::Abs(x), hn::Set(d, reach_x)), hn::Mul(hn::Abs(y), hn::Set(d, reach_y))));
      terms = hn::Add(terms, hn::Mul(most, zk));
    }
    hn::StoreU(hn::Mul(sum, inverse), d, planes.at + half);
    hn::StoreU(hn::Mul(sum_x, inverse), d, planes.x + half);
    hn::StoreU(hn::Mul(sum_y, inverse), d, planes.y + half);
    hn::StoreU(hn::Mul(hn::Mul(terms, inverse), hn::Set(d, kPlaneError)), d, planes.error + half);
  }
}

}  // namespace HWY_NAMESPACE
}  // namespace lode::raster::fast
HWY_AFTER_NAMESPACE();

#endif  // per-target include guard
