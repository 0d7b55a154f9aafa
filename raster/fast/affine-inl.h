// Textured triangles whose coordinates are affine in the window, in 32-bit fixed point: a 4×4 whose texels lie inside
// the picture needs one rounded coordinate of its first sample and an addition for each of the others.
// Compiled once for each instruction set (Highway's re-included headers).

#include <algorithm>
#include <cmath>
#include <cstdint>

#include "raster/fast/kernels.h"

#if defined(LODE_RASTER_FAST_AFFINE_INL_H_) == defined(HWY_TARGET_TOGGLE)
#ifdef LODE_RASTER_FAST_AFFINE_INL_H_
#undef LODE_RASTER_FAST_AFFINE_INL_H_
#else
#define LODE_RASTER_FAST_AFFINE_INL_H_
#endif

#include "raster/fast/texture-inl.h"

HWY_BEFORE_NAMESPACE();
namespace lode::raster::fast {
namespace HWY_NAMESPACE {

constexpr std::int32_t kWindow_px = 8;  ///< side of the window of texels that a 4×4 reads from

/// One axis of a level: fixed point with as many fraction bits of a 1/256 texel as fit, as Axis has it.
struct AffineAxis {
  Plane plane;
  Wrap wrap;
  std::int32_t size_px;
  int spare_bits;
  double scale;
  std::int32_t least, most;  ///< of `lane`
  std::int64_t quarter[4];   ///< what the coordinate gains from an 8×8's first sample to its 4×4s', rounded
  std::int64_t least_8x8, most_8x8;
  alignas(64) std::int32_t lane[16];  ///< what the coordinate gains within a 4×4, rounded to nearest
  bool narrow;                        ///< a 4×4's first texels span at most kWindow_px − 1 texels
};

HWY_INLINE void SetAffineAxis(const Plane& plane, const std::array<double, 16>& lane, std::int32_t size_px, Wrap wrap,
                              AffineAxis& a) {
  const Axis axis = MakeAxis(size_px, 256 * size_px, wrap);
  a.plane = plane;
  a.wrap = wrap;
  a.size_px = size_px;
  a.spare_bits = axis.spare_bits;
  a.scale = axis.scale;
  const auto [low, high] = std::minmax_element(lane.begin(), lane.end());
  // Two less than the span, for the roundings: so the floors of the ends are at most kWindow_px − 2 apart.
  const double span = double(kWindow_px - 2) * double(256 << a.spare_bits) - 2.0;
  a.narrow = size_px >= kWindow_px && (*high - *low) * a.scale <= span;
  if (!a.narrow) return;
  for (std::size_t i = 0; i < 16; ++i) a.lane[i] = std::int32_t(std::rint(lane[i] * a.scale));
  a.least = std::int32_t(std::rint(*low * a.scale));
  a.most = std::int32_t(std::rint(*high * a.scale));
  for (int i = 0; i < 4; ++i) {
    a.quarter[i] = std::int64_t(std::rint(4.0 * (plane.x * (i & 1) + plane.y * (i >> 1)) * a.scale));
  }
  const auto [first, last] = std::minmax_element(std::begin(a.quarter), std::end(a.quarter));
  a.least_8x8 = *first + a.least;
  a.most_8x8 = *last + a.most;
}

/// The coordinate of a block's first sample from the centre of texel 0, plus half of a 1/256 texel.
///   least, most   of what it gains within the block
/// False where the block leaves the picture, or is mirrored: wrapping is up to others.
HWY_INLINE bool StartAt(const AffineAxis& a, double x_px, double y_px, std::int64_t least, std::int64_t most,
                        std::int64_t& start) {
  double u = a.plane.x * x_px + a.plane.y * y_px + a.plane.c;
  if (a.wrap == Wrap::repeat) u -= std::floor(u);
  if (a.wrap == Wrap::mirror) u -= 2.0 * std::floor(0.5 * u);
  if (!(u >= 0.0 && u < 1.0)) return false;
  start = std::int64_t(u * a.scale + 0.5) - (std::int64_t(255) << (a.spare_bits - 1));
  return start + least >= 0 && start + most < std::int64_t(a.size_px - 1) << (a.spare_bits + 8);
}

/// The window that a 4×4 reads from, and its first sample's coordinate from there.
struct AffinePlace {
  std::int32_t window_px;
  std::int32_t start;
};
HWY_INLINE AffinePlace PlaceOf(const AffineAxis& a, std::int64_t start) {
  const int texel_bits = a.spare_bits + 8;
  const auto window_px = std::min(std::int32_t((start + a.least) >> texel_bits), a.size_px - kWindow_px);
  return {window_px, std::int32_t(start - (std::int64_t(window_px) << texel_bits))};
}

/// Texels from the window's first one, and weights; `doubtful` as for LinearTexels, with a margin 1 greater: the
/// coordinate is the sum of three numbers (the block's, the 4×4's, the lane's) that were rounded.
struct AffinePair {
  I first, second_weight;
};
HWY_INLINE AffinePair AffineTexels(const AffineAxis& a, const AffinePlace& place, std::int32_t margin, std::size_t lane,
                                   I& doubtful) {
  const Ints di;
  const auto x = hn::Add(hn::Set(di, place.start), hn::Load(di, a.lane + lane));
  const auto near = hn::And(hn::Add(x, hn::Set(di, margin + 1)), hn::Set(di, (1 << a.spare_bits) - 1));
  doubtful = hn::Or(doubtful, hn::VecFromMask(di, hn::Lt(near, hn::Set(di, 2 * margin + 3))));
  return {hn::ShiftRightSame(x, a.spare_bits + 8), hn::And(hn::ShiftRightSame(x, a.spare_bits), hn::Set(di, 255))};
}

/// A level of an affine triangle's texture.
struct AffineLevel {
  AffineAxis x, y;
  const std::int32_t* texels;
  bool narrow;
};
HWY_INLINE void SetAffineLevel(const TexturedTriangle& t, std::int32_t level, AffineLevel& a) {
  const TextureLevel& l = t.texture->levels[std::size_t(level)];
  SetAffineAxis(t.u, t.lane_u, l.size_px.x, t.sampler.wrap_u, a.x);
  SetAffineAxis(t.v, t.lane_v, l.size_px.y, t.sampler.wrap_v, a.y);
  a.texels = reinterpret_cast<const std::int32_t*>(l.raw.data());
  a.narrow = a.x.narrow && a.y.narrow;
}

/// The 4×4 of a level from a window: sums of the samples from `lane` on.
HWY_INLINE Sums AffineSums(const AffineLevel& a, const AffinePlace& x_place, const AffinePlace& y_place,
                           std::int32_t margin, std::size_t lane, I& doubtful) {
  const AffinePair x = AffineTexels(a.x, x_place, margin, lane, doubtful);
  const AffinePair y = AffineTexels(a.y, y_place, margin, lane, doubtful);
  const LevelTexels level = {a.texels, a.x.size_px, a.y.size_px};
  return Filtered(FetchNear(level, x_place.window_px, y_place.window_px, x.first, y.first, x.second_weight),
                  x.second_weight, y.second_weight);
}

/// An affine triangle's levels, kept for all of a tile.
struct AffineTexture {
  AffineLevel levels[2];
  I fraction;
  int n_levels = 0;  ///< 0: not for these kernels
};
HWY_INLINE void SetAffineTexture(const TexturedTriangle& t, AffineTexture& a) {
  a.n_levels = 0;
  if (!t.bounded || !t.affine || t.sampler.filter == Filter::nearest) return;
  const int n = t.levels.second_weight_fx8 > 0 ? 2 : 1;
  for (int i = 0; i < n; ++i) {
    SetAffineLevel(t, t.levels.level + i, a.levels[i]);
    if (!a.levels[i].narrow) return;
  }
  a.fraction = hn::Set(Ints(), t.levels.second_weight_fx8);
  a.n_levels = n;
}

/// Texels of the 4×4 at `quarter` of a block, from `lane` on, as many as Ints has lanes.
///   x_start, y_start   [levels] the block's
HWY_INLINE U AffineTexelsAt(const TexturedTriangle& t, const AffineTexture& a, const std::int64_t* x_start,
                            const std::int64_t* y_start, std::size_t quarter, std::size_t lane, I& doubtful) {
  const auto sums = [&](std::size_t i) HWY_ATTR {
    const AffineLevel& level = a.levels[i];
    return AffineSums(level, PlaceOf(level.x, x_start[i] + level.x.quarter[quarter]),
                      PlaceOf(level.y, y_start[i] + level.y.quarter[quarter]), t.margin_fx31, lane, doubtful);
  };
  const Sums first = sums(0);
  return a.n_levels == 1 ? Rounded(first) : RoundedBlend(first, sums(1), a.fraction);
}

/// Texels of a 4×4, and which are doubtful; false where the 4×4 leaves the picture.
HWY_INLINE bool AffineTexelsOf(const TexturedTriangle& t, const AffineTexture& a, double x_px, double y_px,
                               std::uint32_t* bytes, std::uint32_t& doubtful) {
  std::int64_t x[2], y[2];
  for (int i = 0; i < a.n_levels; ++i) {
    const AffineLevel& level = a.levels[i];
    if (!StartAt(level.x, x_px, y_px, level.x.least, level.x.most, x[i]) ||
        !StartAt(level.y, x_px, y_px, level.y.least, level.y.most, y[i])) {
      return false;
    }
  }
  for (std::size_t lane = 0; lane < 16; lane += hn::Lanes(Ints())) {
    I doubt = hn::Zero(Ints());
    hn::StoreU(AffineTexelsAt(t, a, x, y, 0, lane, doubt), Uints(), bytes + lane);
    doubtful |= BitsOf(doubt) << lane;
  }
  return true;
}

}  // namespace HWY_NAMESPACE
}  // namespace lode::raster::fast
HWY_AFTER_NAMESPACE();

#endif  // per-target include guard
