// Triangles of a cluster, one a lane: which of them are drawn, their samples' boxes and their depths' planes.
// Compiled once for each instruction set (Highway's re-included headers).

#include <algorithm>
#include <cstdint>

#include "techniques/masked_occlusion/occluder_kernels.h"

#if defined(LODE_TECHNIQUES_TRIANGLE_LANES_INL_H_) == defined(HWY_TARGET_TOGGLE)
#ifdef LODE_TECHNIQUES_TRIANGLE_LANES_INL_H_
#undef LODE_TECHNIQUES_TRIANGLE_LANES_INL_H_
#else
#define LODE_TECHNIQUES_TRIANGLE_LANES_INL_H_
#endif

#include "raster/fast/edges-inl.h"
#include "raster/fast/lanes-inl.h"

HWY_BEFORE_NAMESPACE();
namespace lode::techniques {
namespace HWY_NAMESPACE {

namespace hn = hwy::HWY_NAMESPACE;
namespace fast = raster::fast::HWY_NAMESPACE;
using fast::Doubles, fast::HalfInts, fast::I, fast::Ints;

// Where the samples of a subtile are.
alignas(64) constexpr std::int32_t kSampleX[32] = {0, 1, 2, 3, 4, 5, 6, 7, 0, 1, 2, 3, 4, 5, 6, 7,
                                                   0, 1, 2, 3, 4, 5, 6, 7, 0, 1, 2, 3, 4, 5, 6, 7};
alignas(64) constexpr std::int32_t kSampleY[32] = {0, 0, 0, 0, 0, 0, 0, 0, 1, 1, 1, 1, 1, 1, 1, 1,
                                                   2, 2, 2, 2, 2, 2, 2, 2, 3, 3, 3, 3, 3, 3, 3, 3};

/// Triangles to be walked, in their order, [n] and padding.
struct Triangles {
  static constexpr int kMost = raster::kMaxClusterTriangles + 16;
  alignas(64) std::int32_t x[3][kMost], y[3][kMost];
  alignas(64) std::int32_t triangle[kMost];
  int n = 0;
};
/// Those that are drawn by themselves, in their order.
struct Others {
  alignas(64) std::int32_t triangle[Triangles::kMost];
  int n = 0;
};

HWY_INLINE I Least(const I (&v)[3]) { return hn::Min(hn::Min(v[0], v[1]), v[2]); }
HWY_INLINE I Most(const I (&v)[3]) { return hn::Max(hn::Max(v[0], v[1]), v[2]); }

/// Samples that the triangles may cover, both ends included, in the buffer: as sample_box.
struct SampleBoxes {
  I first_x, first_y, last_x, last_y;
};
HWY_INLINE SampleBoxes SampleBoxesOf(const I (&x)[3], const I (&y)[3], glm::ivec2 end_px) {
  const Ints di;
  const auto up = hn::Set(di, 127), half = hn::Set(di, 128), zero = hn::Zero(di);
  return {hn::Max(hn::ShiftRight<8>(hn::Add(Least(x), up)), zero),
          hn::Max(hn::ShiftRight<8>(hn::Add(Least(y), up)), zero),
          hn::Min(hn::ShiftRight<8>(hn::Sub(Most(x), half)), hn::Set(di, end_px.x - 1)),
          hn::Min(hn::ShiftRight<8>(hn::Sub(Most(y), half)), hn::Set(di, end_px.y - 1))};
}

/// Exact where the corners are at most 2^14 apart, otherwise anything.
HWY_INLINE I DoubledAreas(const I (&x)[3], const I (&y)[3]) {
  return hn::Sub(hn::Mul(hn::Sub(x[1], x[0]), hn::Sub(y[2], y[0])), hn::Mul(hn::Sub(y[1], y[0]), hn::Sub(x[2], x[0])));
}

/// Sorts out triangles without a sample's place in their boxes, without area, or turned away.
HWY_INLINE void Sift(const ClusterJob& job, glm::ivec2 end_px, Triangles& list, Others& others) {
  const Ints di;
  alignas(64) std::uint64_t corners[3][Triangles::kMost];
  for (int t = 0; t < job.n_triangles; ++t) {
    for (int k = 0; k < 3; ++k) corners[k][t] = job.vertices->xy_fx8[job.corners[3 * t + k]];
  }
  const auto zero = hn::Zero(di);
  for (int first = 0; first < job.n_triangles; first += int(hn::Lanes(di))) {
    const auto triangle = hn::Add(hn::Set(di, first), hn::Iota(di, 0));
    I x[3], y[3];
    for (int k = 0; k < 3; ++k) {
      hn::LoadInterleaved2(di, reinterpret_cast<const std::int32_t*>(corners[k] + first), x[k], y[k]);
    }
    const SampleBoxes box = SampleBoxesOf(x, y, end_px);
    const auto beside = hn::Or(hn::Lt(box.last_x, box.first_x), hn::Lt(box.last_y, box.first_y));
    const auto alive = hn::AndNot(beside, hn::Lt(triangle, hn::Set(di, job.n_triangles)));
    const auto extent_x = hn::Sub(Most(x), Least(x)), extent_y = hn::Sub(Most(y), Least(y));
    const auto narrow = hn::And(alive, hn::Lt(hn::Max(extent_x, extent_y), hn::Set(di, 64 * 256)));
    const auto area = DoubledAreas(x, y);
    auto drawn = hn::And(narrow, hn::Ne(area, zero));
    auto doubtful = hn::AndNot(narrow, alive);
    if (job.cull != raster::Cull::none) {
      // Counter-clockwise as seen has a negative area with y down. A corner moves by half a sub-pixel when it snaps, a
      // difference of two by less than 1, so beyond the doubt the unsnapped determinant has the area's sign.
      const auto wanted = job.cull == raster::Cull::back ? hn::Neg(area) : area;
      const auto doubt = hn::Add(hn::ShiftLeft<1>(hn::Add(extent_x, extent_y)), hn::Set(di, 4));
      drawn = hn::And(drawn, hn::Gt(wanted, zero));
      doubtful = hn::Or(doubtful, hn::AndNot(hn::Gt(wanted, doubt), drawn));
      drawn = hn::And(drawn, hn::Gt(wanted, doubt));
    }
    if (!hn::AllFalse(di, drawn)) {
      for (int k = 0; k < 3; ++k) {
        hn::StoreU(hn::Compress(x[k], drawn), di, list.x[k] + list.n);
        hn::StoreU(hn::Compress(y[k], drawn), di, list.y[k] + list.n);
      }
      hn::StoreU(hn::Compress(triangle, drawn), di, list.triangle + list.n);
      list.n += int(hn::CountTrue(di, drawn));
    }
    if (!hn::AllFalse(di, doubtful)) {
      hn::StoreU(hn::Compress(triangle, doubtful), di, others.triangle + others.n);
      others.n += int(hn::CountTrue(di, doubtful));
    }
  }
}

/// Depths that the triangles' fragments do not fall below: DepthPlane of screen_triangle.cpp, which says why, with its
/// operations in its order.
struct Planes {
  alignas(64) double z0[16], a[16], b[16], farthest[16], lost[16], x0[16], y0[16];

  /// Of triangle i over the samples [first, last].
  [[nodiscard]] HWY_INLINE float farthest_in(int i, glm::ivec2 first, glm::ivec2 last) const {
    const double x = 256.0 * (a[i] > 0.0 ? first.x : last.x) + 128.0 - x0[i];
    const double y = 256.0 * (b[i] > 0.0 ? first.y : last.y) + 128.0 - y0[i];
    return float(std::max((z0[i] + (a[i] * x + b[i] * y)) - lost[i], farthest[i]));
  }
};

HWY_INLINE void PlanesOf(const I (&x)[3], const I (&y)[3], const double (&z)[3][16], I area, Planes& out) {
  const Ints di;
  const Doubles d;
  const HalfInts hi;
  alignas(64) std::int32_t x_of[3][16], y_of[3][16], areas[16];
  for (int k = 0; k < 3; ++k) hn::Store(x[k], di, x_of[k]), hn::Store(y[k], di, y_of[k]);
  hn::Store(area, di, areas);
  for (std::size_t half = 0; half < hn::Lanes(di); half += hn::Lanes(d)) {
    const auto at = [&](const std::int32_t* from) HWY_ATTR { return hn::PromoteTo(d, hn::LoadU(hi, from + half)); };
    const auto x0 = at(x_of[0]), y0 = at(y_of[0]), twice = at(areas);
    const auto ux = hn::Sub(at(x_of[1]), x0), uy = hn::Sub(at(y_of[1]), y0);
    const auto vx = hn::Sub(at(x_of[2]), x0), vy = hn::Sub(at(y_of[2]), y0);
    const auto z0 = hn::LoadU(d, z[0] + half), z1 = hn::LoadU(d, z[1] + half), z2 = hn::LoadU(d, z[2] + half);
    const auto du = hn::Sub(z1, z0), dv = hn::Sub(z2, z0);
    const auto size_x = hn::Add(hn::Max(hn::Abs(ux), hn::Abs(vx)), hn::Abs(hn::Sub(ux, vx)));
    const auto size_y = hn::Add(hn::Max(hn::Abs(uy), hn::Abs(vy)), hn::Abs(hn::Sub(uy, vy)));
    const auto farthest = hn::Min(hn::Min(z0, z1), z2), nearest = hn::Max(hn::Max(z0, z1), z2);
    const auto spread =
        hn::Mul(hn::Mul(hn::Set(d, 4.0), hn::Sub(nearest, farthest)), hn::Div(hn::Mul(size_x, size_y), hn::Abs(twice)));
    hn::StoreU(z0, d, out.z0 + half), hn::StoreU(x0, d, out.x0 + half), hn::StoreU(y0, d, out.y0 + half);
    hn::StoreU(hn::Div(hn::Sub(hn::Mul(du, vy), hn::Mul(dv, uy)), twice), d, out.a + half);
    hn::StoreU(hn::Div(hn::Sub(hn::Mul(dv, ux), hn::Mul(du, vx)), twice), d, out.b + half);
    hn::StoreU(farthest, d, out.farthest + half);
    hn::StoreU(hn::Mul(hn::Set(d, 0x1p-48), hn::Add(spread, nearest)), d, out.lost + half);
  }
}

}  // namespace HWY_NAMESPACE
}  // namespace lode::techniques
HWY_AFTER_NAMESPACE();

#endif  // per-target include guard
