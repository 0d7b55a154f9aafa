#pragma once
/// One-pixel lines by the diamond-exit rule (C11), as the OpenGL specification has it (4.6 core, sec. 14.5.1)
/// and Vulkan after it, with y down. A sample is covered if the segment from a to b meets the open diamond
/// |x − xs| + |y − ys| < ½ px around it, unless b lies in that diamond. Both ends are first moved by
/// (−ε, −ε²), which settles every tie. So the fragments of consecutive segments follow each other without a
/// gap, and none is drawn twice for two segments that share an end point.
///
/// The axis in which the segment is longer (x if neither is) is its major axis. Each column across the major
/// axis has at most one fragment, and the columns that have one are consecutive.

#include <algorithm>
#include <cstdint>
#include <glm/vec2.hpp>
#include <optional>

#include "raster/frame.h"
#include "raster/reference/clip.h"
#include "raster/reference/primitive.h"

namespace lode::raster::reference {

/// Fragment n of a segment (0 first, from a to b) is number `first_fragment` + n of its line or strip.
struct LineStipple {
  Stipple stipple;
  std::uint64_t first_fragment = 0;  ///< fragments of the strip's earlier segments, at pixel centres
};

/// A segment that has a length. The weights are its ends' weights of the primitive's own two vertices: not
/// (1, 0) and (0, 1) where the segment was clipped.
struct Line {
  glm::ivec2 a_fx8{0, 0}, b_fx8{0, 0};  ///< within the guard band
  double z_a = 0.0, z_b = 0.0;          ///< [0, 1]
  double w_a = 1.0, w_b = 1.0;          ///< > 0
  VertexWeights weights_a{1.0, 0.0, 0.0}, weights_b{0.0, 1.0, 0.0};
  std::optional<LineStipple> stipple;
};

/// Nothing if the ends fall together: such a segment has no fragments.
[[nodiscard]] std::optional<Line> make_line(const WindowVertex& a, const WindowVertex& b);

/// The diamond-exit rule for one sample, exact.
[[nodiscard]] bool exits_diamond(const Line& line, glm::ivec2 p_fx8);

/// Columns (pixels along the major axis, 0 is x and 1 is y) begin ≤ k < end: each has exactly one fragment,
/// no other has any.
struct LineColumns {
  int major = 0;
  bool forward = true;  ///< a to b goes to larger k
  int begin = 0, end = 0;
};
[[nodiscard]] LineColumns columns_of(const Line& line, glm::ivec2 sample_fx8);

/// The pixel of a column's fragment. Nothing outside columns_of(…).
[[nodiscard]] std::optional<glm::ivec2> fragment_in_column(const Line& line, int major, int column,
                                                           glm::ivec2 sample_fx8);

/// Fragments of the whole segment, whatever the window, stipple or depth; O(1).
[[nodiscard]] std::uint64_t fragment_count(const Line& line, glm::ivec2 sample_fx8);

/// Whether the stipple keeps fragment n: bit (n / factor) mod 16, lowest bit first.
[[nodiscard]] inline bool keeps_fragment(const LineStipple& s, std::uint64_t n) {
  const std::uint64_t bit = ((s.first_fragment + n) / std::uint64_t(s.stipple.factor)) & 15u;
  return ((s.stipple.pattern >> bit) & 1u) != 0;
}

[[nodiscard]] PixelBox bounds_px(const Line& line, glm::ivec2 sample_fx8);
[[nodiscard]] float depth_at(const Line& line, glm::ivec2 p_fx8);
[[nodiscard]] VertexWeights weights_at(const Line& line, glm::ivec2 p_fx8);
[[nodiscard]] Footprint footprint_at(const Line& line, const VertexUvs& uvs, glm::ivec2 p_fx8);

/// In order of growing column; O(columns in the window). The stipple counts fragments from a, inside the
/// window or not, so a window never moves its phase.
template <class Visit>
void for_each_covered(const Line& line, const PixelBox& window, glm::ivec2 sample_fx8, Visit visit) {
  const PixelBox box = intersect(bounds_px(line, sample_fx8), window);
  if (box.empty()) return;
  const LineColumns columns = columns_of(line, sample_fx8);
  const int minor = 1 - columns.major;
  const int begin = std::max(columns.begin, box.begin_px[columns.major]);
  const int end = std::min(columns.end, box.end_px[columns.major]);
  for (int k = begin; k < end; ++k) {
    const int n = columns.forward ? k - columns.begin : columns.end - 1 - k;
    if (line.stipple && !keeps_fragment(*line.stipple, std::uint64_t(n))) continue;
    const std::optional<glm::ivec2> pixel = fragment_in_column(line, columns.major, k, sample_fx8);
    if (pixel && (*pixel)[minor] >= box.begin_px[minor] && (*pixel)[minor] < box.end_px[minor]) visit(*pixel);
  }
}

}  // namespace lode::raster::reference
