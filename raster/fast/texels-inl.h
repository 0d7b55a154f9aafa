// Texels of one level of a texture, and their weighted sums (C10).
// Compiled once for each instruction set (Highway's re-included headers).

#include <bit>
#include <cstdint>

#include "raster/fast/textured.h"

#if defined(LODE_RASTER_FAST_TEXELS_INL_H_) == defined(HWY_TARGET_TOGGLE)
#ifdef LODE_RASTER_FAST_TEXELS_INL_H_
#undef LODE_RASTER_FAST_TEXELS_INL_H_
#else
#define LODE_RASTER_FAST_TEXELS_INL_H_
#endif

#include "raster/fast/fetch-inl.h"
#include "raster/fast/lanes-inl.h"
#include "raster/fast/pair_sums-inl.h"

HWY_BEFORE_NAMESPACE();
namespace lode::raster::fast {
namespace HWY_NAMESPACE {

using Shorts = hn::Repartition<std::int16_t, Ints>;
using D = hn::Vec<Doubles>;

/// A double for each lane of Ints: lanes [0, n/2) and [n/2, n).
struct TwoHalves {
  D low, high;
};

template <class F>
HWY_INLINE TwoHalves Each(const TwoHalves& a, F f) {
  return {f(a.low), f(a.high)};
}

/// The coordinate brought to [0, 1] as `wrapped_coordinate` does, but for `repeat`, which comes to u − ⌊u⌋. All modes
/// are continuous (on the circle), so that an error of u is no greater here.
HWY_INLINE TwoHalves Wrapped(const TwoHalves& u, Wrap wrap) {
  const Doubles d;
  switch (wrap) {
    case Wrap::repeat:
      return Each(u, [&](D a) HWY_ATTR { return hn::Sub(a, hn::Floor(a)); });
    case Wrap::mirror:
      return Each(u, [&](D a) HWY_ATTR {
        return hn::Abs(hn::Sub(a, hn::Mul(hn::Set(d, 2.0), hn::Round(hn::Mul(a, hn::Set(d, 0.5))))));
      });
    default:
      return Each(u, [&](D a) HWY_ATTR { return hn::Min(hn::Max(a, hn::Zero(d)), hn::Set(d, 1.0)); });
  }
}

/// One axis of a level: coordinates times `size_fx` in fixed point with as many more fraction bits as 31 bits hold.
struct Axis {
  std::int32_t size_px;
  Wrap wrap;
  int spare_bits;
  double scale;
};

/// size_fx: size_px times 256 for linear filters, times 1 for the nearest texel.
HWY_INLINE Axis MakeAxis(std::int32_t size_px, std::int32_t size_fx, Wrap wrap) {
  const int spare_bits = 31 - std::bit_width(std::uint32_t(size_fx) - 1);
  return {size_px, wrap, spare_bits, double(std::uint64_t(std::uint32_t(size_fx)) << spare_bits)};
}

/// w·scale, w in [0, 1], rounded to nearest: adding 1.5·2^52 leaves it in the sum's low bits. Of a NaN (samples outside
/// the triangle where the weights' sum is 0) they are 0.
HWY_INLINE U Fixed(const TwoHalves& w, double scale) {
  const Doubles d;
  const hn::RebindToUnsigned<Doubles> u64;
  const hn::Rebind<std::uint32_t, Doubles> half;
  const auto low_bits = [&](D a) HWY_ATTR {
    return hn::TruncateTo(half, hn::BitCast(u64, hn::Add(hn::Mul(a, hn::Set(d, scale)), hn::Set(d, 0x1.8p52))));
  };
  return hn::Combine(Uints(), low_bits(w.high), low_bits(w.low));
}

/// Lanes whose coordinate is within `margin` of a place where its rounding changes; `shifted` is in spare bits, with
/// the place at 0.
HWY_INLINE I Doubtful(const Axis& axis, U shifted, std::int32_t margin) {
  const Ints di;
  const Uints du;
  const auto near =
      hn::And(hn::Add(shifted, hn::Set(du, std::uint32_t(margin))), hn::Set(du, (1u << axis.spare_bits) - 1));
  return hn::VecFromMask(di, hn::Lt(hn::BitCast(di, near), hn::Set(di, 2 * margin + 1)));
}

HWY_INLINE Pair LinearTexels(const Axis& axis, U fixed, std::int32_t margin, I& doubtful) {
  const Ints di;
  const Uints du;
  const auto rounding = hn::Add(fixed, hn::Set(du, 1u << (axis.spare_bits - 1)));
  doubtful = hn::Or(doubtful, Doubtful(axis, rounding, margin));
  const auto from_centre = hn::Sub(hn::BitCast(di, hn::ShiftRightSame(rounding, axis.spare_bits)), hn::Set(di, 128));
  auto first = hn::ShiftRight<8>(from_centre);  // −1 … size − 1
  auto second = hn::Add(first, hn::Set(di, 1));
  const auto weight = hn::And(from_centre, hn::Set(di, 255));
  const auto size = hn::Set(di, axis.size_px), last = hn::Set(di, axis.size_px - 1);
  if (axis.wrap == Wrap::repeat) {
    first = hn::IfThenElse(hn::Lt(first, hn::Zero(di)), last, first);
    second = hn::IfThenZeroElse(hn::Eq(second, size), second);
  } else {
    first = hn::Max(first, hn::Zero(di));
    second = hn::Min(second, last);
  }
  return {first, second, weight};
}

/// The texel that contains the coordinate. At the picture's edges there is nothing to doubt, unless it repeats there.
HWY_INLINE I NearestTexel(const Axis& axis, const TwoHalves& w, std::int32_t margin, I& doubtful) {
  const Ints di;
  const U fixed = Fixed(w, axis.scale);
  I near = Doubtful(axis, fixed, margin);
  if (axis.wrap != Wrap::repeat) {
    const auto bound =
        hn::BitCast(di, hn::ShiftRightSame(hn::Add(fixed, hn::Set(Uints(), std::uint32_t(margin))), axis.spare_bits));
    const auto at_edge = hn::Or(hn::Eq(bound, hn::Zero(di)), hn::Eq(bound, hn::Set(di, axis.size_px)));
    near = hn::IfThenZeroElse(at_edge, near);
  }
  doubtful = hn::Or(doubtful, near);
  return hn::Min(hn::BitCast(di, hn::ShiftRightSame(fixed, axis.spare_bits)), hn::Set(di, axis.size_px - 1));
}

/// Sums of weight·texel in 1/2^16 (24 bits), less 2^23. Vector k has the four channels of lane k of each four.
struct Sums {
  I of_lane[4];
};

HWY_INLINE Sums Filtered(const Quad& q, I x_weight, I y_weight) {
  const Ints di;
  const Shorts d16;
  // Along x: (256 − w)·(a − 128) + w·(b − 128), from −2^15 to 2^15 − 1. Bytes hold the weights, as a weight of 0 can be
  // made 1: there both texels are the first one.
  const auto second = hn::Max(x_weight, hn::Set(di, 1));
  const auto x_bytes = hn::Add(hn::ShiftLeft<8>(second), hn::Sub(hn::Set(di, 256), second));
  const auto x_both = hn::Or(x_bytes, hn::ShiftLeft<16>(x_bytes));
  const auto x_low = hn::InterleaveLower(di, x_both, x_both), x_high = hn::InterleaveUpper(di, x_both, x_both);
  const auto along_x = [&](I weights, I texels) HWY_ATTR {
    return PairSumsOfBytes(weights, hn::Xor(texels, hn::Set(di, std::int32_t(0x80808080u))));
  };
  const auto top_low = along_x(x_low, q.top.low), top_high = along_x(x_high, q.top.high);
  const auto bottom_low = along_x(x_low, q.bottom.low), bottom_high = along_x(x_high, q.bottom.high);
  // Along y: the same of 16-bit numbers.
  const auto y_pairs = hn::Add(hn::ShiftLeft<16>(y_weight), hn::Sub(hn::Set(di, 256), y_weight));
  const auto lower = [&](I top, I bottom) HWY_ATTR {
    return hn::BitCast(di, hn::InterleaveLower(d16, hn::BitCast(d16, top), hn::BitCast(d16, bottom)));
  };
  const auto upper = [&](I top, I bottom) HWY_ATTR {
    return hn::BitCast(di, hn::InterleaveUpper(d16, hn::BitCast(d16, top), hn::BitCast(d16, bottom)));
  };
  return {{PairSums(hn::Broadcast<0>(y_pairs), lower(top_low, bottom_low)),
           PairSums(hn::Broadcast<1>(y_pairs), upper(top_low, bottom_low)),
           PairSums(hn::Broadcast<2>(y_pairs), lower(top_high, bottom_high)),
           PairSums(hn::Broadcast<3>(y_pairs), upper(top_high, bottom_high))}};
}

/// Byte `kByte` of each channel's sum, as rgba8 lanes.
template <int kByte>
HWY_INLINE U Packed(const Sums& s) {
  const Ints di;
  const Bytes d8;
  constexpr auto place = [](int k) {
    std::array<std::uint8_t, 16> from{};
    for (std::size_t i = 0; i < 16; ++i) {
      from[i] = int(i >> 2) == k ? std::uint8_t(4 * (i & 3) + kByte) : std::uint8_t(0x80);  // 0x80: zero
    }
    return from;
  };
  alignas(16) static constexpr std::array<std::array<std::uint8_t, 16>, 4> kFrom = {place(0), place(1), place(2),
                                                                                    place(3)};
  I packed = hn::Zero(di);
  for (std::size_t k = 0; k < 4; ++k) {
    const auto bytes = hn::TableLookupBytesOr0(hn::BitCast(d8, s.of_lane[k]), hn::LoadDup128(d8, kFrom[k].data()));
    packed = hn::Or(packed, hn::BitCast(di, bytes));
  }
  return hn::BitCast(Uints(), packed);
}

/// One level: the sum in 1/2^16, rounded half up.
HWY_INLINE U Rounded(Sums s) {
  const Ints di;
  for (I& sum : s.of_lane) sum = hn::Add(sum, hn::Set(di, (1 << 23) + (1 << 15)));
  return Packed<2>(s);
}

/// Two levels, with weights 256 − f and f: the sum in 1/2^24, rounded half up. (a·256 + (b − a)·f) + 2^31 is in
/// [0, 2^32), so that arithmetic modulo 2^32 gives it.
HWY_INLINE U RoundedBlend(const Sums& a, const Sums& b, I f) {
  const Ints di;
  const I weight[4] = {hn::Broadcast<0>(f), hn::Broadcast<1>(f), hn::Broadcast<2>(f), hn::Broadcast<3>(f)};
  Sums s;
  for (int k = 0; k < 4; ++k) {
    const auto sum = hn::Add(hn::ShiftLeft<8>(a.of_lane[k]), hn::Mul(hn::Sub(b.of_lane[k], a.of_lane[k]), weight[k]));
    s.of_lane[k] = hn::Add(sum, hn::Set(di, std::int32_t(0x80800000u)));
  }
  return Packed<3>(s);
}

}  // namespace HWY_NAMESPACE
}  // namespace lode::raster::fast
HWY_AFTER_NAMESPACE();

#endif  // per-target include guard
