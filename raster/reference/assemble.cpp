#include "raster/reference/assemble.h"

#include <algorithm>
#include <cmath>
#include <utility>

#include "raster/parallel.h"
#include "raster/validate.h"

namespace lode::raster::reference {
namespace {

/// One primitive's share of work is small; this many go to a worker at a time.
constexpr std::size_t kPrimitivesPerChunk = 2048;

std::uint32_t vertex_index(const Draw& draw, std::size_t k) {
  return draw.indices ? (*draw.indices)[k] : std::uint32_t(k);
}

PixelBox pixels_of(const Rect& rect) {  // the far corner must not overflow
  const auto end = [](int origin, int size) { return int(std::min<std::int64_t>(std::int64_t(origin) + size, 1 << 30)); };
  return {rect.origin_px, {end(rect.origin_px.x, rect.size_px.x), end(rect.origin_px.y, rect.size_px.y)}};
}

/// Pixels that any of the frame's samples may cover.
template <class T>
PixelBox bounds_over_samples(const T& shape, const Frame& frame) {
  if (frame.samples_fx8.size() == 1) return bounds_px(shape, frame.samples_fx8[0]);
  const PixelBox last = bounds_px(shape, {0, 0}), first = bounds_px(shape, {255, 255});
  return {first.begin_px, last.end_px};
}

/// Assembles primitives of one draw, in order, into `out`.
class DrawAssembler {
 public:
  DrawAssembler(const Frame& frame, std::uint32_t draw_index, glm::ivec2 target_size_px, AssemblyPart& out)
      : frame_(frame), draw_(frame.draws[draw_index]), draw_index_(draw_index), out_(out) {
    target_size_px_ = target_size_px;
    viewport_ = make_viewport(frame.viewport.value_or(Rect{{0, 0}, target_size_px}));
    limits_ = drawable_pixels(frame, draw_, target_size_px);
    window_ = std::get_if<WindowVertices>(&draw_.vertices);
  }

  void add(std::size_t primitive) {
    primitive_ = std::uint32_t(primitive);
    const auto corner = [&](std::size_t k) { return vertex_index(draw_, k); };
    switch (draw_.topology) {
      case Topology::triangles:
        return add_triangle({corner(3 * primitive), corner(3 * primitive + 1), corner(3 * primitive + 2)}, 0);
      case Topology::quads: {
        const std::uint32_t a = corner(4 * primitive), c = corner(4 * primitive + 2);
        add_triangle({a, corner(4 * primitive + 1), c}, 0);
        return add_triangle({a, c, corner(4 * primitive + 3)}, kMaxFan);
      }
      case Topology::lines: return add_line(corner(2 * primitive), corner(2 * primitive + 1));
      case Topology::line_strip: return add_line(corner(primitive), corner(primitive + 1));
      case Topology::points:
      case Topology::discs: return add_round(corner(primitive));
      case Topology::surfels: return add_surfel(corner(primitive));
    }
  }

 private:
  static constexpr std::uint32_t kMaxFan = 64;  // pieces of the second triangle of a quad are numbered from here

  template <class T>
  Shape stored(const T& shape) {
    return shape;
  }
  Shape stored(const Surfel& surfel) {
    Surfel& kept = out_.surfels.next();
    kept = surfel;
    return &kept;
  }

  template <class T>
  void push(const T& shape, std::uint32_t number, const std::array<std::uint32_t, 3>& vertices, int n_vertices,
            bool front_facing = true) {
    const Ids ids = {draw_.draw_id.value_or(draw_index_), draw_.primitive_id.value_or(primitive_)};
    const PixelBox bounds = intersect(bounds_over_samples(shape, frame_), limits_);
    ++out_.stats.pieces;
    if (bounds.empty()) return;
    out_.pieces.push_back({stored(shape), bounds, draw_index_, ids, number, vertices, n_vertices, front_facing,
                           primitive_});
  }

  [[nodiscard]] bool not_finite(const glm::dvec3& p) {
    if (!std::isnan(p.x) && !std::isnan(p.y) && !std::isnan(p.z)) return false;
    ++out_.stats.primitives_not_finite;
    return true;
  }

  void add_triangle(const std::array<std::uint32_t, 3>& vertices, std::uint32_t first_number) {
    ++out_.stats.primitives_in;
    if (window_) {
      std::array<WindowVertex, 3> corners;
      for (std::size_t i = 0; i < 3; ++i) {
        if (not_finite(window_->positions_px[vertices[i]])) return;
        corners[i] = window_vertex(window_->positions_px[vertices[i]]);
      }
      return add_whole_triangle(corners, vertices, first_number);
    }
    std::array<glm::dvec4, 3> corners;
    std::uint32_t any_outside = 0, all_outside = ~0u;
    for (std::size_t i = 0; i < 3; ++i) {
      corners[i] = clip_position(draw_.vertices, vertices[i]);
      if (has_nan(corners[i])) {
        ++out_.stats.primitives_not_finite;
        return;
      }
      const std::uint32_t outside = outside_planes(viewport_, corners[i]);
      any_outside |= outside;
      all_outside &= outside;
    }
    if (all_outside != 0) {
      ++out_.stats.primitives_outside;
    } else if (draw_.cull != Cull::none && culled(draw_.cull, facing_sign(corners))) {
      ++out_.stats.primitives_facing;
    } else if (any_outside == 0) {
      add_whole_triangle({window_vertex(viewport_, corners[0]), window_vertex(viewport_, corners[1]),
                          window_vertex(viewport_, corners[2])},
                         vertices, first_number);
    } else {
      add_clipped_triangle(corners, vertices, first_number);
    }
  }

  void add_whole_triangle(const std::array<WindowVertex, 3>& corners, const std::array<std::uint32_t, 3>& vertices,
                          std::uint32_t number) {
    std::array<int, 3> order;
    const std::optional<Triangle> triangle = make_triangle(corners, order);
    if (!triangle) {
      ++out_.stats.primitives_empty;
      return;
    }
    const bool front = doubled_area_fx16(corners[0].p_fx8, corners[1].p_fx8, corners[2].p_fx8) < 0;  // y down
    if (culled(draw_.cull, front ? 1 : -1)) {
      ++out_.stats.primitives_facing;
      return;
    }
    push(*triangle, number,
         {vertices[std::size_t(order[0])], vertices[std::size_t(order[1])], vertices[std::size_t(order[2])]}, 3, front);
  }

  void add_clipped_triangle(const std::array<glm::dvec4, 3>& corners, const std::array<std::uint32_t, 3>& vertices,
                            std::uint32_t first_number) {
    // Canonical corners first, so that neither the cut polygon nor its weights depend on how the corners rotate.
    std::array<std::size_t, 3> order = {0, 1, 2};
    std::sort(order.begin(), order.end(), [&](std::size_t i, std::size_t j) {
      return canonically_before(corners[i], corners[j]) || (!canonically_before(corners[j], corners[i]) && i < j);
    });
    const bool even = (order[0] + 1) % 3 == order[1];
    const std::array<std::uint32_t, 3> sorted = {vertices[order[0]], vertices[order[1]], vertices[order[2]]};
    const ClipPolygon cut = clip_triangle(viewport_, {corners[order[0]], corners[order[1]], corners[order[2]]});
    if (cut.n == 0) {
      ++out_.stats.primitives_outside;
      return;
    }
    ++out_.stats.primitives_clipped;
    ClippedPolygon* polygon = &out_.polygons.next();
    polygon->vertices.clear();
    polygon->weights.clear();
    for (int i = 0; i < cut.n; ++i) {
      polygon->vertices.push_back(window_vertex(viewport_, cut.vertices[std::size_t(i)].position));
      polygon->weights.push_back(cut.vertices[std::size_t(i)].weights);
    }
    const auto& v = polygon->vertices;
    std::int64_t largest = 0, smallest = 0;
    for (std::size_t i = 0; i + 2 < v.size(); ++i) {
      const std::int64_t area = doubled_area_fx16(v[0].p_fx8, v[i + 1].p_fx8, v[i + 2].p_fx8);
      largest = std::max(largest, area);
      smallest = std::min(smallest, area);
    }
    polygon->has_turned_piece = largest > 0 && smallest < 0;
    if (largest == 0 && smallest == 0) {
      ++out_.stats.primitives_empty;
      return;
    }
    bool kept = false;
    for (std::size_t i = 0; i + 2 < v.size(); ++i) {
      std::array<int, 3> turn;
      std::optional<Triangle> t = make_triangle({v[0], v[i + 1], v[i + 2]}, turn);
      if (!t) continue;
      const bool front = (doubled_area_fx16(v[0].p_fx8, v[i + 1].p_fx8, v[i + 2].p_fx8) < 0) == even;  // y down
      if (culled(draw_.cull, front ? 1 : -1)) continue;
      kept = true;
      const std::array<int, 3> fan = {0, int(i) + 1, int(i) + 2};
      for (std::size_t k = 0; k < 3; ++k) t->polygon_vertex[k] = fan[std::size_t(turn[k])];
      t->polygon = polygon;
      t->piece = int(i);
      push(*t, first_number + std::uint32_t(i), sorted, 3, front);
    }
    if (!kept) ++out_.stats.primitives_facing;
  }

  void add_line(std::uint32_t a, std::uint32_t b) {
    ++out_.stats.primitives_in;
    std::optional<Line> line;
    if (window_) {
      const glm::dvec3 &p_a = window_->positions_px[a], &p_b = window_->positions_px[b];
      if (not_finite(p_a) || not_finite(p_b)) return;
      line = make_line(window_vertex(p_a), window_vertex(p_b));
    } else {
      const glm::dvec4 p_a = clip_position(draw_.vertices, a), p_b = clip_position(draw_.vertices, b);
      if (has_nan(p_a) || has_nan(p_b)) {
        ++out_.stats.primitives_not_finite;
        return;
      }
      const ClipPolygon cut = clip_segment(viewport_, p_a, p_b);
      if (cut.n == 0) {
        ++out_.stats.primitives_outside;
        return;
      }
      const ClipVertex &end_a = cut.vertices[0], &end_b = cut.vertices[1];
      line = make_line(window_vertex(viewport_, end_a.position), window_vertex(viewport_, end_b.position));
      if (end_a.weights[0] != 1.0 || end_b.weights[1] != 1.0) ++out_.stats.primitives_clipped;
      if (line) {
        line->weights_a = end_a.weights;
        line->weights_b = end_b.weights;
      }
    }
    if (!line) {
      ++out_.stats.primitives_empty;
      return;
    }
    if (draw_.stipple) {
      line->stipple = LineStipple{*draw_.stipple, strip_fragments_};
      // At pixel centres, so that a sample's picture does not depend on which other samples the frame has.
      if (draw_.topology == Topology::line_strip) strip_fragments_ += fragment_count(*line, kCentreSample_fx8[0]);
    }
    push(*line, 0, {a, b, b}, 2);
  }

  void add_round(std::uint32_t i) {
    ++out_.stats.primitives_in;
    WindowVertex centre;
    if (window_) {
      if (not_finite(window_->positions_px[i])) return;
      centre = window_vertex(window_->positions_px[i]);
    } else {
      const glm::dvec4 p = clip_position(draw_.vertices, i);
      if (has_nan(p)) {
        ++out_.stats.primitives_not_finite;
        return;
      }
      if (outside_planes(viewport_, p) != 0) {
        ++out_.stats.primitives_outside;
        return;
      }
      centre = window_vertex(viewport_, p);
    }
    const auto push_if = [&](const auto& shape) {
      if (shape) {
        push(*shape, 0, {i, i, i}, 1);
      } else {
        ++out_.stats.primitives_empty;
      }
    };
    if (draw_.topology == Topology::points) {
      push_if(make_square(centre.p_fx8, draw_.point_size_px, centre.z));
    } else {
      push_if(make_disc(centre.p_fx8, draw_.radii[i], centre.z));
    }
  }

  void add_surfel(std::uint32_t i) {
    ++out_.stats.primitives_in;
    const auto& object = std::get<ObjectVertices>(draw_.vertices);
    if (has_nan(object.positions[i], draw_.normals[i])) {
      ++out_.stats.primitives_not_finite;
      return;
    }
    const Rect viewport = frame_.viewport.value_or(Rect{{0, 0}, target_size_px_});
    const std::optional<Surfel> surfel = make_surfel(object.positions[i], draw_.normals[i], draw_.radii[i],
                                                     object.clip_from_object, viewport.origin_px, viewport.size_px);
    if (!surfel) {
      ++out_.stats.primitives_empty;
      return;
    }
    push(*surfel, 0, {i, i, i}, 1);
  }

  const Frame& frame_;
  const Draw& draw_;
  std::uint32_t draw_index_;
  AssemblyPart& out_;
  Viewport viewport_;
  glm::ivec2 target_size_px_{0, 0};
  PixelBox limits_;
  const WindowVertices* window_ = nullptr;
  std::uint32_t primitive_ = 0;
  std::uint64_t strip_fragments_ = 0;
};

}  // namespace

int facing_sign(const std::array<glm::dvec4, 3>& corners) {
  std::array<const glm::dvec4*, 3> p = {&corners[0], &corners[1], &corners[2]};
  int parity = 1;
  const auto sort_pair = [&](std::size_t i, std::size_t j) {
    if (!canonically_before(*p[j], *p[i])) return;
    std::swap(p[i], p[j]);
    parity = -parity;
  };
  sort_pair(0, 1);
  sort_pair(1, 2);
  sort_pair(0, 1);
  const glm::dvec4 &a = *p[0], &b = *p[1], &c = *p[2];
  const double det = (a.x * (b.y * c.w - c.y * b.w) - a.y * (b.x * c.w - c.x * b.w)) + a.w * (b.x * c.y - c.x * b.y);
  return det > 0.0 ? parity : (det < 0.0 ? -parity : 0);
}

PixelBox drawable_pixels(const Frame& frame, const Draw& draw, glm::ivec2 target_size_px) {
  PixelBox limits = {{0, 0}, target_size_px};
  if (frame.scissor) limits = intersect(limits, pixels_of(*frame.scissor));
  if (draw.scissor) limits = intersect(limits, pixels_of(*draw.scissor));
  return limits;
}

bool culled(Cull cull, int sign) {
  return (cull == Cull::back && sign <= 0) || (cull == Cull::front && sign >= 0);
}

Assembly assemble(const Frame& frame, glm::ivec2 target_size_px, int n_workers) {
  Assembly all;
  assemble(frame, target_size_px, {}, n_workers, all);
  return all;
}

void assemble(const Frame& frame, glm::ivec2 target_size_px, std::span<const Selection> selections, int n_workers,
              Assembly& all) {
  const auto selection = [&](std::size_t draw) { return selections.empty() ? Selection{} : selections[draw]; };
  all.pieces.clear();
  all.stats = {};
  std::size_t n_parts = 0;
  for (std::uint32_t d = 0; d < frame.draws.size(); ++d) {
    const Draw& draw = frame.draws[d];
    ++all.stats.draws_in;
    if (!draw.order_free()) ++all.stats.draws_ordered;
    const std::size_t n = selection(d).all ? primitive_count(draw) : selection(d).primitives.size();
    const bool counted = draw.stipple && draw.topology == Topology::line_strip;  // needs all segments before it
    const std::size_t step = counted ? std::max<std::size_t>(n, 1) : kPrimitivesPerChunk;
    for (std::size_t first = 0; first < n; first += step) {
      if (n_parts == all.parts.size()) all.parts.emplace_back();
      AssemblyPart& part = all.parts[n_parts++];
      part.draw = d, part.first = first, part.end = std::min(n, first + step);
    }
  }
  parallel_for(n_parts, n_workers, [&](std::size_t i, int) {
    AssemblyPart& part = all.parts[i];
    part.pieces.clear();
    part.polygons.clear();
    part.surfels.clear();
    part.stats = {};
    DrawAssembler assembler(frame, part.draw, target_size_px, part);
    const Selection wanted = selection(part.draw);
    for (std::size_t k = part.first; k < part.end; ++k) assembler.add(wanted.all ? k : wanted.primitives[k]);
  });
  std::size_t n_pieces = 0;
  for (std::size_t i = 0; i < n_parts; ++i) n_pieces += all.parts[i].pieces.size();
  all.pieces.reserve(n_pieces);
  for (std::size_t i = 0; i < n_parts; ++i) {  // in their order
    const AssemblyPart& part = all.parts[i];
    all.stats += part.stats;
    all.pieces.insert(all.pieces.end(), part.pieces.begin(), part.pieces.end());
  }
}

}  // namespace lode::raster::reference
