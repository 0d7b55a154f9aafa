// Boxes of space on the screen: what cannot be seen of a group of clusters is found before any vertex is read.
// Compiled once for each instruction set (Highway's re-included headers).

#include <algorithm>
#include <cmath>
#include <cstdint>

#include "raster/fast/kernels.h"

#if defined(LODE_RASTER_FAST_BOX_INL_H_) == defined(HWY_TARGET_TOGGLE)
#ifdef LODE_RASTER_FAST_BOX_INL_H_
#undef LODE_RASTER_FAST_BOX_INL_H_
#else
#define LODE_RASTER_FAST_BOX_INL_H_
#endif

#include "raster/fast/lanes-inl.h"

HWY_BEFORE_NAMESPACE();
namespace lode::raster::fast {
namespace HWY_NAMESPACE {

using D = hn::Vec<Doubles>;
using DoubleMask = hn::Mask<Doubles>;

/// As many boxes as there are lanes, in double.
struct Boxes {
  D low[3], high[3];
};

/// A row of the matrix over the boxes: least and greatest value would do for the planes, but x and y are divided by w
/// at each corner, so all eight are kept. `magnitude` bounds the absolute values of everything added up.
struct CornerValues {
  D at[8];
  D magnitude;
};
HWY_INLINE CornerValues ValuesAtCorners(const double* row, const Boxes& b) {
  const Doubles d;
  CornerValues v;
  D part[3][2];
  v.magnitude = hn::Set(d, std::fabs(row[3]));
  for (int axis = 0; axis < 3; ++axis) {
    const auto m = hn::Set(d, row[axis]);
    part[axis][0] = hn::Mul(m, b.low[axis]);
    part[axis][1] = hn::Mul(m, b.high[axis]);
    v.magnitude = hn::Add(v.magnitude, hn::Max(hn::Abs(part[axis][0]), hn::Abs(part[axis][1])));
  }
  for (std::size_t i = 0; i < 8; ++i) {
    v.at[i] = hn::Add(hn::Add(hn::Add(part[0][i & 1], part[1][i >> 1 & 1]), part[2][i >> 2]), hn::Set(d, row[3]));
  }
  return v;
}

HWY_INLINE D LeastOf(const D (&v)[8]) {
  return hn::Min(hn::Min(hn::Min(v[0], v[1]), hn::Min(v[2], v[3])), hn::Min(hn::Min(v[4], v[5]), hn::Min(v[6], v[7])));
}
HWY_INLINE D MostOf(const D (&v)[8]) {
  return hn::Max(hn::Max(hn::Max(v[0], v[1]), hn::Max(v[2], v[3])), hn::Max(hn::Max(v[4], v[5]), hn::Max(v[6], v[7])));
}

/// Boxes all of whose triangles have a determinant that the reference finds to be on the culled side: every normal of
/// the cone points away from (back) or to (front) the eye by more than the determinant's own rounding can undo.
HWY_INLINE DoubleMask FacingAway(const DrawView& v, const ClusterGroup& g, std::size_t first, const Boxes& b,
                                 D magnitudes) {
  const Doubles d;
  const HalfFloats f;
  const auto flip = hn::Set(d, v.cull == Cull::back ? 1.0 : -1.0);
  const double eye[3] = {v.eye.x, v.eye.y, v.eye.z};
  const auto half = hn::Set(d, 0.5), eye_w = hn::Set(d, v.eye_w);
  auto along = hn::Zero(d), squared = hn::Zero(d), radius_squared = hn::Zero(d);
  for (int axis = 0; axis < 3; ++axis) {
    const auto centre = hn::Mul(half, hn::Add(b.low[axis], b.high[axis]));
    const auto extent = hn::Mul(half, hn::Sub(b.high[axis], b.low[axis]));
    const auto to_eye = hn::Mul(flip, hn::Sub(hn::Set(d, eye[axis]), hn::Mul(eye_w, centre)));
    along = hn::Add(along, hn::Mul(to_eye, hn::PromoteTo(d, hn::LoadU(f, g.cone_axis[axis] + first))));
    squared = hn::Add(squared, hn::Mul(to_eye, to_eye));
    radius_squared = hn::Add(radius_squared, hn::Mul(extent, extent));
  }
  const auto cosine = hn::PromoteTo(d, hn::LoadU(f, g.cone_cos + first));
  const auto sine = hn::Sqrt(hn::Max(hn::Zero(d), hn::Sub(hn::Set(d, 1.0), hn::Mul(cosine, cosine))));
  const auto across = hn::Sqrt(hn::Max(hn::Zero(d), hn::Sub(squared, hn::Mul(along, along))));
  const auto radius = hn::Mul(hn::Abs(eye_w), hn::Sqrt(radius_squared));
  // The greatest n · (eye − eye_w·p) over unit normals n of the cone and points p of the box, and some for rounding.
  const auto most = hn::Add(hn::Add(hn::Mul(cosine, along), hn::Mul(sine, across)), radius);
  const auto slack = hn::Mul(hn::Set(d, 1e-5), hn::Add(hn::Sqrt(squared), radius));
  const auto least_normal = hn::PromoteTo(d, hn::LoadU(f, g.least_normal + first));
  const auto determinant = hn::Mul(least_normal, hn::Sub(hn::Zero(d), hn::Add(most, slack)));
  const auto precise = hn::And(hn::Gt(cosine, hn::Zero(d)), hn::Gt(squared, hn::Set(d, 0x1p-960)));
  return hn::And(precise, hn::Gt(determinant, hn::Mul(hn::Set(d, 0x1p-46), magnitudes)));
}

void LookAtSome(const DrawView& v, const ClusterGroup& g, const reference::PixelBox& window, const Skips& skips,
                std::size_t first, BoxSight* out) {
  const Doubles d;
  const HalfFloats f;
  Boxes b;
  for (int axis = 0; axis < 3; ++axis) {
    b.low[axis] = hn::PromoteTo(d, hn::LoadU(f, g.low[axis] + first));
    b.high[axis] = hn::PromoteTo(d, hn::LoadU(f, g.high[axis] + first));
  }
  const auto* m = v.clip_from_object.data();
  const CornerValues x = ValuesAtCorners(m, b), y = ValuesAtCorners(m + 4, b), z = ValuesAtCorners(m + 8, b),
                     w = ValuesAtCorners(m + 12, b);
  // Distances to the planes are sums of these; 2^-46 of the magnitudes is more than all their roundings.
  constexpr double kGuard = 1 << 23;
  const auto ulps = hn::Set(d, 0x1p-46), zero = hn::Zero(d), guard = hn::Set(d, kGuard);
  const auto half_x = hn::Set(d, v.half_fx8.x), half_y = hn::Set(d, v.half_fx8.y);
  const auto centre_x = hn::Set(d, v.centre_fx8.x), centre_y = hn::Set(d, v.centre_fx8.y);
  const auto slack_w = hn::Mul(ulps, w.magnitude), slack_z = hn::Mul(ulps, hn::Add(w.magnitude, z.magnitude));
  const auto slack_of = [&](D half, D centre, D magnitude) HWY_ATTR {
    return hn::Mul(ulps, hn::Add(hn::Mul(half, magnitude), hn::Mul(hn::Add(hn::Abs(centre), guard), w.magnitude)));
  };
  const auto slack_x = slack_of(half_x, centre_x, x.magnitude), slack_y = slack_of(half_y, centre_y, y.magnitude);

  D near[8], wx[8], wy[8], guarded[8];
  for (std::size_t i = 0; i < 8; ++i) {
    near[i] = hn::Sub(w.at[i], z.at[i]);
    wx[i] = hn::Add(hn::Mul(half_x, x.at[i]), hn::Mul(centre_x, w.at[i]));
    wy[i] = hn::Sub(hn::Mul(centre_y, w.at[i]), hn::Mul(half_y, y.at[i]));
    guarded[i] = hn::Mul(guard, w.at[i]);
  }
  const auto minus_w = hn::Neg(slack_w), minus_z = hn::Neg(slack_z);
  auto outside =
      hn::Or(hn::Or(hn::Lt(MostOf(near), minus_z), hn::Lt(MostOf(w.at), minus_w)), hn::Lt(MostOf(z.at), minus_z));
  const auto least_w = LeastOf(w.at);
  auto clean = hn::And(hn::And(hn::Gt(LeastOf(near), slack_z), hn::Gt(least_w, slack_w)),
                       hn::And(hn::Gt(least_w, hn::Set(d, 0x1p-140)), hn::Ge(LeastOf(z.at), slack_z)));
  clean = hn::And(clean, hn::Lt(w.magnitude, hn::Set(d, 0x1p120)));
  const auto within_guard = [&](const D(&a)[8], D slack) HWY_ATTR {
    D above[8], below[8];
    for (std::size_t i = 0; i < 8; ++i) above[i] = hn::Add(a[i], guarded[i]), below[i] = hn::Sub(guarded[i], a[i]);
    return hn::And(hn::Gt(LeastOf(above), slack), hn::Gt(LeastOf(below), slack));
  };
  clean = hn::And(clean, hn::And(within_guard(wx, slack_x), within_guard(wy, slack_y)));

  // Where they are in the window. Not clean: anywhere. A sub-pixel for the snap, another for rounding; a pixel is
  // covered if its sample (anywhere in it) is.
  D sx[8], sy[8], depth[8];
  for (std::size_t i = 0; i < 8; ++i) {
    const auto inverse = hn::Div(hn::Set(d, 1.0), w.at[i]);
    sx[i] = hn::Mul(wx[i], inverse), sy[i] = hn::Mul(wy[i], inverse), depth[i] = hn::Mul(z.at[i], inverse);
  }
  const auto two = hn::Set(d, 2.0), per_px = hn::Set(d, 1.0 / 256.0), one = hn::Set(d, 1.0);
  const auto begin = [&](D least, int limit) HWY_ATTR {
    return hn::Max(hn::Floor(hn::Mul(hn::Sub(least, two), per_px)), hn::Set(d, limit));
  };
  const auto end = [&](D most, int limit) HWY_ATTR {
    return hn::Min(hn::Add(hn::Floor(hn::Mul(hn::Add(most, two), per_px)), one), hn::Set(d, limit));
  };
  const auto begin_x = begin(LeastOf(sx), window.begin_px.x), end_x = end(MostOf(sx), window.end_px.x);
  const auto begin_y = begin(LeastOf(sy), window.begin_px.y), end_y = end(MostOf(sy), window.end_px.y);
  outside = hn::Or(outside, hn::And(clean, hn::Or(hn::Ge(begin_x, end_x), hn::Ge(begin_y, end_y))));
  const auto nearest = hn::Min(one, hn::Mul(MostOf(depth), hn::Set(d, 1.0 + 0x1p-20)));

  auto facing = hn::Lt(zero, zero);
  if (v.cull != Cull::none && v.boxes_may_face && skips.facing) {
    facing = FacingAway(v, g, first, b, hn::Mul(hn::Mul(x.magnitude, y.magnitude), w.magnitude));
  }
  if (!skips.frustum) outside = hn::Lt(zero, zero);

  alignas(64) double values[4][8], nearests[8];
  alignas(64) double cleans[8], outsides[8], facings[8];
  const auto store_flag = [&](DoubleMask mask, double* to)
                              HWY_ATTR { hn::Store(hn::IfThenElseZero(mask, one), d, to); };
  store_flag(clean, cleans), store_flag(outside, outsides), store_flag(facing, facings);
  hn::Store(begin_x, d, values[0]), hn::Store(begin_y, d, values[1]);
  hn::Store(end_x, d, values[2]), hn::Store(end_y, d, values[3]);
  hn::Store(nearest, d, nearests);
  for (std::size_t i = 0; i < hn::Lanes(d); ++i) {
    BoxSight& s = out[first + i];
    s.sight = outsides[i] != 0.0  ? Sight::outside
              : facings[i] != 0.0 ? Sight::facing
              : cleans[i] != 0.0  ? Sight::clean
                                  : Sight::unclean;
    if (s.sight != Sight::clean) continue;
    s.nearest = float(nearests[i]);
    s.pixels = {window.begin_px, {window.begin_px.x + 1, window.begin_px.y + 1}};
    if (values[0][i] >= values[2][i] || values[1][i] >= values[3][i]) continue;  // looked at all the same
    s.pixels = {{int(values[0][i]), int(values[1][i])}, {int(values[2][i]), int(values[3][i])}};
  }
}

void Look(const DrawView& view, const ClusterGroup& group, const reference::PixelBox& window, const Skips& skips,
          BoxSight* out) {
  for (std::size_t first = 0; int(first) < group.n; first += hn::Lanes(Doubles())) {
    LookAtSome(view, group, window, skips, first, out);
  }
}

}  // namespace HWY_NAMESPACE
}  // namespace lode::raster::fast
HWY_AFTER_NAMESPACE();

#endif  // per-target include guard
