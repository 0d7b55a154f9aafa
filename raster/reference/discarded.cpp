#include "raster/reference/discarded.h"

#include <algorithm>
#include <cmath>

#include "raster/reference/assemble.h"
#include "raster/reference/clip.h"
#include "raster/validate.h"

namespace lode::raster::reference {
namespace {

using Corners = std::array<glm::dvec4, 3>;

constexpr std::uint32_t kNearPlanes = 1u | 2u, kFarPlane = 4u;  // bits of outside_planes

/// Depth z/w where the sample's ray meets the triangle in front of the eye, whether it is clipped there or not. The
/// sample (X, Y, 1) in the frame of the corners (x, y, w): inside where no coordinate is negative (Olano and Greer,
/// "Triangle scan conversion using 2D homogeneous coordinates", 1997). Rounded: near an edge it may err.
std::optional<double> unclipped_depth(const Corners& p, const Viewport& viewport, glm::ivec2 p_fx8) {
  const double x = (p_fx8.x - viewport.centre_fx8.x) / viewport.half_fx8.x;
  const double y = -(p_fx8.y - viewport.centre_fx8.y) / viewport.half_fx8.y;
  const auto determinant = [](const glm::dvec3& a, const glm::dvec3& b, const glm::dvec3& c) {
    return a.x * (b.y * c.z - b.z * c.y) - a.y * (b.x * c.z - b.z * c.x) + a.z * (b.x * c.y - b.y * c.x);
  };
  const auto xyw = [](const glm::dvec4& v) { return glm::dvec3(v.x, v.y, v.w); };
  const glm::dvec3 a = xyw(p[0]), b = xyw(p[1]), c = xyw(p[2]), s(x, y, 1.0);
  const double all = determinant(a, b, c);
  if (all == 0.0 || !std::isfinite(all)) return std::nullopt;
  const double b0 = determinant(s, b, c) / all, b1 = determinant(a, s, c) / all, b2 = determinant(a, b, s) / all;
  if (!(b0 >= 0.0 && b1 >= 0.0 && b2 >= 0.0)) return std::nullopt;
  return b0 * p[0].z + b1 * p[1].z + b2 * p[2].z;
}

class DiscardedFinder {
 public:
  DiscardedFinder(const Frame& frame, glm::ivec2 size_px, glm::ivec2 pixel, std::vector<ExplainedSample>& samples)
      : frame_(frame),
        viewport_(make_viewport(frame.viewport.value_or(Rect{{0, 0}, size_px}))),
        pixel_(pixel),
        samples_(samples) {}

  void look_at_draw(std::uint32_t draw_index) {
    draw_index_ = draw_index;
    const Draw& draw = frame_.draws[draw_index];
    const std::size_t n_triangles = draw.topology == Topology::triangles ? 1 : 2;
    if (draw.topology != Topology::triangles && draw.topology != Topology::quads) return;
    for (std::size_t k = 0; k < primitive_count(draw); ++k) {
      for (std::size_t half = 0; half < n_triangles; ++half) {
        const std::size_t first = (n_triangles + 2) * k;  // 3 or 4 corners a primitive
        look_at_triangle(draw, std::uint32_t(k), {first, first + 1 + half, first + 2 + half});
      }
    }
  }

 private:
  static std::uint32_t vertex(const Draw& draw, std::size_t k) {
    return draw.indices ? (*draw.indices)[k] : std::uint32_t(k);
  }

  void look_at_triangle(const Draw& draw, std::uint32_t primitive, const std::array<std::size_t, 3>& corners) {
    std::array<WindowVertex, 3> window;
    if (const auto* given = std::get_if<WindowVertices>(&draw.vertices)) {
      for (std::size_t i = 0; i < 3; ++i) {
        const glm::dvec3& p = given->positions_px[vertex(draw, corners[i])];
        if (std::isnan(p.x) || std::isnan(p.y) || std::isnan(p.z)) return;
        window[i] = window_vertex(p);
      }
      return add_if_empty(primitive, window);
    }
    Corners clip;
    std::uint32_t any_outside = 0, all_outside = ~0u;
    for (std::size_t i = 0; i < 3; ++i) {
      clip[i] = clip_position(draw.vertices, vertex(draw, corners[i]));
      if (has_nan(clip[i])) return;
      const std::uint32_t outside = outside_planes(viewport_, clip[i]);
      any_outside |= outside;
      all_outside &= outside;
    }
    if (any_outside == 0) {
      for (std::size_t i = 0; i < 3; ++i) window[i] = window_vertex(viewport_, clip[i]);
      add_if_empty(primitive, window);
    } else if ((any_outside & (kNearPlanes | kFarPlane)) != 0) {
      const bool facing = all_outside == 0 && draw.cull != Cull::none && culled(draw.cull, facing_sign(clip));
      if (!facing) add_if_clipped(primitive, clip);
    }
  }

  void add_if_empty(std::uint32_t primitive, const std::array<WindowVertex, 3>& v) {
    if (doubled_area_fx16(v[0].p_fx8, v[1].p_fx8, v[2].p_fx8) != 0) return;
    const glm::ivec2 low = glm::min(v[0].p_fx8, glm::min(v[1].p_fx8, v[2].p_fx8));
    const glm::ivec2 high = glm::max(v[0].p_fx8, glm::max(v[1].p_fx8, v[2].p_fx8));
    const glm::ivec2 begin = 256 * pixel_, end = begin + 255;
    if (low.x > end.x || low.y > end.y || high.x < begin.x || high.y < begin.y) return;
    for (ExplainedSample& sample : samples_) add(sample, primitive, Fate::empty);
  }

  void add_if_clipped(std::uint32_t primitive, const Corners& clip) {
    for (ExplainedSample& sample : samples_) {
      const std::optional<double> depth = unclipped_depth(clip, viewport_, sample.p_fx8);
      if (depth && *depth > 1.0) add(sample, primitive, Fate::near_clipped);
      if (depth && *depth < 0.0) add(sample, primitive, Fate::far_clipped);
    }
  }

  void add(ExplainedSample& sample, std::uint32_t primitive, Fate fate) const {
    const Draw& draw = frame_.draws[draw_index_];
    ExplainedPiece piece;
    piece.fate = fate;
    piece.draw = draw_index_;
    piece.primitive = primitive;
    piece.ids = {draw.draw_id.value_or(draw_index_), draw.primitive_id.value_or(primitive)};
    piece.topology = draw.topology;
    sample.pieces.push_back(piece);
  }

  const Frame& frame_;
  Viewport viewport_;
  glm::ivec2 pixel_;
  std::vector<ExplainedSample>& samples_;
  std::uint32_t draw_index_ = 0;
};

}  // namespace

void add_discarded(const Frame& frame, glm::ivec2 size_px, glm::ivec2 pixel, std::vector<ExplainedSample>& samples) {
  DiscardedFinder finder(frame, size_px, pixel, samples);
  for (std::uint32_t d = 0; d < frame.draws.size(); ++d) finder.look_at_draw(d);
}

}  // namespace lode::raster::reference
