// Levels of detail of a 4×4's samples (C10): λ = log2 of the longer derivative, in single precision, and where that
// cannot tell.
// Compiled once for each instruction set (Highway's re-included headers).

#include <cstdint>

#include "raster/fast/textured.h"

#if defined(LODE_RASTER_FAST_LAMBDA_INL_H_) == defined(HWY_TARGET_TOGGLE)
#ifdef LODE_RASTER_FAST_LAMBDA_INL_H_
#undef LODE_RASTER_FAST_LAMBDA_INL_H_
#else
#define LODE_RASTER_FAST_LAMBDA_INL_H_
#endif

#include "raster/fast/lanes-inl.h"

HWY_BEFORE_NAMESPACE();
namespace lode::raster::fast {
namespace HWY_NAMESPACE {

/// 128·log2(m) of the mantissas m in [1, 2): z·q(z), z = m − 1, q interpolating at Chebyshev's nodes. Off by at most
/// 2^-14.3 over all 2^23 mantissas (compared with a double logarithm, one by one).
HWY_INLINE hn::Vec<Floats> Log2OfMantissa(hn::Vec<Floats> z) {
  const Floats f;
  constexpr float kQ[8] = {0x1.715472p+7f, -0x1.714f1ep+6f, 0x1.eb8862p+5f, -0x1.699218p+5f,
                           0x1.054cf2p+5f, -0x1.3bb40cp+4f, 0x1.01048p+3f,  -0x1.8bbd64p+0f};
  const auto pair = [&](int i) HWY_ATTR { return hn::Add(hn::Set(f, kQ[i]), hn::Mul(hn::Set(f, kQ[i + 1]), z)); };
  const auto z2 = hn::Mul(z, z);
  const auto low = hn::Add(pair(0), hn::Mul(pair(2), z2)), high = hn::Add(pair(4), hn::Mul(pair(6), z2));
  return hn::Mul(hn::Add(low, hn::Mul(high, hn::Mul(z2, z2))), z);
}

/// Levels of detail, 8.8, clamped to [0, top]; `doubtful` where single precision cannot tell: ρ² is off by 9 roundings
/// (2^-20.8, which is 2^-13.3 of 128·log2) and the logarithm by 2^-14.3, together less than the 2^-12 in margin_lambda.
HWY_INLINE I Lambda(const TexturedTriangle& t, hn::Vec<Floats> rho_squared, std::int32_t top, I& doubtful) {
  const Ints di;
  const Floats f;
  const auto bits = hn::BitCast(di, rho_squared);
  const auto exponent = hn::Sub(hn::ShiftRight<23>(bits), hn::Set(di, 127));
  const auto mantissa = hn::BitCast(f, hn::Or(hn::And(bits, hn::Set(di, 0x7FFFFF)), hn::Set(di, 0x3F800000)));
  const auto log = Log2OfMantissa(hn::Sub(mantissa, hn::Set(f, 1.0f)));
  const auto whole = hn::NearestInt(log);
  const auto lambda = hn::Add(hn::ShiftLeft<7>(exponent), whole);
  const auto from_whole = hn::Abs(hn::Sub(log, hn::ConvertTo(f, whole)));
  const auto near = hn::RebindMask(di, hn::Gt(from_whole, hn::Set(f, 0.5f - t.margin_lambda)));
  // Below 0 and above the top one more or less changes nothing.
  const auto used = hn::And(hn::Gt(lambda, hn::Set(di, -1)), hn::Lt(lambda, hn::Set(di, top + 1)));
  doubtful = hn::Or(doubtful, hn::VecFromMask(di, hn::And(near, used)));
  return hn::Min(hn::Max(lambda, hn::Zero(di)), hn::Set(di, top));
}

/// Squares of the derivatives' numerators at a 4×4: [4] along x, by row; [4] along y, by column.
struct Slopes {
  alignas(16) float along_x[4], along_y[4];
};
HWY_INLINE Slopes SlopesAt(const TexturedTriangle& t, double x_px, double y_px) {
  const hn::CappedTag<double, 4> d;
  const hn::Rebind<float, decltype(d)> f;
  Slopes s;
  const auto squares = [&](std::size_t k, double start, float* out) HWY_ATTR {
    for (std::size_t i = 0; i < 4; i += hn::Lanes(d)) {
      const auto at = hn::Add(hn::Set(d, start), hn::Iota(d, double(i)));
      const auto du = hn::Add(hn::Set(d, t.slope[k]), hn::Mul(hn::Set(d, t.slope_step[k]), at));
      const auto dv = hn::Add(hn::Set(d, t.slope[k + 1]), hn::Mul(hn::Set(d, t.slope_step[k + 1]), at));
      hn::StoreU(hn::DemoteTo(f, hn::Add(hn::Mul(du, du), hn::Mul(dv, dv))), f, out + i);
    }
  };
  squares(0, y_px, s.along_x);
  squares(2, x_px, s.along_y);
  return s;
}

}  // namespace HWY_NAMESPACE
}  // namespace lode::raster::fast
HWY_AFTER_NAMESPACE();

#endif  // per-target include guard
