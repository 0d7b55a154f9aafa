// Vertices to the window: C1 in the reference's order of operations.
// Compiled once for each instruction set (Highway's re-included headers).

#include <algorithm>
#include <cmath>
#include <cstdint>

#include "raster/fast/kernels.h"

#if defined(LODE_RASTER_FAST_VERTICES_INL_H_) == defined(HWY_TARGET_TOGGLE)
#ifdef LODE_RASTER_FAST_VERTICES_INL_H_
#undef LODE_RASTER_FAST_VERTICES_INL_H_
#else
#define LODE_RASTER_FAST_VERTICES_INL_H_
#endif

#include "raster/fast/lanes-inl.h"

HWY_BEFORE_NAMESPACE();
namespace lode::raster::fast {
namespace HWY_NAMESPACE {

/// a / w · half, rounded to whole numbers as C1 and C2 say: with one division for all quotients of a w, unless the
/// rounding of these few operations could tell. The product with 1/w is within 2 ulp of the quotient, times half within
/// 4 ulp, and |·| is below 2^24 in the guard band: farther than 2^-24 from a tie, both round alike.
HWY_INLINE hn::Vec<Doubles> SnappedQuotient(hn::Vec<Doubles> a, hn::Vec<Doubles> w, hn::Vec<Doubles> inverse_w,
                                            hn::Vec<Doubles> half) {
  const Doubles d;
  const auto quick = hn::Mul(hn::Mul(a, inverse_w), half);
  const auto rounded = hn::Round(quick);
  const auto sure = hn::And(hn::Lt(hn::Abs(hn::Sub(quick, rounded)), hn::Set(d, 0.5 - 0x1p-24)),
                            hn::Lt(hn::Abs(quick), hn::Set(d, double(1 << 24))));
  if (HWY_LIKELY(hn::AllTrue(d, sure))) return rounded;
  return hn::Round(hn::Mul(hn::Div(a, w), half));
}

void Transform(const DrawView& v, const float* xs, const float* ys, const float* zs, int n, std::int32_t origin_x_fx8,
               std::int32_t origin_y_fx8, WindowVertices128* out) {
  const Doubles d;
  const HalfFloats f;
  const HalfInts di;
  const hn::Rebind<std::uint32_t, Doubles> du;
  const hn::Rebind<std::uint64_t, Doubles> d64;
  const auto* m = v.clip_from_object.data();
  // The part of the viewport's centre that is a whole number is added after rounding, as in the reference.
  const auto centre_x = hn::Set(d, v.centre_fx8.x), centre_y = hn::Set(d, v.centre_fx8.y);
  const auto guard = hn::Set(d, double(1 << 23)), minus_guard = hn::Set(d, -double(1 << 23));
  for (int i = 0; i < n; i += int(hn::Lanes(d))) {
    const auto x = hn::PromoteTo(d, hn::LoadU(f, xs + i));
    const auto y = hn::PromoteTo(d, hn::LoadU(f, ys + i));
    const auto z = hn::PromoteTo(d, hn::LoadU(f, zs + i));
    const auto row = [&](int r) HWY_ATTR {
      return hn::Add(hn::Add(hn::Add(hn::Mul(hn::Set(d, m[4 * r]), x), hn::Mul(hn::Set(d, m[4 * r + 1]), y)),
                             hn::Mul(hn::Set(d, m[4 * r + 2]), z)),
                     hn::Set(d, m[4 * r + 3]));
    };
    const auto cx = row(0), cy = row(1), cz = row(2), cw = row(3);
    const auto inverse_w = hn::Div(hn::Set(d, 1.0), cw);
    const auto sx = hn::Add(SnappedQuotient(cx, cw, inverse_w, hn::Set(d, v.half_fx8.x)), centre_x);
    const auto sy = hn::Add(SnappedQuotient(hn::Neg(cy), cw, inverse_w, hn::Set(d, v.half_fx8.y)), centre_y);
    const auto clamped_x = hn::Min(hn::Max(sx, minus_guard), guard);
    const auto clamped_y = hn::Min(hn::Max(sy, minus_guard), guard);
    const auto depth = hn::Min(hn::Max(hn::Div(cz, cw), hn::Zero(d)), hn::Set(d, 1.0));
    const auto ix = hn::Sub(hn::DemoteTo(di, clamped_x), hn::Set(di, origin_x_fx8));
    const auto iy = hn::Sub(hn::DemoteTo(di, clamped_y), hn::Set(di, origin_y_fx8));
    const auto low = hn::PromoteTo(d64, hn::BitCast(du, ix)), high = hn::PromoteTo(d64, hn::BitCast(du, iy));
    hn::StoreU(hn::Or(low, hn::ShiftLeft<32>(high)), d64, out->xy_fx8 + i);
    hn::StoreU(hn::Add(depth, hn::Zero(d)), d, out->z + i);
    hn::StoreU(cw, d, out->w + i);
  }
}

}  // namespace HWY_NAMESPACE
}  // namespace lode::raster::fast
HWY_AFTER_NAMESPACE();

#endif  // per-target include guard
