// Triangles of a cluster into the masked depth buffer.
// Compiled once for each instruction set (Highway's re-included headers).

#include <algorithm>
#include <bit>
#include <cstdint>

#include "techniques/masked_occlusion/occluder_kernels.h"

#if defined(LODE_TECHNIQUES_DRAW_CLUSTER_INL_H_) == defined(HWY_TARGET_TOGGLE)
#ifdef LODE_TECHNIQUES_DRAW_CLUSTER_INL_H_
#undef LODE_TECHNIQUES_DRAW_CLUSTER_INL_H_
#else
#define LODE_TECHNIQUES_DRAW_CLUSTER_INL_H_
#endif

#include "techniques/masked_occlusion/triangle_lanes-inl.h"

HWY_BEFORE_NAMESPACE();
namespace lode::techniques {
namespace HWY_NAMESPACE {

bool AllClean(const raster::fast::WindowVertices128& v, int n) {
  const Doubles d;
  const Ints di;
  const auto zero = hn::Zero(d), one = hn::Set(d, 1.0), least_w = hn::Set(d, 0x1p-100), most_w = hn::Set(d, 0x1p100);
  for (int i = 0; i < n; i += int(hn::Lanes(d))) {
    const auto z = hn::Load(d, v.z + i), w = hn::Load(d, v.w + i);
    const auto inside =
        hn::And(hn::And(hn::Gt(z, zero), hn::Lt(z, one)), hn::And(hn::Gt(w, least_w), hn::Lt(w, most_w)));
    const auto xy = hn::LoadU(di, reinterpret_cast<const std::int32_t*>(v.xy_fx8 + i));
    if (!hn::AllTrue(d, inside) || !hn::AllTrue(di, hn::Lt(hn::Abs(xy), hn::Set(di, 1 << 22)))) return false;
  }
  return true;
}

/// What the walk needs to know of some triangles, one a lane.
struct SetUps {
  alignas(64) std::int32_t at[3][16], right[3][16], down[3][16];  ///< edges at the first sample of the first subtile
  alignas(64) std::int32_t first_x[16], first_y[16], last_x[16], last_y[16];  ///< samples
  Planes planes;
};

void SetUp(const ClusterJob& job, const Triangles& list, int first, glm::ivec2 end_px, SetUps& out) {
  const Ints di;
  I x[3], y[3];
  alignas(64) double z[3][16] = {};
  for (int k = 0; k < 3; ++k) x[k] = hn::LoadU(di, list.x[k] + first), y[k] = hn::LoadU(di, list.y[k] + first);
  for (int i = 0; i < std::min(int(hn::Lanes(di)), list.n - first); ++i) {
    const std::uint8_t* const corners = job.corners + 3 * list.triangle[first + i];
    for (int k = 0; k < 3; ++k) z[k][i] = job.vertices->z[corners[k]];
  }
  const SampleBoxes box = SampleBoxesOf(x, y, end_px);
  const auto area = DoubledAreas(x, y);
  const auto centre = hn::Set(di, 128);
  const auto px = hn::Add(hn::ShiftLeft<11>(hn::ShiftRight<3>(box.first_x)), centre);
  const auto py = hn::Add(hn::ShiftLeft<10>(hn::ShiftRight<2>(box.first_y)), centre);
  const fast::LaneEdges e = fast::EdgesOf(x, y, area, px, py);
  for (int k = 0; k < 3; ++k) {  // in whole pixels: E − bias ≥ 0 as long as floor((E − bias) / 256) is
    hn::Store(hn::ShiftRight<8>(hn::Sub(e.at[k], e.bias[k])), di, out.at[k]);
    hn::Store(hn::ShiftRight<8>(e.right[k]), di, out.right[k]);
    hn::Store(hn::ShiftRight<8>(e.down[k]), di, out.down[k]);
  }
  hn::Store(box.first_x, di, out.first_x), hn::Store(box.first_y, di, out.first_y);
  hn::Store(box.last_x, di, out.last_x), hn::Store(box.last_y, di, out.last_y);
  PlanesOf(x, y, z, area, out.planes);
}

/// Bit 8·y + x: sample (x, y) of a subtile is inside all edges, given at its first sample.
///   lanes   [3][32] what is added there
HWY_INLINE std::uint32_t CoverageOf(const std::int32_t (&at)[3], const std::int32_t (&lanes)[3][32]) {
  const Ints di;
  std::uint32_t coverage = 0;
  const auto a = hn::Set(di, at[0]), b = hn::Set(di, at[1]), c = hn::Set(di, at[2]);
  for (std::size_t l = 0; l < 32; l += hn::Lanes(di)) {
    const auto signs = hn::Or(hn::Or(hn::Add(a, hn::Load(di, lanes[0] + l)), hn::Add(b, hn::Load(di, lanes[1] + l))),
                              hn::Add(c, hn::Load(di, lanes[2] + l)));
    coverage |= fast::BitsOf(di, hn::Gt(signs, hn::Set(di, -1))) << l;
  }
  return coverage;
}

/// Bit x: a sample of column x.
HWY_INLINE std::uint32_t ColumnsOf(std::uint32_t coverage) {
  coverage |= coverage >> 16;
  return (coverage | coverage >> 8) & 0xFFu;
}

/// One triangle, line by line of subtiles. Returns how many of them it has a sample in.
HWY_INLINE std::uint64_t Walk(const SetUps& s, int i, MaskedDepth& buffer) {
  constexpr int kMostColumns = 10;  // 64 px and what is left of them at either end
  const Ints di;
  alignas(64) std::int32_t lanes[3][32];
  for (int k = 0; k < 3; ++k) {
    const auto right = hn::Set(di, s.right[k][i]), down = hn::Set(di, s.down[k][i]);
    for (std::size_t l = 0; l < 32; l += hn::Lanes(di)) {
      hn::Store(hn::Add(hn::Mul(right, hn::Load(di, kSampleX + l)), hn::Mul(down, hn::Load(di, kSampleY + l))), di,
                lanes[k] + l);
    }
  }
  const int begin_column = s.first_x[i] >> 3, n_columns = (s.last_x[i] >> 3) - begin_column + 1;
  std::int32_t line[3] = {s.at[0][i], s.at[1][i], s.at[2][i]};
  std::uint64_t n_subtiles = 0;
  for (int row = s.first_y[i] >> 2; row <= s.last_y[i] >> 2; ++row) {
    // Samples of this line, and the columns between which they are.
    std::uint32_t coverage[kMostColumns];
    std::int32_t at[3] = {line[0], line[1], line[2]};
    int first = n_columns, last = -1;
    for (int column = 0; column < n_columns; ++column) {
      coverage[column] = CoverageOf(at, lanes);
      if (coverage[column] != 0) first = std::min(first, column), last = column;
      for (int k = 0; k < 3; ++k) at[k] += 8 * s.right[k][i];
    }
    for (int k = 0; k < 3; ++k) line[k] += 4 * s.down[k][i];
    if (last < 0) continue;
    const int first_x = 8 * (begin_column + first) + std::countr_zero(ColumnsOf(coverage[first]));
    const int last_x = 8 * (begin_column + last) + 31 - std::countl_zero(ColumnsOf(coverage[last]));
    const glm::ivec2 rows(std::max(4 * row, s.first_y[i]), std::min(4 * row + 3, s.last_y[i]));
    for (int column = first; column <= last; ++column) {
      if (coverage[column] == 0) continue;
      const int x = 8 * (begin_column + column);
      buffer.add({begin_column + column, row}, coverage[column],
                 s.planes.farthest_in(i, {std::max(x, first_x), rows.x}, {std::min(x + 7, last_x), rows.y}));
      ++n_subtiles;
    }
  }
  return n_subtiles;
}

void DrawCluster(const ClusterJob& job, MaskedDepth& buffer, OccluderWork& work) {
  const glm::ivec2 end_px = buffer.n_subtiles() * glm::ivec2(kSubtileWidth_px, kSubtileHeight_px);
  Triangles list;
  Others others;
  Sift(job, end_px, list, others);
  work.triangles += std::uint64_t(job.n_triangles - others.n);
  int next_other = 0;
  const auto draw_others_before = [&](int triangle) {
    while (next_other < others.n && others.triangle[next_other] < triangle) {
      job.draw_other(job.context, others.triangle[next_other++]);
    }
  };
  SetUps set_ups;
  const int lanes = int(hn::Lanes(Ints()));
  for (int first = 0; first < list.n; first += lanes) {
    SetUp(job, list, first, end_px, set_ups);
    for (int i = 0; i < std::min(lanes, list.n - first); ++i) {
      draw_others_before(list.triangle[first + i]);
      const std::uint64_t n_subtiles = Walk(set_ups, i, buffer);
      work.drawn += n_subtiles > 0 ? 1 : 0;
      work.subtiles_written += n_subtiles;
    }
  }
  draw_others_before(job.n_triangles);
}

}  // namespace HWY_NAMESPACE
}  // namespace lode::techniques
HWY_AFTER_NAMESPACE();

#endif  // per-target include guard
