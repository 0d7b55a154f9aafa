// Textured triangles: coordinates, levels of detail and colours of a 4×4's samples (C7, C10).
// Compiled once for each instruction set (Highway's re-included headers).

#include <algorithm>
#include <array>
#include <bit>
#include <cstdint>
#include <cstring>

#include "raster/fast/kernels.h"

#if defined(LODE_RASTER_FAST_TEXTURE_INL_H_) == defined(HWY_TARGET_TOGGLE)
#ifdef LODE_RASTER_FAST_TEXTURE_INL_H_
#undef LODE_RASTER_FAST_TEXTURE_INL_H_
#else
#define LODE_RASTER_FAST_TEXTURE_INL_H_
#endif

#include "raster/fast/lambda-inl.h"
#include "raster/fast/surface-inl.h"
#include "raster/fast/texels-inl.h"

HWY_BEFORE_NAMESPACE();
namespace lode::raster::fast {
namespace HWY_NAMESPACE {

/// One bit for each lane of Ints that is not 0.
HWY_INLINE std::uint32_t BitsOf(I lanes) { return BitsOf(Ints(), hn::Ne(lanes, hn::Zero(Ints()))); }

/// One bit of `lanes` for each lane of Ints.
HWY_INLINE hn::Mask<Ints> LanesOf(std::uint32_t lanes) {
  const Ints di;
  const auto bit = hn::Shl(hn::Set(di, 1), hn::Iota(di, 0));
  return hn::Ne(hn::And(hn::Set(di, std::int32_t(lanes)), bit), hn::Zero(di));
}

/// Coordinates of as many samples as Ints has lanes, from lane `first` of a 4×4 on.
struct Coordinates {
  TwoHalves u, v;
  hn::Vec<Floats> inverse_sum;  ///< if the levels vary
};
HWY_INLINE Coordinates CoordinatesAt(const TexturedTriangle& t, double x_px, double y_px, std::size_t first) {
  const Doubles d;
  const hn::Rebind<float, Doubles> half;
  const auto plane = [&](const Plane& p, const std::array<double, 16>& lane) HWY_ATTR {
    const auto base = hn::Set(d, p.x * x_px + p.y * y_px + p.c);
    return TwoHalves{hn::Add(base, hn::Load(d, &lane[first])), hn::Add(base, hn::Load(d, &lane[first + hn::Lanes(d)]))};
  };
  Coordinates c;
  c.u = plane(t.u, t.lane_u);
  c.v = plane(t.v, t.lane_v);
  if (t.affine) {
    c.inverse_sum = hn::Zero(Floats());
    return c;
  }
  const TwoHalves r = Each(plane(t.sum, t.lane_sum), [&](D sum) HWY_ATTR { return hn::Div(hn::Set(d, 1.0), sum); });
  c.u = {hn::Mul(c.u.low, r.low), hn::Mul(c.u.high, r.high)};
  c.v = {hn::Mul(c.v.low, r.low), hn::Mul(c.v.high, r.high)};
  c.inverse_sum = hn::Combine(Floats(), hn::DemoteTo(half, r.high), hn::DemoteTo(half, r.low));
  return c;
}

/// Coordinates after wrapping, and in 2^-31: the fixed point of all sizes that are powers of two.
struct WrappedCoordinates {
  TwoHalves u, v;
  U u_fx31, v_fx31;
};
HWY_INLINE WrappedCoordinates WrappedBy(const Sampler& sampler, const Coordinates& c) {
  WrappedCoordinates w;
  w.u = Wrapped(c.u, sampler.wrap_u);
  w.v = Wrapped(c.v, sampler.wrap_v);
  w.u_fx31 = Fixed(w.u, 0x1p31);
  w.v_fx31 = Fixed(w.v, 0x1p31);
  return w;
}

HWY_INLINE Sums LevelSums(const TexturedTriangle& t, std::int32_t level, const WrappedCoordinates& w, I& doubtful) {
  const TextureLevel& l = t.texture->levels[std::size_t(level)];
  const Axis x_axis = MakeAxis(l.size_px.x, 256 * l.size_px.x, t.sampler.wrap_u);
  const Axis y_axis = MakeAxis(l.size_px.y, 256 * l.size_px.y, t.sampler.wrap_v);
  const U x_fixed = x_axis.scale == 0x1p31 ? w.u_fx31 : Fixed(w.u, x_axis.scale);
  const U y_fixed = y_axis.scale == 0x1p31 ? w.v_fx31 : Fixed(w.v, y_axis.scale);
  const Pair x = LinearTexels(x_axis, x_fixed, t.margin_fx31, doubtful);
  const Pair y = LinearTexels(y_axis, y_fixed, t.margin_fx31, doubtful);
  const auto* texels = reinterpret_cast<const std::int32_t*>(l.raw.data());
  return Filtered(Fetch({texels, l.size_px.x, l.size_px.y}, x, y), x.second_weight, y.second_weight);
}

HWY_INLINE U NearestTexels(const TexturedTriangle& t, const WrappedCoordinates& w, I& doubtful) {
  const Ints di;
  const TextureLevel& l = t.texture->levels[0];
  const I x = NearestTexel(MakeAxis(l.size_px.x, l.size_px.x, t.sampler.wrap_u), w.u, t.margin_fx31, doubtful);
  const I y = NearestTexel(MakeAxis(l.size_px.y, l.size_px.y, t.sampler.wrap_v), w.v, t.margin_fx31, doubtful);
  const auto* texels = reinterpret_cast<const std::int32_t*>(l.raw.data());
  return hn::BitCast(Uints(), hn::GatherIndex(di, texels, hn::Add(hn::Mul(y, hn::Set(di, l.size_px.x)), x)));
}

/// One level for all of the lanes, and the next with weight `f`, if any lane's is not 0.
HWY_INLINE U TwoLevels(const TexturedTriangle& t, std::int32_t level, I f, hn::Mask<Ints> lanes,
                       const WrappedCoordinates& w, I& doubtful) {
  const Ints di;
  const Sums a = LevelSums(t, level, w, doubtful);
  if (hn::AllTrue(di, hn::Or(hn::Eq(f, hn::Zero(di)), hn::Not(lanes)))) return Rounded(a);
  return RoundedBlend(a, LevelSums(t, level + 1, w, doubtful), f);
}

/// Texels of some lanes of a 4×4 and how many were read for those that are not doubtful.
struct Shaded {
  U texels;
  std::uint32_t doubtful;
  std::uint32_t n_read;
};

/// In perspective each sample has levels of its own; most often all of a 4×4 have the same ones.
HWY_INLINE U VaryingLevels(const TexturedTriangle& t, const Slopes& slopes, std::size_t first, hn::Mask<Ints> lanes,
                           hn::Vec<Floats> inverse_sum, const WrappedCoordinates& w, I& doubtful,
                           std::uint32_t& second_levels) {
  const Ints di;
  const Floats f;
  const auto row = hn::SetTableIndices(f, kLaneY + first);
  const auto most =
      hn::Max(hn::TableLookupLanes(hn::LoadDup128(f, slopes.along_x), row), hn::LoadDup128(f, slopes.along_y));
  const auto r2 = hn::Mul(inverse_sum, inverse_sum);
  const std::int32_t top = 256 * (std::int32_t(t.texture->levels.size()) - 1);
  const I lambda = Lambda(t, hn::Mul(most, hn::Mul(r2, r2)), top, doubtful);
  const I fraction = hn::And(lambda, hn::Set(di, 255));
  second_levels = BitsOf(fraction);
  const I level = hn::ShiftRight<8>(lambda);
  const std::int32_t some = hn::GetLane(level);
  if (HWY_LIKELY(hn::AllTrue(di, hn::Eq(level, hn::Set(di, some))))) {
    return TwoLevels(t, some, fraction, lanes, w, doubtful);
  }
  const auto low = hn::GetLane(hn::MinOfLanes(di, hn::IfThenElse(lanes, level, hn::Set(di, top))));
  const auto high = hn::GetLane(hn::MaxOfLanes(di, hn::IfThenElseZero(lanes, level)));
  U texels = hn::Zero(Uints());
  for (std::int32_t l = low; l <= high; ++l) {
    const auto here = hn::And(lanes, hn::Eq(level, hn::Set(di, l)));
    if (hn::AllFalse(di, here)) continue;
    I doubt = hn::Zero(di);
    const U of_level = TwoLevels(t, l, fraction, here, w, doubt);
    doubtful = hn::Or(doubtful, hn::IfThenElseZero(here, doubt));
    texels = hn::IfThenElse(hn::RebindMask(Uints(), here), of_level, texels);
  }
  return texels;
}

/// Samples [first, first + lanes of Ints) of the 4×4 whose first one is at (x_px, y_px).
HWY_INLINE Shaded TexelsAt(const TexturedTriangle& t, double x_px, double y_px, const Slopes& slopes, std::size_t first,
                           std::uint32_t lanes) {
  const Ints di;
  I doubtful = hn::Zero(di);
  const Coordinates c = CoordinatesAt(t, x_px, y_px, first);
  const WrappedCoordinates w = WrappedBy(t.sampler, c);
  U texels;
  std::uint32_t per_sample = 4, second_levels = 0;
  if (t.sampler.filter == Filter::nearest) {
    texels = NearestTexels(t, w, doubtful);
    per_sample = 1;
  } else if (t.levels_vary) {
    texels = VaryingLevels(t, slopes, first, LanesOf(lanes), c.inverse_sum, w, doubtful, second_levels);
  } else {
    const std::int32_t f = t.levels.second_weight_fx8;
    texels = TwoLevels(t, t.levels.level, hn::Set(di, f), LanesOf(lanes), w, doubtful);
    second_levels = f > 0 ? ~0u : 0u;
  }
  const std::uint32_t doubts = BitsOf(doubtful) & lanes, sure = lanes & ~doubts;
  return {texels, doubts,
          per_sample * std::uint32_t(std::popcount(sure)) + 4 * std::uint32_t(std::popcount(sure & second_levels))};
}

/// The reference's texels of a 4×4's samples in `lanes`; returns how many it read.
HWY_INLINE std::uint64_t ExactTexels(const TexturedTriangle& t, int x_fx8, int y_fx8, std::uint32_t lanes,
                                     std::uint32_t* bytes) {
  std::uint64_t n_read = 0;
  for (; lanes != 0; lanes &= lanes - 1) {
    const int k = std::countr_zero(lanes);
    bytes[k] = exact_texel(t, {x_fx8 + 256 * (k & 3), y_fx8 + 256 * (k >> 2)}, &n_read);
  }
  return n_read;
}

/// The texels of a 4×4's samples in `lanes`; returns how many were read.
HWY_INLINE std::uint64_t TexelsOf(const TexturedTriangle& t, int x_fx8, int y_fx8, std::uint32_t lanes,
                                  std::uint32_t* bytes) {
  std::uint64_t n_read = 0;
  std::uint32_t doubtful = 0;
  if (t.bounded) {
    const double x_px = x_fx8 / 256.0, y_px = y_fx8 / 256.0;
    Slopes slopes;
    if (t.levels_vary) slopes = SlopesAt(t, x_px, y_px);
    constexpr std::uint32_t kAll = (1u << hn::MaxLanes(Ints())) - 1;
    for (std::size_t first = 0; first < 16; first += hn::Lanes(Ints())) {
      const std::uint32_t here = lanes >> first & kAll;
      if (here == 0) continue;
      const Shaded s = TexelsAt(t, x_px, y_px, slopes, first, here);
      hn::StoreU(s.texels, Uints(), bytes + first);
      n_read += s.n_read;
      doubtful |= s.doubtful << first;
    }
  } else {
    doubtful = lanes;
  }
  if (HWY_UNLIKELY(doubtful != 0)) n_read += ExactTexels(t, x_fx8, y_fx8, doubtful, bytes);
  return n_read;
}

}  // namespace HWY_NAMESPACE
}  // namespace lode::raster::fast
HWY_AFTER_NAMESPACE();

#endif  // per-target include guard
