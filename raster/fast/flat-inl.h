// Colours of vertices across triangles (C7), and colours to bytes (C8).
// Compiled once for each instruction set (Highway's re-included headers).

#include <algorithm>
#include <cmath>
#include <cstdint>

#include "raster/fast/kernels.h"

#if defined(LODE_RASTER_FAST_FLAT_INL_H_) == defined(HWY_TARGET_TOGGLE)
#ifdef LODE_RASTER_FAST_FLAT_INL_H_
#undef LODE_RASTER_FAST_FLAT_INL_H_
#else
#define LODE_RASTER_FAST_FLAT_INL_H_
#endif

#include "raster/fast/lanes-inl.h"

HWY_BEFORE_NAMESPACE();
namespace lode::raster::fast {
namespace HWY_NAMESPACE {

/// (b₀·a₀ + b₁·a₁) + b₂·a₂ inside the hull of the three (C7).
HWY_INLINE hn::Vec<HalfFloats> Interpolated(const hn::Vec<HalfFloats> (&b)[3], const hn::Vec<HalfFloats> (&a)[3]) {
  const auto least = [](auto x, auto y) HWY_ATTR { return hn::IfThenElse(hn::Lt(y, x), y, x); };  // std::min
  const auto most = [](auto x, auto y) HWY_ATTR { return hn::IfThenElse(hn::Lt(x, y), y, x); };   // std::max
  const auto value = hn::Add(hn::Add(hn::Mul(b[0], a[0]), hn::Mul(b[1], a[1])), hn::Mul(b[2], a[2]));
  const auto low = least(least(a[0], a[1]), a[2]), high = most(most(a[0], a[1]), a[2]);
  return hn::IfThenElse(hn::Lt(value, low), low, hn::IfThenElse(hn::Gt(value, high), high, value));
}

void ShadeFlat(const FlatJob& job, const std::uint32_t* owners, float* rgba) {
  const Doubles d;
  const HalfInts i32;
  const HalfFloats f;
  const hn::RebindToSigned<Doubles> i64;
  static_assert(sizeof(WindowVertices128) == 3072 && sizeof(Resident) == 16);
  const auto* residents = reinterpret_cast<const std::int32_t*>(job.residents);
  const auto* window = reinterpret_cast<const std::int32_t*>(job.vertices);
  const auto* window_w = reinterpret_cast<const double*>(job.vertices) + 256;
  for (std::size_t lane = 0; lane < 16; lane += hn::Lanes(d)) {
    const auto owner = hn::LoadU(i32, reinterpret_cast<const std::int32_t*>(owners) + lane);
    const auto resident = hn::ShiftRight<7>(owner), triangle = hn::And(owner, hn::Set(i32, 127));
    const auto first_vertex = hn::GatherIndex(i32, residents, hn::ShiftLeft<2>(resident));
    const auto first_triangle = hn::GatherIndex(i32, residents + 1, hn::ShiftLeft<2>(resident));
    const auto at = hn::Add(first_triangle, triangle);
    const auto bytes =
        hn::GatherOffset(i32, reinterpret_cast<const std::int32_t*>(job.corners), hn::Add(at, hn::Add(at, at)));
    const auto low_byte = hn::Set(i32, 255);
    hn::Vec<HalfInts> local[3] = {hn::And(bytes, low_byte), hn::And(hn::ShiftRight<8>(bytes), low_byte),
                                  hn::And(hn::ShiftRight<16>(bytes), low_byte)};
    const auto window_first = hn::Mul(resident, hn::Set(i32, 768));
    hn::Vec<HalfInts> x[3], y[3];
    for (int k = 0; k < 3; ++k) {
      const auto at_vertex = hn::Add(window_first, hn::ShiftLeft<1>(local[k]));
      x[k] = hn::GatherIndex(i32, window, at_vertex);
      y[k] = hn::GatherIndex(i32, window + 1, at_vertex);
    }
    const auto sort_pair = [&](int a, int b) HWY_ATTR {
      const auto swap = hn::Or(hn::Lt(x[b], x[a]), hn::And(hn::Eq(x[b], x[a]), hn::Lt(y[b], y[a])));
      for (hn::Vec<HalfInts>* v : {x, y, local}) {
        const hn::Vec<HalfInts> first = v[a], second = v[b];
        v[a] = hn::IfThenElse(swap, second, first);
        v[b] = hn::IfThenElse(swap, first, second);
      }
    };
    sort_pair(0, 1);
    sort_pair(1, 2);
    sort_pair(0, 1);
    hn::Vec<Doubles> xd[3], yd[3], e[3], w[3];
    for (int k = 0; k < 3; ++k) {
      xd[k] = hn::PromoteTo(d, x[k]);
      yd[k] = hn::PromoteTo(d, y[k]);
      const auto index = hn::PromoteTo(i64, hn::Add(hn::Mul(resident, hn::Set(i32, 384)), local[k]));
      w[k] = hn::GatherIndex(d, window_w, index);
    }
    const auto px = hn::PromoteTo(d, hn::LoadU(i32, job.x_fx8 + lane));
    const auto py = hn::PromoteTo(d, hn::LoadU(i32, job.y_fx8 + lane));
    const auto area = hn::Sub(hn::Mul(hn::Sub(xd[1], xd[0]), hn::Sub(yd[2], yd[0])),
                              hn::Mul(hn::Sub(yd[1], yd[0]), hn::Sub(xd[2], xd[0])));
    for (int k = 0; k < 3; ++k) {  // exact: whole numbers below 2^53
      const int a = (k + 1) % 3, b = (k + 2) % 3;
      const auto value = hn::Sub(hn::Mul(hn::Sub(xd[b], xd[a]), hn::Sub(py, yd[a])),
                                 hn::Mul(hn::Sub(yd[b], yd[a]), hn::Sub(px, xd[a])));
      e[k] = hn::IfThenElse(hn::Lt(area, hn::Zero(d)), hn::Sub(hn::Zero(d), value), value);
    }
    const auto affine = hn::And(hn::Eq(hn::BitCast(i64, w[0]), hn::BitCast(i64, w[1])),
                                hn::Eq(hn::BitCast(i64, w[1]), hn::BitCast(i64, w[2])));
    hn::Vec<Doubles> q[3];
    for (int k = 0; k < 3; ++k) q[k] = hn::IfThenElse(hn::RebindMask(d, affine), e[k], hn::Div(e[k], w[k]));
    const auto sum = hn::Add(hn::Add(q[0], q[1]), q[2]);
    hn::Vec<HalfFloats> b[3] = {hn::DemoteTo(f, hn::Div(q[0], sum)), hn::DemoteTo(f, hn::Div(q[1], sum)),
                                hn::DemoteTo(f, hn::Div(q[2], sum))};
    hn::Vec<HalfInts> vertex[3];
    for (int k = 0; k < 3; ++k) {
      vertex[k] = hn::ShiftLeft<2>(hn::GatherIndex(i32, reinterpret_cast<const std::int32_t*>(job.mesh_vertices),
                                                   hn::Add(first_vertex, local[k])));
    }
    for (int c = 0; c < 4; ++c) {
      const hn::Vec<HalfFloats> a[3] = {hn::GatherIndex(f, job.colors + c, vertex[0]),
                                        hn::GatherIndex(f, job.colors + c, vertex[1]),
                                        hn::GatherIndex(f, job.colors + c, vertex[2])};
      auto value = Interpolated(b, a);
      if (job.has_color) value = hn::Div(hn::Mul(hn::Set(f, job.color[std::size_t(c)]), value), hn::Set(f, job.full));
      hn::StoreU(value, f, rgba + 16 * c + lane);
    }
  }
}

void StoreBytes(const float* rgba, std::uint32_t* bytes) {
  const Floats f;
  const Ints di;
  for (std::size_t lane = 0; lane < 16; lane += hn::Lanes(f)) {
    auto packed = hn::Zero(di);
    for (int c = 3; c >= 0; --c) {
      const auto v = hn::LoadU(f, rgba + 16 * c + lane);
      const auto whole = hn::Trunc(v);
      auto byte = hn::ConvertTo(
          di, hn::IfThenElse(hn::Ge(hn::Sub(v, whole), hn::Set(f, 0.5f)), hn::Add(whole, hn::Set(f, 1.0f)), whole));
      byte = hn::IfThenElse(hn::RebindMask(di, hn::Ge(v, hn::Set(f, 255.0f))), hn::Set(di, 255), byte);
      byte = hn::IfThenElseZero(hn::RebindMask(di, hn::Gt(v, hn::Zero(f))), byte);
      packed = hn::Or(hn::ShiftLeft<8>(packed), byte);
    }
    hn::StoreU(packed, di, reinterpret_cast<std::int32_t*>(bytes) + lane);
  }
}

}  // namespace HWY_NAMESPACE
}  // namespace lode::raster::fast
HWY_AFTER_NAMESPACE();

#endif  // per-target include guard
