// Surfaces of samples that have an owner each (C7).
// Compiled once for each instruction set (Highway's re-included headers).

#include <algorithm>
#include <cmath>
#include <cstdint>

#include "raster/fast/kernels.h"

#if defined(LODE_RASTER_FAST_OWNERS_INL_H_) == defined(HWY_TARGET_TOGGLE)
#ifdef LODE_RASTER_FAST_OWNERS_INL_H_
#undef LODE_RASTER_FAST_OWNERS_INL_H_
#else
#define LODE_RASTER_FAST_OWNERS_INL_H_
#endif

#include "raster/fast/lanes-inl.h"
#include "raster/fast/surface-inl.h"

HWY_BEFORE_NAMESPACE();
namespace lode::raster::fast {
namespace HWY_NAMESPACE {

/// The triangles of some lanes' owners, their corners in canonical order.
struct OwnedTriangles {
  hn::Vec<HalfInts> x[3], y[3], local[3];
  hn::Vec<HalfInts> first_vertex, resident;
  hn::Vec<HalfInts> turned;  ///< all bits set where the order turned the triangle over
};
HWY_INLINE OwnedTriangles TrianglesOf(const OwnersJob& job, const std::uint32_t* owners) {
  const HalfInts i32;
  static_assert(sizeof(WindowVertices128) == 3072 && sizeof(Resident) == 16);
  const auto* residents = reinterpret_cast<const std::int32_t*>(job.residents);
  const auto* window = reinterpret_cast<const std::int32_t*>(job.vertices);
  OwnedTriangles t;
  const auto owner = hn::LoadU(i32, reinterpret_cast<const std::int32_t*>(owners));
  const auto triangle = hn::And(owner, hn::Set(i32, 127));
  t.resident = hn::ShiftRight<7>(owner);
  t.first_vertex = hn::GatherIndex(i32, residents, hn::ShiftLeft<2>(t.resident));
  const auto at = hn::Add(hn::GatherIndex(i32, residents + 1, hn::ShiftLeft<2>(t.resident)), triangle);
  const auto bytes =
      hn::GatherOffset(i32, reinterpret_cast<const std::int32_t*>(job.corners), hn::Add(at, hn::Add(at, at)));
  const auto low_byte = hn::Set(i32, 255);
  t.local[0] = hn::And(bytes, low_byte);
  t.local[1] = hn::And(hn::ShiftRight<8>(bytes), low_byte);
  t.local[2] = hn::And(hn::ShiftRight<16>(bytes), low_byte);
  const auto window_first = hn::Mul(t.resident, hn::Set(i32, 768));
  for (int k = 0; k < 3; ++k) {
    const auto at_vertex = hn::Add(window_first, hn::ShiftLeft<1>(t.local[k]));
    t.x[k] = hn::GatherIndex(i32, window, at_vertex);
    t.y[k] = hn::GatherIndex(i32, window + 1, at_vertex);
  }
  t.turned = hn::Zero(i32);
  const auto sort_pair = [&](int a, int b) HWY_ATTR {
    const auto swap = hn::Or(hn::Lt(t.x[b], t.x[a]), hn::And(hn::Eq(t.x[b], t.x[a]), hn::Lt(t.y[b], t.y[a])));
    for (hn::Vec<HalfInts>* v : {t.x, t.y, t.local}) {
      const hn::Vec<HalfInts> first = v[a], second = v[b];
      v[a] = hn::IfThenElse(swap, second, first);
      v[b] = hn::IfThenElse(swap, first, second);
    }
    t.turned = hn::Xor(t.turned, hn::VecFromMask(i32, swap));
  };
  sort_pair(0, 1);
  sort_pair(1, 2);
  sort_pair(0, 1);
  return t;
}

/// Weights of the corners at samples (C7), rounded once, and 1 where the triangle's front is seen.
struct OwnedWeights {
  hn::Vec<HalfFloats> b[3];
  hn::Vec<HalfInts> front;
};
HWY_INLINE OwnedWeights WeightsOf(const OwnersJob& job, const OwnedTriangles& t, std::size_t lane) {
  const Doubles d;
  const HalfInts i32;
  const HalfFloats f;
  const hn::RebindToSigned<Doubles> i64;
  const auto* window_w = reinterpret_cast<const double*>(job.vertices) + 256;
  D xd[3], yd[3], e[3], w[3];
  for (int k = 0; k < 3; ++k) {
    xd[k] = hn::PromoteTo(d, t.x[k]);
    yd[k] = hn::PromoteTo(d, t.y[k]);
    const auto index = hn::PromoteTo(i64, hn::Add(hn::Mul(t.resident, hn::Set(i32, 384)), t.local[k]));
    w[k] = hn::GatherIndex(d, window_w, index);
  }
  const auto px = hn::PromoteTo(d, hn::LoadU(i32, job.x_fx8 + lane));
  const auto py = hn::PromoteTo(d, hn::LoadU(i32, job.y_fx8 + lane));
  const auto area = hn::Sub(hn::Mul(hn::Sub(xd[1], xd[0]), hn::Sub(yd[2], yd[0])),
                            hn::Mul(hn::Sub(yd[1], yd[0]), hn::Sub(xd[2], xd[0])));
  const auto negative = hn::Lt(area, hn::Zero(d));
  for (int k = 0; k < 3; ++k) {  // exact: whole numbers below 2^53
    const int a = (k + 1) % 3, b = (k + 2) % 3;
    const auto value =
        hn::Sub(hn::Mul(hn::Sub(xd[b], xd[a]), hn::Sub(py, yd[a])), hn::Mul(hn::Sub(yd[b], yd[a]), hn::Sub(px, xd[a])));
    e[k] = hn::IfThenElse(negative, hn::Sub(hn::Zero(d), value), value);
  }
  const auto affine = hn::And(hn::Eq(hn::BitCast(i64, w[0]), hn::BitCast(i64, w[1])),
                              hn::Eq(hn::BitCast(i64, w[1]), hn::BitCast(i64, w[2])));
  D q[3];
  for (int k = 0; k < 3; ++k) q[k] = hn::IfThenElse(hn::RebindMask(d, affine), e[k], hn::Div(e[k], w[k]));
  const auto sum = hn::Add(hn::Add(q[0], q[1]), q[2]);
  OwnedWeights result;
  for (int k = 0; k < 3; ++k) result.b[k] = hn::DemoteTo(f, hn::Div(q[k], sum));
  const auto sign = hn::DemoteTo(i32, hn::IfThenElseZero(negative, hn::Set(d, -1.0)));  // all bits, or none
  result.front = hn::And(hn::Xor(sign, t.turned), hn::Set(i32, 1));                     // y down: negative is the front
  return result;
}

void ShadeOwners(const OwnersJob& job, const std::uint32_t* owners, SurfaceSamples& out) {
  const HalfInts i32;
  const Ints di;
  const Floats f;
  const auto* mesh_vertices = reinterpret_cast<const std::int32_t*>(job.mesh_vertices);
  for (std::size_t lane = 0; lane < 16; lane += hn::Lanes(f)) {
    OwnedWeights weights[2];
    hn::Vec<HalfInts> halves[2][3];
    for (std::size_t h = 0; h < 2; ++h) {
      const std::size_t first = lane + h * hn::Lanes(i32);
      const OwnedTriangles t = TrianglesOf(job, owners + first);
      weights[h] = WeightsOf(job, t, first);
      for (int k = 0; k < 3; ++k) {
        halves[h][k] = hn::GatherIndex(i32, mesh_vertices, hn::Add(t.first_vertex, t.local[k]));
      }
    }
    F b[3];
    I vertex[3];
    for (int k = 0; k < 3; ++k) {
      b[k] = BothHalves(f, weights[0].b[k], weights[1].b[k]);
      vertex[k] = BothHalves(di, halves[0][k], halves[1][k]);
    }
    const auto front = hn::RebindMask(f, hn::Ne(BothHalves(di, weights[0].front, weights[1].front), hn::Zero(di)));
    const auto attribute = [&](std::size_t c, std::size_t i) HWY_ATTR {
      if (c < 4) return hn::GatherIndex(f, job.colors + c, hn::ShiftLeft<2>(vertex[i]));
      return hn::GatherIndex(f, job.normals + (c - 4), hn::Add(vertex[i], hn::Add(vertex[i], vertex[i])));
    };
    StoreColors(*job.surface, b, front, attribute, lane, out);
  }
}

}  // namespace HWY_NAMESPACE
}  // namespace lode::raster::fast
HWY_AFTER_NAMESPACE();

#endif  // per-target include guard
