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

/// Σ weight · texel of one sample, four channels, in double.
class TexelSum {
 public:
  HWY_INLINE TexelSum() {
    for (auto& sum : sum_) sum = hn::Zero(Fours());
  }
  /// A texel of weight 0 adds nothing, be it infinite.
  HWY_INLINE void Add(const float* texel, std::int32_t weight) {
    if (weight == 0) return;
    const Fours d;
    const hn::Rebind<float, Fours> f;
    const auto w = hn::Set(d, double(weight));
    for (std::size_t i = 0; i < kVectors; ++i) {
      const auto term = hn::Mul(w, hn::PromoteTo(d, hn::LoadU(f, texel + i * hn::Lanes(d))));
      sum_[i] = hn::Add(sum_[i], term);
    }
  }
  /// The mean over weights that add up to 2^24, as float targets keep it.
  HWY_INLINE void StoreMean(float* texel) const {
    const Fours d;
    const hn::Rebind<float, Fours> f;
    for (std::size_t i = 0; i < kVectors; ++i) {
      const auto mean = hn::DemoteTo(f, hn::Mul(sum_[i], hn::Set(d, 0x1p-24)));
      hn::StoreU(Stored(f, mean), f, texel + i * hn::Lanes(d));
    }
  }

 private:
  using Fours = hn::CappedTag<double, 4>;
  static constexpr std::size_t kVectors = 4 / hn::MaxLanes(Fours());
  hn::Vec<Fours> sum_[kVectors];
};

/// One level's part of each sample's sum.
struct LevelAddresses {
  AxisTexels x, y;
};

HWY_INLINE void AddLevel(const TextureLevel& level, const LevelAddresses& at, std::size_t k, std::int32_t level_weight,
                         const float* border, TexelSum& sum) {
  const auto* texels = &level.linear.data()->x;
  const auto texel = [&](std::int32_t x, std::int32_t y) HWY_ATTR {
    return (x | y) < 0 ? border : texels + 4 * (std::size_t(y) * std::size_t(level.size_px.x) + std::size_t(x));
  };
  const std::int32_t x1 = at.x.second_weight_fx8[k], x0 = 256 - x1;
  const std::int32_t y1 = level_weight * at.y.second_weight_fx8[k], y0 = level_weight * 256 - y1;
  sum.Add(texel(at.x.first[k], at.y.first[k]), y0 * x0);
  sum.Add(texel(at.x.second[k], at.y.first[k]), y0 * x1);
  sum.Add(texel(at.x.first[k], at.y.second[k]), y1 * x0);
  sum.Add(texel(at.x.second[k], at.y.second[k]), y1 * x1);
}

/// Addresses in the level of each sample, or in the one above it.
HWY_INLINE void AddressesOf(const Surface& s, const std::int32_t* levels, std::int32_t above,
                            const SurfaceSamples& samples, LevelAddresses& at) {
  alignas(64) std::int32_t width[16], height[16];
  const auto top = std::int32_t(s.texture->levels.size()) - 1;
  for (std::size_t k = 0; k < 16; ++k) {
    const glm::ivec2 size = s.texture->levels[std::size_t(HWY_MIN(levels[k] + above, top))].size_px;
    width[k] = size.x, height[k] = size.y;
  }
  LinearTexelsAt(samples.u, width, s.sampler.wrap_u, at.x);
  LinearTexelsAt(samples.v, height, s.sampler.wrap_v, at.y);
}

std::uint64_t ApplyLinearTexture(const Surface& s, std::uint32_t lanes, SurfaceSamples& samples) {
  const Floats f;
  const glm::vec4 border = store_rgba32f(s.sampler.border);
  const auto n_levels = std::int32_t(s.texture->levels.size());
  alignas(64) std::int32_t levels[16] = {}, fractions[16] = {};
  std::uint32_t blended = 0;
  if (s.sampler.filter == Filter::trilinear) {
    for (std::uint32_t left = lanes; left != 0; left &= left - 1) {
      const std::size_t k = hwy::Num0BitsBelowLS1Bit_Nonzero32(left);
      const LevelPair pair = mip_levels(lambda_fx8(samples.rho_squared[k]), n_levels);
      levels[k] = pair.level, fractions[k] = pair.second_weight_fx8;
      blended |= pair.second_weight_fx8 > 0 ? 1u << k : 0u;
    }
  }
  LevelAddresses here, above;
  AddressesOf(s, levels, 0, samples, here);
  if (blended != 0) AddressesOf(s, levels, 1, samples, above);
  alignas(64) float texels[64] = {};
  for (std::uint32_t left = lanes; left != 0; left &= left - 1) {
    const std::size_t k = hwy::Num0BitsBelowLS1Bit_Nonzero32(left);
    const TextureLevel* level = &s.texture->levels[std::size_t(levels[k])];
    TexelSum sum;
    AddLevel(level[0], here, k, 256 - fractions[k], &border.x, sum);
    if (fractions[k] > 0) AddLevel(level[1], above, k, fractions[k], &border.x, sum);
    sum.StoreMean(texels + 4 * k);
  }
  for (std::size_t lane = 0; lane < 16; lane += hn::Lanes(f)) {
    F texel[4];
    hn::LoadInterleaved4(f, texels + 4 * lane, texel[0], texel[1], texel[2], texel[3]);
    for (std::size_t c = 0; c < 4; ++c) {
      F value = hn::Mul(hn::Load(f, samples.rgba[c] + lane), texel[c]);
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
