// Reading the four texels of each lane's linear filter: from a window of the level that holds all of them, as pairs of
// neighbours, or one by one. (Gather instructions take an access for each lane and many steps on top.)
// Compiled once for each instruction set (Highway's re-included headers).

#include <algorithm>
#include <cstdint>
#include <cstring>

#include "raster/fast/textured.h"

#if defined(LODE_RASTER_FAST_FETCH_INL_H_) == defined(HWY_TARGET_TOGGLE)
#ifdef LODE_RASTER_FAST_FETCH_INL_H_
#undef LODE_RASTER_FAST_FETCH_INL_H_
#else
#define LODE_RASTER_FAST_FETCH_INL_H_
#endif

#include "raster/fast/lanes-inl.h"

HWY_BEFORE_NAMESPACE();
namespace lode::raster::fast {
namespace HWY_NAMESPACE {

using Uints = hn::RebindToUnsigned<Ints>;
using Bytes = hn::Repartition<std::uint8_t, Ints>;
using U = hn::Vec<Uints>;

/// Texels that a linear filter reads along an axis, and the second one's weight, 0…255; the first one's is 256 minus
/// it.
struct Pair {
  I first, second, second_weight;
};

/// One level, rows of `width_px` texels.
struct LevelTexels {
  const std::int32_t* texels;
  std::int32_t width_px, height_px;
};

/// Two texels of each lane with their bytes in turn: r r g g b b a a. In each four lanes, 0 and 1 are in `low`, 2 and 3
/// in `high`. Where the second texel's weight is 0, the first one stands in its place.
struct PairedBytes {
  I low, high;
};
struct Quad {
  PairedBytes top, bottom;
};

HWY_INLINE PairedBytes Paired(I first, I second) {
  const Ints di;
  const Bytes d8;
  const auto a = hn::BitCast(d8, first), b = hn::BitCast(d8, second);
  return {hn::BitCast(di, hn::InterleaveLower(d8, a, b)), hn::BitCast(di, hn::InterleaveUpper(d8, a, b))};
}

HWY_INLINE Quad FetchOneByOne(const LevelTexels& level, const Pair& x, const Pair& y) {
  const Ints di;
  const auto width = hn::Set(di, level.width_px);
  const auto row0 = hn::Mul(y.first, width), row1 = hn::Mul(y.second, width);
  const auto x1 = hn::IfThenElse(hn::Eq(x.second_weight, hn::Zero(di)), x.first, x.second);
  const auto at = [&](I row, I column) HWY_ATTR { return hn::GatherIndex(di, level.texels, hn::Add(row, column)); };
  return {Paired(at(row0, x.first), at(row0, x1)), Paired(at(row1, x.first), at(row1, x1))};
}

/// Texels `index` and index + 1 of each lane.
HWY_INLINE PairedBytes FetchPairs(const std::int32_t* texels, const std::int32_t* index, I x_weight) {
  const Ints di;
  [[maybe_unused]] const hn::Repartition<std::uint64_t, Ints> d64;
  const Bytes d8;
  // Lanes 0, 1, 4, 5, … and 2, 3, 6, 7, …, as interleaving leaves them.
  const auto two = [&](std::size_t k) HWY_ATTR {
    const hn::Full128<std::uint64_t> pair;
    const auto one = [&](std::int32_t i) HWY_ATTR {
      return hn::LoadU(hn::CappedTag<std::uint64_t, 1>(), reinterpret_cast<const std::uint64_t*>(texels + i));
    };
    return hn::Combine(pair, one(index[k + 1]), one(index[k]));
  };
  const auto gathered = [&](std::size_t k) HWY_ATTR {
#if HWY_TARGET == HWY_AVX3
    const hn::CappedTag<std::uint64_t, 4> half;
    return hn::Combine(d64, hn::Combine(half, two(k + 12), two(k + 8)), hn::Combine(half, two(k + 4), two(k)));
#elif HWY_TARGET == HWY_AVX2
    return hn::Combine(d64, two(k + 4), two(k));
#else
    return two(k);
#endif
  };
  alignas(16) static constexpr std::uint8_t kInTurn[16] = {0, 4, 1, 5, 2, 6, 3, 7, 8, 12, 9, 13, 10, 14, 11, 15};
  alignas(16) static constexpr std::uint8_t kFirst[16] = {0, 0, 1, 1, 2, 2, 3, 3, 8, 8, 9, 9, 10, 10, 11, 11};
  const auto in_turn = [&](auto lanes, I weight) HWY_ATTR {
    const auto bytes = hn::BitCast(d8, lanes);
    const auto paired = hn::BitCast(di, hn::TableLookupBytes(bytes, hn::LoadDup128(d8, kInTurn)));
    const auto firsts = hn::BitCast(di, hn::TableLookupBytes(bytes, hn::LoadDup128(d8, kFirst)));
    return hn::IfThenElse(hn::Eq(weight, hn::Zero(di)), firsts, paired);
  };
  return {in_turn(gathered(0), hn::InterleaveLower(di, x_weight, x_weight)),
          in_turn(gathered(2), hn::InterleaveUpper(di, x_weight, x_weight))};
}

#if HWY_TARGET == HWY_AVX3
/// The 8×8 texels from (x, y) on hold every texel of the lanes: `place` is the first one's, 8·row + column, both
/// below 7. Registers of two rows serve as tables.
HWY_INLINE Quad FetchFromWindow(const LevelTexels& level, std::int32_t x, std::int32_t y, I place, I x_weight) {
  const Ints di;
  const std::int32_t* from = level.texels + std::size_t(y) * std::size_t(level.width_px) + std::size_t(x);
  const auto two_rows = [&](int row) HWY_ATTR {
    const hn::CappedTag<std::int32_t, 8> half;
    const std::int32_t* first = from + std::ptrdiff_t(row) * level.width_px;
    return hn::Combine(di, hn::LoadU(half, first + level.width_px), hn::LoadU(half, first));
  };
  const I rows[4] = {two_rows(0), two_rows(2), two_rows(4), two_rows(6)};
  const auto at = [&](I i) HWY_ATTR {
    const I low{_mm512_permutex2var_epi32(rows[0].raw, i.raw, rows[1].raw)};
    const I high{_mm512_permutex2var_epi32(rows[2].raw, i.raw, rows[3].raw)};
    return hn::IfThenElse(hn::TestBit(i, hn::Set(di, 32)), high, low);
  };
  const I step = hn::IfThenZeroElse(hn::Eq(x_weight, hn::Zero(di)), hn::Set(di, 1));
  const I below = hn::Add(place, hn::Set(di, 8));
  return {Paired(at(place), at(hn::Add(place, step))), Paired(at(below), at(hn::Add(below, step)))};
}
#endif

/// Lanes whose second texels are right of and below the first ones.
HWY_INLINE Quad FetchAllPairs(const LevelTexels& level, I column, I row, I x_weight) {
  const Ints di;
  alignas(64) std::int32_t top[16], bottom[16];
  const auto index = hn::Add(hn::Mul(row, hn::Set(di, level.width_px)), column);
  hn::Store(index, di, top);
  hn::Store(hn::Add(index, hn::Set(di, level.width_px)), di, bottom);
  return {FetchPairs(level.texels, top, x_weight), FetchPairs(level.texels, bottom, x_weight)};
}

/// The first texels of all lanes are within columns x…x + 6 and rows y…y + 6 of the level, and are given from there;
/// the second ones are right of and below them, inside the level.
HWY_INLINE Quad FetchNear(const LevelTexels& level, std::int32_t x, std::int32_t y, I column, I row, I x_weight) {
#if HWY_TARGET == HWY_AVX3
  return FetchFromWindow(level, x, y, hn::Add(hn::ShiftLeft<3>(row), column), x_weight);
#else
  const std::int32_t* from = level.texels + std::size_t(y) * std::size_t(level.width_px) + std::size_t(x);
  return FetchAllPairs({from, level.width_px, level.height_px}, column, row, x_weight);
#endif
}

#if HWY_TARGET == HWY_AVX3
/// Least column and row of a 4×4's corners; nearly always they are the least of all lanes (but not where a projective
/// map's weights change their sign).
HWY_INLINE void LeastOfCorners(I column, I row, std::int32_t& left, std::int32_t& top) {
  const Ints di;
  const hn::CappedTag<std::int32_t, 8> half;
  alignas(64) static constexpr std::int32_t kCorners[16] = {0, 3, 12, 15, 16, 19, 28, 31, 0, 3, 12, 15, 16, 19, 28, 31};
  const I corners{_mm512_permutex2var_epi32(column.raw, hn::Load(di, kCorners).raw, row.raw)};
  auto least = hn::LowerHalf(half, corners);
  least = hn::Min(least, hn::Shuffle1032(least));
  least = hn::Min(least, hn::Shuffle2301(least));
  left = hn::GetLane(least);
  top = hn::GetLane(hn::UpperHalf(hn::CappedTag<std::int32_t, 4>(), least));
}
#endif

HWY_INLINE Quad Fetch(const LevelTexels& level, const Pair& x, const Pair& y) {
  const Ints di;
  const auto one = hn::Set(di, 1);
  const auto neighbours = hn::And(hn::Eq(x.second, hn::Add(x.first, one)), hn::Eq(y.second, hn::Add(y.first, one)));
  if (HWY_UNLIKELY(!hn::AllTrue(di, neighbours))) return FetchOneByOne(level, x, y);
#if HWY_TARGET == HWY_AVX3
  if (level.width_px >= 8 && level.height_px >= 8) {
    std::int32_t left, top;
    LeastOfCorners(x.first, y.first, left, top);
    left = std::min(left, level.width_px - 8);
    top = std::min(top, level.height_px - 8);
    const auto column = hn::Sub(x.first, hn::Set(di, left)), row = hn::Sub(y.first, hn::Set(di, top));
    const auto least = hn::Min(column, row), most = hn::Max(column, row);
    if (hn::AllTrue(di, hn::And(hn::Gt(least, hn::Set(di, -1)), hn::Lt(most, hn::Set(di, 7))))) {
      return FetchNear(level, left, top, column, row, x.second_weight);
    }
  }
#endif
  return FetchAllPairs(level, x.first, y.first, x.second_weight);
}

}  // namespace HWY_NAMESPACE
}  // namespace lode::raster::fast
HWY_AFTER_NAMESPACE();

#endif  // per-target include guard
