// Colours of vertices across triangles, for bytes: each visible triangle's colours become planes once, and each sample
// is a quotient of planes. Where the quotient is too near to a rounding boundary to tell the byte of C7 and C8, the
// sample is left to the exact way. Compiled once for each instruction set (Highway's re-included headers).

#include <algorithm>
#include <cstdint>
#include <cstring>

#include "raster/fast/kernels.h"

#if defined(LODE_RASTER_FAST_RESOLVE_INL_H_) == defined(HWY_TARGET_TOGGLE)
#ifdef LODE_RASTER_FAST_RESOLVE_INL_H_
#undef LODE_RASTER_FAST_RESOLVE_INL_H_
#else
#define LODE_RASTER_FAST_RESOLVE_INL_H_
#endif

#include "raster/fast/lanes-inl.h"

HWY_BEFORE_NAMESPACE();
namespace lode::raster::fast {
namespace HWY_NAMESPACE {

/// Planes as each lane has them: quads[i][k] of its record.
struct Planes {
  F quads[4][4];
};
HWY_INLINE void PlanesOfAll(const ColorRecord& record, Planes& p) {
  for (int i = 0; i < 4; ++i) {
    for (int k = 0; k < 4; ++k) p.quads[i][k] = hn::Set(Floats(), record.quads[i][k]);
  }
}
template <class Mask>
HWY_INLINE void PlanesOfLanes(const ColorRecord& record, Mask lanes, Planes& p) {
  for (int i = 0; i < 4; ++i) {
    for (int k = 0; k < 4; ++k) {
      p.quads[i][k] = hn::IfThenElse(lanes, hn::Set(Floats(), record.quads[i][k]), p.quads[i][k]);
    }
  }
}

/// Bytes of lanes of a 4×4 from `lane`, and a bit for each of which the planes cannot tell the byte.
struct ShadedBytes {
  I bytes;
  std::uint32_t doubtful;
};
HWY_INLINE ShadedBytes ShadeSome(const Planes& p, std::size_t lane, int x_px, int y_px) {
  const Ints di;
  const Floats f;
  const auto& q = p.quads;
  const auto reference = hn::BitCast(di, q[0][2]);
  const auto from = [&](I px, I ref) HWY_ATTR { return hn::ConvertTo(f, hn::Sub(px, ref)); };
  const auto dx = from(hn::Add(hn::Set(di, x_px), hn::Load(di, kLaneX + lane)), hn::And(reference, hn::Set(di, 255)));
  const auto dy = from(hn::Add(hn::Set(di, y_px), hn::Load(di, kLaneY + lane)), hn::ShiftRight<8>(reference));
  const auto one = hn::Set(f, 1.0f), full = hn::Set(f, 255.0f);
  const auto divisor = hn::MulAdd(q[0][1], dy, hn::MulAdd(q[0][0], dx, one));
  const auto inverse = hn::Div(one, divisor);
  // A byte is sure if its value is nearer to it than half by more than the margin. Values beyond 0 and 255 are as sure
  // as those two. Added to 1.5 · 2^23, a value is rounded to a whole number, which then stands in the float's low bits.
  const auto magic = hn::Set(f, 0x1.8p23f);
  auto farthest = hn::Zero(f);
  auto bytes = hn::Zero(di);
  for (std::size_t c = 4; c-- > 0;) {
    const auto value = hn::Mul(hn::MulAdd(q[3][c], dy, hn::MulAdd(q[2][c], dx, q[1][c])), inverse);
    const auto clamped = hn::Min(hn::Max(value, hn::Zero(f)), full);
    const auto rounded = hn::Add(clamped, magic);
    farthest = hn::Max(farthest, hn::Abs(hn::Sub(clamped, hn::Sub(rounded, magic))));
    bytes = hn::Add(hn::ShiftLeft<8>(bytes), hn::BitCast(di, rounded));
  }
  constexpr std::uint32_t kMagicBits = 0x4B400000u;  // of which each byte's sum holds one
  bytes = hn::Sub(bytes, hn::Set(di, std::int32_t(kMagicBits * 0x01010101u)));
  const auto margin = hn::Mul(q[0][3], inverse);
  const auto sure =
      hn::And(hn::Gt(divisor, hn::Zero(f)), hn::Lt(farthest, hn::Sub(hn::Set(f, 0.5f), margin)));
  return {bytes, BitsOf(f, hn::Not(sure)) & ((1u << hn::Lanes(f)) - 1)};
}

std::uint32_t ShadeRecords(const ColorRecord* records, const std::uint32_t* index, int x_px, int y_px,
                           std::uint32_t* bytes) {
  const float* from[16];
  for (std::size_t i = 0; i < 16; ++i) from[i] = records[index[i]].quads[0];
  std::uint32_t doubtful = 0;
  for (std::size_t l = 0; l < 16; l += hn::Lanes(Floats())) {
    Planes p;
    for (std::size_t k = 0; k < 4; ++k) LoadTransposed(from + l, 4 * k, p.quads[k]);
    const ShadedBytes shaded = ShadeSome(p, l, x_px, y_px);
    hn::StoreU(shaded.bytes, Ints(), reinterpret_cast<std::int32_t*>(bytes) + l);
    doubtful |= shaded.doubtful << l;
  }
  return doubtful;
}

/// Lanes of a 4×4 from `lane`, of which `inside` are samples of the picture. Returns those that have no record.
HWY_INLINE std::uint32_t ResolveSome(const ResolveJob& job, std::size_t base, std::size_t lane, int x, int y,
                                     std::uint32_t inside) {
  constexpr int kFew = 6;  // so many owners' records are spread over their lanes; of more, each lane's is loaded
  const Ints di;
  const Floats f;
  const auto* owners_at = reinterpret_cast<const std::int32_t*>(job.tile->owner + base + lane);
  const auto owners = hn::Load(di, owners_at);
  const std::uint32_t pieces_and_nothing = BitsOf(di, hn::Lt(owners, hn::Zero(di)));
  const std::uint32_t nothing = BitsOf(di, hn::Eq(owners, hn::Set(di, -1)));
  const auto clear = hn::Set(di, std::int32_t(job.clear));
  *job.n_shaded += std::uint64_t(hwy::PopCount(inside & ~nothing));
  std::uint32_t others = inside & pieces_and_nothing & ~nothing;
  std::uint32_t lanes = inside & ~pieces_and_nothing;
  auto* out = reinterpret_cast<std::int32_t*>(job.rgba8 + base + lane);
  if (lanes == 0) {
    hn::Store(clear, di, out);
    return others;
  }
  const auto first_of = [&](std::uint32_t some) HWY_ATTR { return owners_at[hwy::Num0BitsBelowLS1Bit_Nonzero32(some)]; };
  Planes p;
  std::uint32_t left = lanes;
  bool any = false;
  for (int i = 0; left != 0 && i < kFew; ++i) {
    if (i == 3 && hwy::PopCount(left) > 6) break;  // many owners, it seems
    const std::int32_t owner = first_of(left);
    const auto its = hn::Eq(owners, hn::Set(di, owner));
    const std::uint32_t record = job.record_of[owner];
    left &= ~BitsOf(di, its);
    if (HWY_UNLIKELY(record == kNoRecord)) {
      others |= lanes & BitsOf(di, its);
    } else if (!any) {
      PlanesOfAll(job.records[record], p);
      any = true;
    } else {
      PlanesOfLanes(job.records[record], hn::RebindMask(f, its), p);
    }
  }
  if (left != 0) {
    const float* from[16];
    for (std::size_t k = 0; k < hn::Lanes(di); ++k) {
      std::uint32_t record = (lanes >> k & 1) != 0 ? job.record_of[owners_at[k]] : 0;
      if (HWY_UNLIKELY(record == kNoRecord)) others |= 1u << k, record = 0;
      from[k] = job.records[record].quads[0];
    }
    for (std::size_t k = 0; k < 4; ++k) LoadTransposed(from, 4 * k, p.quads[k]);
    any = true;
  }
  lanes &= ~others;
  if (!any || lanes == 0) {
    hn::Store(clear, di, out);
    return others;
  }
  const ShadedBytes shaded = ShadeSome(p, lane, x, y);
  hn::Store(hn::IfThenElse(hn::Lt(owners, hn::Zero(di)), clear, shaded.bytes), di, out);
  for (std::uint32_t doubtful = shaded.doubtful & lanes; doubtful != 0; doubtful &= doubtful - 1) {
    const std::size_t k = lane + hwy::Num0BitsBelowLS1Bit_Nonzero32(doubtful);
    job.doubtful[(*job.n_doubtful)++] = {std::uint32_t(base + k), std::uint16_t(std::size_t(x) + (k & 3)),
                                         std::uint16_t(std::size_t(y) + (k >> 2))};
  }
  return others;
}

/// One 4×4, of which `inside` are samples of the picture.
HWY_INLINE void ResolveBlock(const ResolveJob& job, int x, int y, std::uint32_t inside) {
  const auto base = std::size_t(place_in_tile(x, y));
  constexpr std::uint32_t kAll = (1u << hn::MaxLanes(Ints())) - 1;
  std::uint32_t others = 0;
  for (std::size_t l = 0; l < 16; l += hn::Lanes(Ints())) {
    others |= ResolveSome(job, base, l, x, y, inside >> l & kAll) << l;
  }
  if (others != 0) job.shade_others(job.context, x, y, others);
}

void ResolveRecords(const ResolveJob& job) {
  for (int y = 0; y < job.height_px; y += kBlock_px) {
    const std::uint8_t* written = job.tile->written + y / kBlock_px * kBlocksPerRow;
    for (int x = 0; x < job.width_px; x += kBlock_px) {
      const int place = place_in_tile(x, y), column = x / kBlock_px;
      if ((written[column] & kTouched) == 0) {
        if (job.fill || (written[column ^ 1] & kTouched) != 0) Fill(job.rgba8 + place, 64, job.clear);
        continue;
      }
      for (int quarter = 0; quarter < 4; ++quarter) {
        const int qx = x + 4 * (quarter & 1), qy = y + 4 * (quarter >> 1);
        const int w = job.width_px - qx, h = job.height_px - qy;
        std::uint32_t inside = 0xFFFF;
        if (w <= 0 || h <= 0) continue;
        if (w < 4 || h < 4) {
          inside = 0;
          for (int k = 0; k < 16; ++k) inside |= (k & 3) < w && (k >> 2) < h ? 1u << k : 0u;
        }
        ResolveBlock(job, qx, qy, inside);
      }
    }
  }
}

}  // namespace HWY_NAMESPACE
}  // namespace lode::raster::fast
HWY_AFTER_NAMESPACE();

#endif  // per-target include guard
