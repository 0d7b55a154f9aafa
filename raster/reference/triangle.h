#pragma once
/// Triangles: exact coverage (C2, C3), depth (C5) and perspective weights (C7). See primitive.h for the five
/// functions that every primitive has.
///
/// Edge function i is the doubled area of (sample, the two vertices other than i), in 1/256² px², an exact
/// integer of at most 2^48, made positive inside. With y down and positive area, an edge that goes up is a
/// left edge and one that goes right is a top edge: samples on those are inside, on others they are not.

#include <array>
#include <cstdint>
#include <vector>

#include "raster/reference/clip.h"
#include "raster/reference/primitive.h"

namespace lode::raster::reference {

/// The outline of a primitive that was clipped, after the snap. Its pieces are the fan (0, i+1, i+2). The snap
/// can turn a piece over; then a sample may lie in several pieces. The outline's winding number there, the
/// pieces counted with their signs, is what the neighbours' add up with: +1 or −1 is covered once, by the first
/// piece of that sign, and 0 is not covered.
struct ClippedPolygon {
  std::vector<WindowVertex> vertices;
  std::vector<VertexWeights> weights;  ///< of the primitive's own vertices, for each polygon vertex
  bool has_turned_piece = false;
};

struct Triangle {
  std::array<WindowVertex, 3> v;  ///< canonical order: by x, then y
  double sign = 1.0;              ///< +1 or −1: turns edge functions positive inside
  bool affine = true;             ///< the three w are bitwise equal
  const ClippedPolygon* polygon = nullptr;        ///< of clipped primitives: the assembly's
  std::array<int, 3> polygon_vertex{0, 1, 2};     ///< v[i]'s place in it
  int piece = 0;
};

/// Doubled area of (a, b, c): positive if clockwise as seen on screen (y down).
[[nodiscard]] inline std::int64_t doubled_area_fx16(glm::ivec2 a, glm::ivec2 b, glm::ivec2 c) {
  return std::int64_t(b.x - a.x) * (c.y - a.y) - std::int64_t(b.y - a.y) * (c.x - a.x);
}

/// Brings corners into canonical order; nothing for zero area. `order[i]` is the corner that became v[i].
[[nodiscard]] std::optional<Triangle> make_triangle(const std::array<WindowVertex, 3>& corners,
                                                    std::array<int, 3>& order);

[[nodiscard]] PixelBox bounds_px(const Triangle& t, glm::ivec2 sample_fx8);
[[nodiscard]] float depth_at(const Triangle& t, glm::ivec2 p_fx8);
[[nodiscard]] VertexWeights weights_at(const Triangle& t, glm::ivec2 p_fx8);
/// Texture coordinates of the triangle's own corners: those of a clipped polygon lie between its primitive's.
[[nodiscard]] std::array<glm::dvec2, 3> corner_uvs(const Triangle& t, const std::array<glm::vec2, 3>& uvs);
[[nodiscard]] Footprint footprint_at(const Triangle& t, const VertexUvs& uvs, glm::ivec2 p_fx8);

/// One directed edge a→b of a triangle whose doubled area is positive in the order it is walked.
struct EdgeFunction {
  std::int64_t dx = 0, dy = 0, c = 0;  ///< E(p) = dx · p.y − dy · p.x + c
  std::int64_t bias = 0;               ///< 0 on top and left edges, otherwise 1: inside is E ≥ bias

  [[nodiscard]] std::int64_t at(glm::ivec2 p_fx8) const { return dx * p_fx8.y - dy * p_fx8.x + c; }
};
[[nodiscard]] inline EdgeFunction make_edge(glm::ivec2 a, glm::ivec2 b) {
  const std::int64_t dx = b.x - a.x, dy = b.y - a.y;
  const bool left = dy < 0, top = dy == 0 && dx > 0;
  return {dx, dy, dy * a.x - dx * a.y, left || top ? 0 : 1};
}

/// Edge functions 0, 1, 2 of the triangle, each opposite its vertex, all positive inside.
[[nodiscard]] inline std::array<EdgeFunction, 3> edges_of(const Triangle& t) {
  const glm::ivec2 p0 = t.v[0].p_fx8, p1 = t.v[1].p_fx8, p2 = t.v[2].p_fx8;
  if (t.sign > 0.0) return {make_edge(p1, p2), make_edge(p2, p0), make_edge(p0, p1)};
  return {make_edge(p2, p1), make_edge(p0, p2), make_edge(p1, p0)};
}

/// For pieces of a polygon with a turned piece: whether this piece is the one that covers the sample.
[[nodiscard]] bool owns_sample(const ClippedPolygon& polygon, int piece, glm::ivec2 p_fx8);

template <class Visit>
void for_each_covered(const Triangle& t, const PixelBox& window, glm::ivec2 sample_fx8, Visit visit) {
  const PixelBox box = intersect(bounds_px(t, sample_fx8), window);
  if (box.empty()) return;
  const std::array<EdgeFunction, 3> edges = edges_of(t);
  const bool shared = t.polygon && t.polygon->has_turned_piece;
  for (int y = box.begin_px.y; y < box.end_px.y; ++y) {
    const glm::ivec2 p = sample_position_fx8({box.begin_px.x, y}, sample_fx8);
    std::int64_t e0 = edges[0].at(p) - edges[0].bias;
    std::int64_t e1 = edges[1].at(p) - edges[1].bias;
    std::int64_t e2 = edges[2].at(p) - edges[2].bias;
    for (int x = box.begin_px.x; x < box.end_px.x; ++x) {
      if ((e0 | e1 | e2) >= 0) {  // none has its sign bit set
        if (!shared || owns_sample(*t.polygon, t.piece, sample_position_fx8({x, y}, sample_fx8))) {
          visit(glm::ivec2{x, y});
        }
      }
      e0 -= edges[0].dy * 256;
      e1 -= edges[1].dy * 256;
      e2 -= edges[2].dy * 256;
    }
  }
}

}  // namespace lode::raster::reference
