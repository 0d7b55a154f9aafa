// Colour records: vertices' colours across triangles as planes, sixteen triangles at a time.
// Compiled once for each instruction set (Highway's re-included headers).

#include <algorithm>
#include <cstdint>
#include <cstring>

#include "raster/fast/kernels.h"

#if defined(LODE_RASTER_FAST_RECORDS_INL_H_) == defined(HWY_TARGET_TOGGLE)
#ifdef LODE_RASTER_FAST_RECORDS_INL_H_
#undef LODE_RASTER_FAST_RECORDS_INL_H_
#else
#define LODE_RASTER_FAST_RECORDS_INL_H_
#endif

#include "raster/fast/edges-inl.h"
#include "raster/fast/lanes-inl.h"
#include "raster/fast/sift-inl.h"

HWY_BEFORE_NAMESPACE();
namespace lode::raster::fast {
namespace HWY_NAMESPACE {

/// Bytes as C8 rounds them, as floats.
HWY_INLINE F RoundedToByte(F v) {
  const Floats f;
  const auto clamped = hn::Min(hn::Max(v, hn::Zero(f)), hn::Set(f, 255.0f));
  const auto whole = hn::Trunc(clamped);
  return hn::IfThenElse(hn::Ge(hn::Sub(clamped, whole), hn::Set(f, 0.5f)), hn::Add(whole, hn::Set(f, 1.0f)), whole);
}

/// The planes of as many triangles as there are lanes.
void MakeSomeRecords(const RecordJob& job, const std::int32_t* triangles, float (&out)[4][64]) {
  const Ints di;
  const Floats f;
  const Doubles d;
  I x[3], y[3];
  F inverse_w[3], colors[4][3];
  for (std::size_t k = 0; k < 3; ++k) {
    alignas(64) std::uint64_t xy[16];
    alignas(64) double w[16];
    const float* from[16];
    for (std::size_t i = 0; i < hn::Lanes(di); ++i) {
      const std::size_t corner = job.corners[3 * std::size_t(triangles[i]) + k];
      xy[i] = job.vertices->xy_fx8[corner];
      w[i] = job.vertices->w[corner];
      from[i] = job.colors + 4 * std::size_t(job.mesh_vertices[corner]);
    }
    hn::LoadInterleaved2(di, reinterpret_cast<const std::int32_t*>(xy), x[k], y[k]);
    const auto inverse = [&](std::size_t lane) HWY_ATTR {
      return hn::DemoteTo(HalfFloats(), hn::Div(hn::Set(d, 1.0), hn::Load(d, w + lane)));
    };
    inverse_w[k] = BothHalves(f, inverse(0), inverse(hn::Lanes(d)));
    F of_corner[4];
    LoadTransposed(from, 0, of_corner);
    for (std::size_t channel = 0; channel < 4; ++channel) colors[channel][k] = of_corner[channel];
  }
  const auto up = hn::Set(di, 255);
  const auto sample_x = hn::Set(di, job.sample_x_fx8), sample_y = hn::Set(di, job.sample_y_fx8);
  const auto first = [&](const I(&v)[3], I sample) HWY_ATTR {
    return hn::Max(hn::Zero(di), hn::ShiftRight<8>(hn::Add(hn::Sub(Least(v[0], v[1], v[2]), sample), up)));
  };
  const auto last = [&](const I(&v)[3], I sample) HWY_ATTR {
    return hn::Min(hn::Set(di, kTile_px - 1), hn::ShiftRight<8>(hn::Sub(Most(v[0], v[1], v[2]), sample)));
  };
  // The reference pixel is the middle of the box.
  const auto low_x = first(x, sample_x), high_x = last(x, sample_x), low_y = first(y, sample_y),
             high_y = last(y, sample_y);
  const auto ref_x = hn::ShiftRight<1>(hn::Add(low_x, high_x)), ref_y = hn::ShiftRight<1>(hn::Add(low_y, high_y));
  const auto reach_x = hn::ConvertTo(f, hn::Max(hn::Sub(high_x, ref_x), hn::Sub(ref_x, low_x)));
  const auto reach_y = hn::ConvertTo(f, hn::Max(hn::Sub(high_y, ref_y), hn::Sub(ref_y, low_y)));
  const LaneEdges e = EdgesOf(x, y, DoubledArea(x, y), hn::Add(hn::ShiftLeft<8>(ref_x), sample_x),
                              hn::Add(hn::ShiftLeft<8>(ref_y), sample_y));
  F at[3], right[3], down[3];
  for (int k = 0; k < 3; ++k) {
    at[k] = hn::Mul(hn::ConvertTo(f, e.at[k]), inverse_w[k]);
    right[k] = hn::Mul(hn::ConvertTo(f, e.right[k]), inverse_w[k]);
    down[k] = hn::Mul(hn::ConvertTo(f, e.down[k]), inverse_w[k]);
  }
  const auto sum_of = [](const F(&v)[3]) HWY_ATTR { return hn::Add(hn::Add(v[0], v[1]), v[2]); };
  const auto inverse = hn::Div(hn::Set(f, 1.0f), sum_of(at));
  auto terms = hn::Zero(f);
  for (int k = 0; k < 3; ++k) {
    at[k] = hn::Mul(at[k], inverse), right[k] = hn::Mul(right[k], inverse), down[k] = hn::Mul(down[k], inverse);
    terms = hn::Add(terms, hn::Add(hn::Abs(at[k]),
                                   hn::Add(hn::Mul(reach_x, hn::Abs(right[k])), hn::Mul(reach_y, hn::Abs(down[k])))));
  }
  const auto d_right = sum_of(right), d_down = sum_of(down);
  auto most = hn::Zero(f);
  F value[4], value_right[4], value_down[4];
  for (std::size_t channel = 0; channel < 4; ++channel) {
    F(&v)[3] = colors[channel];
    const auto scale = hn::Set(f, job.scale[channel]);
    const auto same = hn::And(hn::Eq(v[0], v[1]), hn::Eq(v[1], v[2]));
    for (auto& corner : v) {
      corner = hn::Mul(corner, scale);
      const auto size = hn::Abs(corner);
      most = hn::IfThenElse(hn::Gt(size, most), size, most);  // not Max: a NaN must not hide an infinity
    }
    const auto blend = [&](const F(&b)[3]) HWY_ATTR {
      return hn::Add(hn::Add(hn::Mul(b[0], v[0]), hn::Mul(b[1], v[1])), hn::Mul(b[2], v[2]));
    };
    // A colour that is the same at the corners is the same everywhere; as a byte it is never near a boundary. (With the
    // draw's own colour on it, the product's rounding is C7's to decide.)
    const auto flat = RoundedToByte(v[0]);
    const auto steady = job.scaled ? hn::Lt(hn::Zero(f), hn::Zero(f)) : same;
    value[channel] = hn::IfThenElse(steady, flat, blend(at));
    value_right[channel] = hn::IfThenElse(steady, hn::Mul(flat, d_right), blend(right));
    value_down[channel] = hn::IfThenElse(steady, hn::Mul(flat, d_down), blend(down));
  }
  const auto error = hn::Mul(hn::Mul(terms, hn::Max(most, hn::Set(f, 255.0f))), hn::Set(f, kRecordError));
  const auto reference = hn::BitCast(f, hn::Or(hn::ShiftLeft<8>(ref_y), ref_x));
  hn::StoreInterleaved4(d_right, d_down, reference, error, f, out[0]);
  hn::StoreInterleaved4(value[0], value[1], value[2], value[3], f, out[1]);
  hn::StoreInterleaved4(value_right[0], value_right[1], value_right[2], value_right[3], f, out[2]);
  hn::StoreInterleaved4(value_down[0], value_down[1], value_down[2], value_down[3], f, out[3]);
}

RecordCounts MakeRecords(const RecordJob& job) {
  const Ints di;
  const hn::Rebind<std::uint8_t, Ints> bytes;
  const int lanes = int(hn::Lanes(di));
  alignas(64) std::int32_t list[kMaxClusterTriangles + 32];
  RecordCounts n;
  for (int first = 0; first < kMaxClusterTriangles; first += lanes) {
    const auto marks = hn::BitCast(di, hn::PromoteTo(hn::RebindToUnsigned<Ints>(), hn::LoadU(bytes, job.marks + first)));
    const auto has = [&](std::uint8_t mark) HWY_ATTR {
      return hn::Ne(hn::And(marks, hn::Set(di, mark)), hn::Zero(di));
    };
    const auto wanted = has(job.wanted);
    if (hn::AllFalse(di, wanted)) continue;
    const auto triangle = hn::Add(hn::Set(di, first), hn::Iota(di, 0));
    const auto wide = hn::And(wanted, has(kWide)), narrow = hn::AndNot(wide, wanted);
    hn::StoreU(hn::Compress(triangle, narrow), di, list + n.made);
    hn::StoreU(hn::Compress(triangle, wide), di, job.wide + n.wide);
    n.made += int(hn::CountTrue(di, narrow));
    n.wide += int(hn::CountTrue(di, wide));
  }
  if (n.made == 0) return n;
  hn::StoreU(hn::Set(di, list[n.made - 1]), di, list + n.made);  // for the lanes behind the last
  alignas(64) float out[4][64];
  for (int first = 0; first < n.made; first += lanes) {
    MakeSomeRecords(job, list + first, out);
    for (int i = 0; i < std::min(lanes, n.made - first); ++i) {
      job.record_of[list[first + i]] = job.first_record + std::uint32_t(first + i);
      for (int q = 0; q < 4; ++q) std::memcpy(&job.records[first + i].quads[q], &out[q][4 * i], 16);
    }
  }
  return n;
}

}  // namespace HWY_NAMESPACE
}  // namespace lode::raster::fast
HWY_AFTER_NAMESPACE();

#endif  // per-target include guard
