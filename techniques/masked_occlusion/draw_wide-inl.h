// A triangle of any size into the masked depth buffer, eight rows of samples at a time.
// Compiled once for each instruction set (Highway's re-included headers).

#include <algorithm>
#include <cmath>
#include <cstdint>

#include "techniques/masked_occlusion/occluder_kernels.h"
#include "techniques/masked_occlusion/subtile_line.h"

#if defined(LODE_TECHNIQUES_DRAW_WIDE_INL_H_) == defined(HWY_TARGET_TOGGLE)
#ifdef LODE_TECHNIQUES_DRAW_WIDE_INL_H_
#undef LODE_TECHNIQUES_DRAW_WIDE_INL_H_
#else
#define LODE_TECHNIQUES_DRAW_WIDE_INL_H_
#endif

#include "raster/fast/lanes-inl.h"

HWY_BEFORE_NAMESPACE();
namespace lode::techniques {
namespace HWY_NAMESPACE {

namespace hn = hwy::HWY_NAMESPACE;

/// Where an edge a→b of a clockwise triangle cuts rows of samples: EdgeWalk of screen_triangle.cpp, which says why, as
/// whole numbers below 2^53 in doubles. In row k from the first the edge cuts at floor((n + k·step) / d).
struct RowEdge {
  bool left = false, right = false;  ///< neither: level, inside where n + k·step ≥ 0
  double n = 0.0, step = 0.0, d = 1.0, inverse = 1.0;

  RowEdge(glm::ivec2 a, glm::ivec2 b, int first_row) {
    const std::int64_t dx = b.x - a.x, dy = b.y - a.y, y_fx8 = 256 * std::int64_t(first_row) + 128;
    const std::int64_t bias = dy < 0 || (dy == 0 && dx > 0) ? 0 : 1;
    const std::int64_t row = dx * (y_fx8 - a.y) + dy * a.x;
    left = dy<0, right = dy> 0;
    if (!left && !right) {
      n = double(row - bias), step = double(256 * dx);
      return;
    }
    const std::int64_t whole = 256 * std::abs(dy);
    n = double(left ? bias - row + 128 * dy + (whole - 1) : row - bias - 128 * dy);
    step = double(left ? -256 * dx : 256 * dx);
    d = double(whole), inverse = 1.0 / d;
  }
};

/// floor(n / d) of whole numbers, |n| < 2^52: the product with 1 / d is off by one at most, and so shows the rest.
HWY_INLINE hn::Vec<raster::fast::HWY_NAMESPACE::Doubles> FloorOfQuotient(
    hn::Vec<raster::fast::HWY_NAMESPACE::Doubles> n, const RowEdge& edge) {
  const raster::fast::HWY_NAMESPACE::Doubles d;
  const auto one = hn::Set(d, 1.0), whole = hn::Set(d, edge.d);
  const auto q = hn::Floor(hn::Mul(n, hn::Set(d, edge.inverse)));
  const auto rest = hn::Sub(n, hn::Mul(q, whole));
  const auto less = hn::IfThenElseZero(hn::Lt(rest, hn::Zero(d)), one);
  const auto more = hn::IfThenElseZero(hn::Not(hn::Lt(rest, whole)), one);
  return hn::Add(hn::Sub(q, less), more);
}

std::uint64_t DrawTriangle(const ScreenTriangle& t, MaskedDepth& buffer) {
  constexpr int kRows = 8;
  const raster::fast::HWY_NAMESPACE::Doubles d;
  const raster::fast::HWY_NAMESPACE::HalfInts di;
  const SampleBox box = sample_box(t, buffer.n_subtiles());
  const std::int64_t area = doubled_area(t);
  if (box.empty() || area == 0) return 0;
  const glm::ivec2 p0 = t.p_fx8[0], p1 = t.p_fx8[area > 0 ? 1 : 2], p2 = t.p_fx8[area > 0 ? 2 : 1];
  const int begin = box.first.y & ~(kSubtileHeight_px - 1);
  const RowEdge edges[3] = {{p0, p1, begin}, {p1, p2, begin}, {p2, p0, begin}};
  const DepthPlane plane(t, double(area));
  std::uint64_t n_subtiles = 0;
  for (int chunk = begin; chunk <= box.last.y; chunk += kRows) {
    alignas(64) std::int32_t first[kRows], last[kRows];
    for (int k = 0; k < kRows; k += int(hn::Lanes(d))) {
      const auto row = hn::Add(hn::Iota(d, 0), hn::Set(d, double(chunk - begin + k)));
      auto low = hn::Set(d, double(box.first.x)), high = hn::Set(d, double(box.last.x));
      for (const RowEdge& edge : edges) {
        const auto n = hn::Add(hn::Set(d, edge.n), hn::Mul(row, hn::Set(d, edge.step)));
        if (edge.left) {
          low = hn::Max(low, FloorOfQuotient(n, edge));
        } else if (edge.right) {
          high = hn::Min(high, FloorOfQuotient(n, edge));
        } else {
          high = hn::IfThenElse(hn::Lt(n, hn::Zero(d)), hn::Set(d, -1.0), high);
        }
      }
      hn::StoreU(hn::DemoteTo(di, hn::Min(low, hn::Set(d, 0x1p20))), di, first + k);
      hn::StoreU(hn::DemoteTo(di, hn::Max(high, hn::Set(d, -1.0))), di, last + k);
    }
    for (int line = 0; line < kRows && chunk + line <= box.last.y; line += kSubtileHeight_px) {
      LineSpans spans;
      std::copy_n(first + line, kSubtileHeight_px, spans.first.begin());
      std::copy_n(last + line, kSubtileHeight_px, spans.last.begin());
      const int y = chunk + line;
      const glm::ivec2 rows(std::max(y, box.first.y), std::min(y + kSubtileHeight_px - 1, box.last.y));
      n_subtiles += add_line(spans, rows, plane, buffer);
    }
  }
  return n_subtiles;
}

}  // namespace HWY_NAMESPACE
}  // namespace lode::techniques
HWY_AFTER_NAMESPACE();

#endif  // per-target include guard
