// Vectors that the kernels use: sixteen 32-bit lanes, or eight 64-bit ones, where the processor has them.
// Compiled once for each instruction set (Highway's re-included headers).

#include <cstdint>
#include <cstring>

#if defined(LODE_RASTER_FAST_LANES_INL_H_) == defined(HWY_TARGET_TOGGLE)
#ifdef LODE_RASTER_FAST_LANES_INL_H_
#undef LODE_RASTER_FAST_LANES_INL_H_
#else
#define LODE_RASTER_FAST_LANES_INL_H_
#endif

#include <hwy/highway.h>

HWY_BEFORE_NAMESPACE();
namespace lode::raster::fast {
namespace HWY_NAMESPACE {

namespace hn = hwy::HWY_NAMESPACE;

using Ints = hn::CappedTag<std::int32_t, 16>;
using Floats = hn::CappedTag<float, 16>;
using Doubles = hn::CappedTag<double, 8>;
using HalfInts = hn::Rebind<std::int32_t, Doubles>;  ///< as many lanes as Doubles
using HalfFloats = hn::Rebind<float, Doubles>;
using I = hn::Vec<Ints>;
using F = hn::Vec<Floats>;

// Where the sixteen lanes of a 4×4 are.
alignas(64) constexpr std::int32_t kLaneX_fx8[16] = {0, 256, 512, 768, 0, 256, 512, 768,
                                                     0, 256, 512, 768, 0, 256, 512, 768};
alignas(64) constexpr std::int32_t kLaneY_fx8[16] = {0,   0,   0,   0,   256, 256, 256, 256,
                                                     512, 512, 512, 512, 768, 768, 768, 768};
alignas(64) constexpr double kLaneXInDouble[16] = {0, 1, 2, 3, 0, 1, 2, 3, 0, 1, 2, 3, 0, 1, 2, 3};
alignas(64) constexpr double kLaneYInDouble[16] = {0, 0, 0, 0, 1, 1, 1, 1, 2, 2, 2, 2, 3, 3, 3, 3};
alignas(64) constexpr std::int32_t kLaneX[16] = {0, 1, 2, 3, 0, 1, 2, 3, 0, 1, 2, 3, 0, 1, 2, 3};
alignas(64) constexpr std::int32_t kLaneY[16] = {0, 0, 0, 0, 1, 1, 1, 1, 2, 2, 2, 2, 3, 3, 3, 3};

alignas(64) constexpr std::int32_t kLaneBit[16] = {1,   2,   4,    8,    16,   32,   64,    128,
                                                   256, 512, 1024, 2048, 4096, 8192, 16384, 32768};

/// Lanes of two vectors of half as many, which Doubles's are of Floats's and Ints's.
template <class Wide, class Half>
HWY_INLINE hn::Vec<Wide> BothHalves(Wide wide, Half low, Half high) {
  return hn::Combine(wide, high, low);
}

/// right · x + down · y of the sixteen lanes of a 4×4, in pixels from its first.
HWY_INLINE void StoreLanes(double right, double down, double* lanes) {
  const Doubles d;
  for (std::size_t l = 0; l < 16; l += hn::Lanes(d)) {
    const auto x = hn::Mul(hn::Set(d, right), hn::Load(d, kLaneXInDouble + l));
    hn::Store(hn::Add(x, hn::Mul(hn::Set(d, down), hn::Load(d, kLaneYInDouble + l))), d, lanes + l);
  }
}

/// A bit for each lane of the mask; at most 32 lanes.
template <class Tag, class Mask>
HWY_INLINE std::uint32_t BitsOf(Tag tag, Mask mask) {
  std::uint8_t bits[8] = {};
  hn::StoreMaskBits(tag, mask, bits);
  std::uint32_t out;
  std::memcpy(&out, bits, 4);
  return out;
}

/// n pixels of one value, one behind the other.
HWY_INLINE void Fill(std::uint32_t* to, std::size_t n, std::uint32_t value) {
  const Ints di;
  const auto v = hn::Set(di, std::int32_t(value));
  std::size_t i = 0;
  for (; i + hn::Lanes(di) <= n; i += hn::Lanes(di)) hn::StoreU(v, di, reinterpret_cast<std::int32_t*>(to) + i);
  for (; i < n; ++i) to[i] = value;
}

/// Four floats each, `offset` behind as many places as there are groups of four lanes: first[0], first[4], …
template <class Tag>
HWY_INLINE hn::Vec<Tag> FoursFrom(Tag tag, const float* const* first, std::size_t offset) {
  if constexpr (hn::MaxLanes(Tag()) > 4) {
    const hn::Half<Tag> half;
    return hn::Combine(tag, FoursFrom(half, first + hn::MaxLanes(Tag()) / 2, offset), FoursFrom(half, first, offset));
  } else {
    return hn::Load(tag, first[0] + offset);
  }
}

/// Component c of the four floats at from[i] + offset becomes lane i of out[c]. (As LoadInterleaved4 from scattered
/// places: the fours go straight into registers.)
HWY_INLINE void LoadTransposed(const float* const* from, std::size_t offset, hn::Vec<Floats> (&out)[4]) {
  const Floats f;
  const hn::RepartitionToWide<Floats> pairs;
  const auto a = FoursFrom(f, from, offset), b = FoursFrom(f, from + 1, offset);
  const auto c = FoursFrom(f, from + 2, offset), d = FoursFrom(f, from + 3, offset);
  const auto ab_low = hn::BitCast(pairs, hn::InterleaveLower(f, a, b)),
             ab_high = hn::BitCast(pairs, hn::InterleaveUpper(f, a, b));
  const auto cd_low = hn::BitCast(pairs, hn::InterleaveLower(f, c, d)),
             cd_high = hn::BitCast(pairs, hn::InterleaveUpper(f, c, d));
  out[0] = hn::BitCast(f, hn::InterleaveLower(pairs, ab_low, cd_low));
  out[1] = hn::BitCast(f, hn::InterleaveUpper(pairs, ab_low, cd_low));
  out[2] = hn::BitCast(f, hn::InterleaveLower(pairs, ab_high, cd_high));
  out[3] = hn::BitCast(f, hn::InterleaveUpper(pairs, ab_high, cd_high));
}

}  // namespace HWY_NAMESPACE
}  // namespace lode::raster::fast
HWY_AFTER_NAMESPACE();

#endif  // per-target include guard
