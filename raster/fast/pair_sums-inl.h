// Dot products of two neighbouring lanes, which this version of Highway does not offer.
// Compiled once for each instruction set (Highway's re-included headers).

#include <cstdint>

#if defined(LODE_RASTER_FAST_PAIR_SUMS_INL_H_) == defined(HWY_TARGET_TOGGLE)
#ifdef LODE_RASTER_FAST_PAIR_SUMS_INL_H_
#undef LODE_RASTER_FAST_PAIR_SUMS_INL_H_
#else
#define LODE_RASTER_FAST_PAIR_SUMS_INL_H_
#endif

#include "raster/fast/lanes-inl.h"

HWY_BEFORE_NAMESPACE();
namespace lode::raster::fast {
namespace HWY_NAMESPACE {

/// a₀·b₀ + a₁·b₁ of the 16-bit halves of each 32-bit lane, all signed. The sum must fit.
HWY_INLINE I PairSums(I a, I b) {
#if HWY_TARGET == HWY_AVX3
  return I{_mm512_madd_epi16(a.raw, b.raw)};
#elif HWY_TARGET == HWY_AVX2
  return I{_mm256_madd_epi16(a.raw, b.raw)};
#elif HWY_TARGET == HWY_SSE4
  return I{_mm_madd_epi16(a.raw, b.raw)};
#else
  const auto low = [](I v) HWY_ATTR { return hn::ShiftRight<16>(hn::ShiftLeft<16>(v)); };
  return hn::Add(hn::Mul(low(a), low(b)), hn::Mul(hn::ShiftRight<16>(a), hn::ShiftRight<16>(b)));
#endif
}

/// a₀·b₀ + a₁·b₁ of the bytes of each 16-bit lane, a unsigned and b signed. The sum must fit 16 bits, signed.
HWY_INLINE I PairSumsOfBytes(I a, I b) {
#if HWY_TARGET == HWY_AVX3
  return I{_mm512_maddubs_epi16(a.raw, b.raw)};
#elif HWY_TARGET == HWY_AVX2
  return I{_mm256_maddubs_epi16(a.raw, b.raw)};
#elif HWY_TARGET == HWY_SSE4
  return I{_mm_maddubs_epi16(a.raw, b.raw)};
#else
  const hn::Repartition<std::int16_t, Ints> d16;
  const auto a16 = hn::BitCast(d16, a), b16 = hn::BitCast(d16, b);
  const auto low = hn::Mul(hn::And(a16, hn::Set(d16, 255)), hn::ShiftRight<8>(hn::ShiftLeft<8>(b16)));
  const auto high = hn::Mul(hn::And(hn::ShiftRight<8>(a16), hn::Set(d16, 255)), hn::ShiftRight<8>(b16));
  return hn::BitCast(Ints(), hn::Add(low, high));
#endif
}

}  // namespace HWY_NAMESPACE
}  // namespace lode::raster::fast
HWY_AFTER_NAMESPACE();

#endif  // per-target include guard
