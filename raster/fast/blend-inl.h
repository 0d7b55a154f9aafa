// Blending of bytes (C8).
// Compiled once for each instruction set (Highway's re-included headers).

#include <cstdint>

#include "raster/frame.h"

#if defined(LODE_RASTER_FAST_BLEND_INL_H_) == defined(HWY_TARGET_TOGGLE)
#ifdef LODE_RASTER_FAST_BLEND_INL_H_
#undef LODE_RASTER_FAST_BLEND_INL_H_
#else
#define LODE_RASTER_FAST_BLEND_INL_H_
#endif

#include "raster/fast/texels-inl.h"

HWY_BEFORE_NAMESPACE();
namespace lode::raster::fast {
namespace HWY_NAMESPACE {

/// d·(255 − alpha of s)/255 of each byte, rounded half up. With t = x + 128, (t + (t >> 8)) >> 8 (byte_product.h) is
/// ⌊257·t / 2^16⌋: the floors of t/256 and of the whole nest.
HWY_INLINE U Attenuated(U d, U s) {
  const Uints du;
  const hn::Repartition<std::uint16_t, Uints> d16;
  const Bytes d8;
  alignas(16) static constexpr std::uint8_t kAlpha[16] = {3,  0x80, 3,  0x80, 7,  0x80, 7,  0x80,
                                                          11, 0x80, 11, 0x80, 15, 0x80, 15, 0x80};
  const auto alpha = hn::BitCast(d16, hn::TableLookupBytesOr0(hn::BitCast(d8, s), hn::LoadDup128(d8, kAlpha)));
  const auto kept = hn::Xor(alpha, hn::Set(d16, 255));
  const auto product = [&](auto bytes) HWY_ATTR {
    return hn::MulHigh(hn::Add(hn::Mul(bytes, kept), hn::Set(d16, 128)), hn::Set(d16, 257));
  };
  const auto d_pairs = hn::BitCast(d16, d);
  const auto even = product(hn::And(d_pairs, hn::Set(d16, 255))), odd = product(hn::ShiftRight<8>(d_pairs));
  return hn::BitCast(du, hn::Or(even, hn::ShiftLeft<8>(odd)));
}

HWY_INLINE U Blended(Blend blend, U s, U d) {
  const Bytes d8;
  if (blend == Blend::none) return s;
  const U under = blend == Blend::over ? Attenuated(d, s) : d;
  return hn::BitCast(Uints(), hn::SaturatedAdd(hn::BitCast(d8, s), hn::BitCast(d8, under)));
}

}  // namespace HWY_NAMESPACE
}  // namespace lode::raster::fast
HWY_AFTER_NAMESPACE();

#endif  // per-target include guard
