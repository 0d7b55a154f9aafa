#pragma once
/// A triangle's samples in one line of subtiles, into the masked depth buffer.

#include <algorithm>
#include <array>
#include <cstdint>
#include <glm/vec2.hpp>

#include "techniques/masked_occlusion/depth_plane.h"
#include "techniques/masked_occlusion/masked_depth.h"

namespace lode::techniques {

/// Samples [first, last] of the four rows of a line of subtiles; none where last < first.
struct LineSpans {
  std::array<int, kSubtileHeight_px> first, last;
};

/// The samples in the subtile that begins at x, bit 8·y + x.
[[nodiscard]] inline std::uint32_t coverage_at(const LineSpans& spans, int x) {
  std::uint32_t coverage = 0;
  for (std::size_t k = 0; k < spans.first.size(); ++k) {
    const int first = std::max(spans.first[k] - x, 0), last = std::min(spans.last[k] - x, kSubtileWidth_px - 1);
    if (first <= last) coverage |= ((0xFFu >> (7 - last)) & (0xFFu << first)) << (8 * k);
  }
  return coverage;
}

/// Gives each subtile its part. Its depth is the plane's farthest over the rows given and the columns between the
/// line's first sample and its last.
///   rows      samples, first and last, of this line of subtiles
///   returns   subtiles that were given a part
inline std::uint64_t add_line(const LineSpans& spans, glm::ivec2 rows, const DepthPlane& plane, MaskedDepth& buffer) {
  constexpr int kFar = 1 << 30;
  int first = kFar, last = -kFar, all_first = -kFar, all_last = kFar;
  for (std::size_t k = 0; k < spans.first.size(); ++k) {
    const bool empty = spans.first[k] > spans.last[k];
    first = std::min(first, empty ? kFar : spans.first[k]);
    last = std::max(last, empty ? -kFar : spans.last[k]);
    all_first = std::max(all_first, empty ? kFar : spans.first[k]);
    all_last = std::min(all_last, spans.last[k]);
  }
  std::uint64_t n_subtiles = 0;
  for (int x = first & ~(kSubtileWidth_px - 1); x <= last; x += kSubtileWidth_px) {
    const int end = x + kSubtileWidth_px - 1;
    const std::uint32_t coverage = all_first <= x && end <= all_last ? ~0u : coverage_at(spans, x);
    if (coverage == 0) continue;
    const float farthest = plane.farthest_in({std::max(x, first), rows.x}, {std::min(end, last), rows.y});
    buffer.add({x / kSubtileWidth_px, rows.x / kSubtileHeight_px}, coverage, farthest);
    ++n_subtiles;
  }
  return n_subtiles;
}

}  // namespace lode::techniques
