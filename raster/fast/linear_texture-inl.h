// Linear textures of surfaces by bilinear and trilinear filters (C10): addresses of sixteen samples at a time, then
// each sample's texels, four channels at a time, in the reference's order.
// Compiled once for each instruction set (Highway's re-included headers).

#include <cstdint>

#include "raster/blend.h"
#include "raster/fast/kernels.h"
#include "raster/level_of_detail.h"

#if defined(LODE_RASTER_FAST_LINEAR_TEXTURE_INL_H_) == defined(HWY_TARGET_TOGGLE)
#ifdef LODE_RASTER_FAST_LINEAR_TEXTURE_INL_H_
#undef LODE_RASTER_FAST_LINEAR_TEXTURE_INL_H_
#else
#define LODE_RASTER_FAST_LINEAR_TEXTURE_INL_H_
#endif

#include "raster/fast/surface-inl.h"

HWY_BEFORE_NAMESPACE();
namespace lode::raster::fast {
namespace HWY_NAMESPACE {

/// `wrapped_coordinate` of half of the lanes.
HWY_INLINE D WrappedExactly(D u, Wrap wrap) {
  const Doubles d;
  const auto finite = hn::IfThenElseZero(hn::IsFinite(u), u);
  const auto clamped = [&](double low, double high) HWY_ATTR {
    return hn::IfThenElse(hn::Lt(finite, hn::Set(d, low)), hn::Set(d, low),
                          hn::IfThenElse(hn::Lt(hn::Set(d, high), finite), hn::Set(d, high), finite));
  };
  switch (wrap) {
    case Wrap::repeat:
      return hn::Sub(finite, hn::Trunc(finite));
    case Wrap::mirror:
      return hn::Abs(hn::Sub(finite, hn::Mul(hn::Set(d, 2.0), hn::Round(hn::Mul(finite, hn::Set(d, 0.5))))));
    case Wrap::clamp:
      return clamped(0.0, 1.0);
    default:
      return clamped(-1.0, 2.0);
  }
}

/// `rounded_product` of half of the lanes: a·n rounded half to even, exactly.
HWY_INLINE hn::Vec<HalfInts> RoundedProduct(D a, D n) {
  const Doubles d;
  const HalfFloats f;
  const D product = hn::Mul(a, n);
  D rounded = hn::Round(product);
  const auto tie = hn::Eq(hn::Abs(hn::Sub(product, rounded)), hn::Set(d, 0.5));
  if (HWY_UNLIKELY(!hn::AllFalse(d, tie))) {
    const D high = hn::PromoteTo(d, hn::DemoteTo(f, a)), low = hn::Sub(a, high);
    const D error = hn::Add(hn::Sub(hn::Mul(high, n), product), hn::Mul(low, n));
    const D floored = hn::Floor(product);
    rounded = hn::IfThenElse(hn::And(tie, hn::Gt(error, hn::Zero(d))), hn::Add(floored, hn::Set(d, 1.0)), rounded);
    rounded = hn::IfThenElse(hn::And(tie, hn::Lt(error, hn::Zero(d))), floored, rounded);
  }
  return hn::DemoteTo(HalfInts(), rounded);
}

/// What a filter reads along one axis at each of sixteen samples (`TexelPair`).
struct AxisTexels {
  alignas(64) std::int32_t first[16], second[16], second_weight_fx8[16];
};

HWY_INLINE hn::Vec<HalfInts> WrappedTexels(hn::Vec<HalfInts> index, hn::Vec<HalfInts> size, Wrap wrap) {
  const HalfInts i32;
  const auto below = hn::Lt(index, hn::Zero(i32)), above = hn::Not(hn::Lt(index, size));
  if (wrap == Wrap::repeat) {
    return hn::IfThenElse(below, hn::Add(index, size), hn::IfThenElse(above, hn::Sub(index, size), index));
  }
  if (wrap == Wrap::border) return hn::IfThenElse(hn::Or(below, above), hn::Set(i32, -1), index);
  return hn::Max(hn::Min(index, hn::Sub(size, hn::Set(i32, 1))), hn::Zero(i32));
}

/// `linear_texels` of coordinates [16] in pictures of sizes [16].
HWY_INLINE void LinearTexelsAt(const double* coordinates, const std::int32_t* sizes_px, Wrap wrap, AxisTexels& out) {
  const Doubles d;
  const HalfInts i32;
  for (std::size_t lane = 0; lane < 16; lane += hn::Lanes(d)) {
    const auto size = hn::Load(i32, sizes_px + lane), size_fx8 = hn::ShiftLeft<8>(size);
    auto x = RoundedProduct(WrappedExactly(hn::Load(d, coordinates + lane), wrap), hn::PromoteTo(d, size_fx8));
    if (wrap == Wrap::repeat) x = hn::Add(x, hn::And(hn::VecFromMask(i32, hn::Lt(x, hn::Zero(i32))), size_fx8));
    const auto from_centre = hn::Sub(x, hn::Set(i32, 128));
    const auto first = hn::ShiftRight<8>(from_centre);
    hn::Store(WrappedTexels(first, size, wrap), i32, out.first + lane);
    hn::Store(WrappedTexels(hn::Add(first, hn::Set(i32, 1)), size, wrap), i32, out.second + lane);
    hn::Store(hn::And(from_centre, hn::Set(i32, 255)), i32, out.second_weight_fx8 + lane);
  }
}

/// The four texels of sixteen samples in one level: where they are, and their weights in 2^-24.
struct LevelReads {
  alignas(64) std::int32_t index[4][16];  ///< in the level's picture, or kBorderTexel, kNoTexel
  alignas(64) double weight[4][16];
  /// A bit a sample: whether the four are two pairs of neighbours, none of them outside or of weight 0.
  std::uint32_t whole;
};
/// Outside a picture with borders; of weight 0, which adds nothing, be the texel infinite.
constexpr std::int32_t kBorderTexel = -1, kNoTexel = -2;

/// Reads in the level of each sample, or in the one above it.
///   level_weights_fx8   [16] of that level
HWY_INLINE void ReadsOf(const Surface& s, const std::int32_t* levels, std::int32_t above,
                        const std::int32_t* level_weights_fx8, const SurfaceSamples& samples, LevelReads& out) {
  const Doubles d;
  const HalfInts i32;
  alignas(64) std::int32_t width[16], height[16];
  const auto top = std::int32_t(s.texture->levels.size()) - 1;
  for (std::size_t k = 0; k < 16; ++k) {
    const glm::ivec2 size = s.texture->levels[std::size_t(HWY_MIN(levels[k] + above, top))].size_px;
    width[k] = size.x, height[k] = size.y;
  }
  AxisTexels x, y;
  LinearTexelsAt(samples.u, width, s.sampler.wrap_u, x);
  LinearTexelsAt(samples.v, height, s.sampler.wrap_v, y);
  out.whole = 0;
  for (std::size_t lane = 0; lane < 16; lane += hn::Lanes(i32)) {
    const auto level = hn::Load(i32, level_weights_fx8 + lane), row = hn::Load(i32, width + lane);
    const auto x1 = hn::Load(i32, x.second_weight_fx8 + lane);
    const auto y1 = hn::Mul(level, hn::Load(i32, y.second_weight_fx8 + lane));
    const auto next = hn::Add(hn::Load(i32, x.first + lane), hn::Set(i32, 1));
    auto whole = hn::Eq(next, hn::Load(i32, x.second + lane));
    const hn::Vec<HalfInts> x_weights[2] = {hn::Sub(hn::Set(i32, 256), x1), x1};
    const hn::Vec<HalfInts> y_weights[2] = {hn::Sub(hn::ShiftLeft<8>(level), y1), y1};
    for (std::size_t k = 0; k < 4; ++k) {
      const auto tx = hn::Load(i32, (k & 1 ? x.second : x.first) + lane);
      const auto ty = hn::Load(i32, (k >> 1 ? y.second : y.first) + lane);
      const auto weight = hn::Mul(y_weights[k >> 1], x_weights[k & 1]);
      const auto outside = hn::Lt(hn::Or(tx, ty), hn::Zero(i32));
      const auto index = hn::IfThenElse(outside, hn::Set(i32, kBorderTexel), hn::Add(hn::Mul(ty, row), tx));
      const auto none = hn::Eq(weight, hn::Zero(i32));
      whole = hn::AndNot(hn::Or(outside, none), whole);
      hn::Store(hn::IfThenElse(none, hn::Set(i32, kNoTexel), index), i32, out.index[k] + lane);
      hn::Store(hn::PromoteTo(d, weight), d, out.weight[k] + lane);
    }
    out.whole |= BitsOf(i32, whole) << lane;
  }
}

/// Σ weight · texel of one sample, four channels, in double; a weight times a float is exact, so that fused
/// multiplications give the same sum.
class TexelSum {
 public:
  /// No texel, then the border's.
  explicit HWY_INLINE TexelSum(const float* special) : special_(special) {
    for (auto& sum : sum_) sum = hn::Zero(Fours());
  }
  HWY_INLINE void Add(const TextureLevel& level, const LevelReads& reads, std::size_t sample) {
    const Fours d;
    const hn::Rebind<float, Fours> f;
    const float* texels = &level.linear.data()->x;
    if (reads.whole >> sample & 1) {
      const float* rows[2] = {texels + 4 * std::ptrdiff_t(reads.index[0][sample]),
                              texels + 4 * std::ptrdiff_t(reads.index[2][sample])};
      for (std::size_t k = 0; k < 4; ++k) {
        const auto weight = hn::Set(d, reads.weight[k][sample]);
        for (std::size_t i = 0; i < kVectors; ++i) {
          const float* texel = rows[k >> 1] + 4 * (k & 1) + i * hn::Lanes(d);
          sum_[i] = hn::MulAdd(weight, hn::PromoteTo(d, hn::LoadU(f, texel)), sum_[i]);
        }
      }
      return;
    }
    for (std::size_t k = 0; k < 4; ++k) {
      const std::int32_t index = reads.index[k][sample];
      const float* texel = (index < 0 ? special_ + 8 : texels) + 4 * std::ptrdiff_t(index);
      const auto weight = hn::Set(d, reads.weight[k][sample]);
      for (std::size_t i = 0; i < kVectors; ++i) {
        sum_[i] = hn::MulAdd(weight, hn::PromoteTo(d, hn::LoadU(f, texel + i * hn::Lanes(d))), sum_[i]);
      }
    }
  }
  /// The mean over weights that add up to 2^24.
  HWY_INLINE void StoreMean(float* texel) const {
    const Fours d;
    const hn::Rebind<float, Fours> f;
    for (std::size_t i = 0; i < kVectors; ++i) {
      hn::StoreU(hn::DemoteTo(f, hn::Mul(sum_[i], hn::Set(d, 0x1p-24))), f, texel + i * hn::Lanes(d));
    }
  }

 private:
  using Fours = hn::CappedTag<double, 4>;
  static constexpr std::size_t kVectors = 4 / hn::MaxLanes(Fours());
  const float* special_;
  hn::Vec<Fours> sum_[kVectors];
};

std::uint64_t ApplyLinearTexture(const Surface& s, std::uint32_t lanes, SurfaceSamples& samples) {
  const Floats f;
  const glm::vec4 border = store_rgba32f(s.sampler.border);
  const float special[8] = {0.0f, 0.0f, 0.0f, 0.0f, border.r, border.g, border.b, border.a};
  const auto n_levels = std::int32_t(s.texture->levels.size());
  alignas(64) std::int32_t levels[16] = {}, fractions[16] = {}, rests[16];
  std::uint32_t blended = 0;
  if (s.sampler.filter == Filter::trilinear) {
    for (std::uint32_t left = lanes; left != 0; left &= left - 1) {
      const std::size_t k = hwy::Num0BitsBelowLS1Bit_Nonzero32(left);
      if (!(samples.rho_squared[k] > kFirstLevelAlone)) continue;
      const LevelPair pair = mip_levels(lambda_fx8(samples.rho_squared[k]), n_levels);
      levels[k] = pair.level, fractions[k] = pair.second_weight_fx8;
      blended |= pair.second_weight_fx8 > 0 ? 1u << k : 0u;
    }
  }
  for (std::size_t k = 0; k < 16; ++k) rests[k] = 256 - fractions[k];
  LevelReads here, above;
  ReadsOf(s, levels, 0, rests, samples, here);
  if (blended != 0) ReadsOf(s, levels, 1, fractions, samples, above);
  alignas(64) float texels[64] = {};
  for (std::uint32_t left = lanes; left != 0; left &= left - 1) {
    const std::size_t k = hwy::Num0BitsBelowLS1Bit_Nonzero32(left);
    const TextureLevel* level = &s.texture->levels[std::size_t(levels[k])];
    TexelSum sum(special);
    sum.Add(level[0], here, k);
    if (fractions[k] > 0) sum.Add(level[1], above, k);
    sum.StoreMean(texels + 4 * k);
  }
  for (std::size_t lane = 0; lane < 16; lane += hn::Lanes(f)) {
    F texel[4];
    hn::LoadInterleaved4(f, texels + 4 * lane, texel[0], texel[1], texel[2], texel[3]);
    for (std::size_t c = 0; c < 4; ++c) {
      F value = hn::Mul(hn::Load(f, samples.rgba[c] + lane), Stored(f, texel[c]));
      if (s.full != 1.0f) value = hn::Div(value, hn::Set(f, s.full));
      if (s.lambert && !s.cut_out && c < 3) value = hn::Mul(value, hn::Load(f, samples.light + lane));
      hn::Store(value, f, samples.rgba[c] + lane);
    }
  }
  return 4 * std::uint64_t(hwy::PopCount(lanes)) + 4 * std::uint64_t(hwy::PopCount(blended));
}

}  // namespace HWY_NAMESPACE
}  // namespace lode::raster::fast
HWY_AFTER_NAMESPACE();

#endif  // per-target include guard
