#include "techniques/masked_occlusion/draw_occluder.h"

#include <algorithm>

#include "raster/reference/assemble.h"

namespace lode::techniques {
namespace {

namespace reference = raster::reference;

constexpr std::uint32_t kNotANumber = ~0u;

/// Whether the draw drops a triangle of this snapped area (y down: a front face's is negative).
bool drops(raster::Cull cull, std::int64_t area) { return reference::culled(cull, area < 0 ? 1 : -1); }

void draw_part(const ScreenTriangle& triangle, MaskedDepth& buffer, OccluderWork& work) {
  const std::uint64_t n_subtiles = draw_triangle(triangle, buffer);
  work.drawn += n_subtiles > 0 ? 1 : 0;
  work.subtiles += n_subtiles;
}

}  // namespace

void OccluderDrawer::draw(const raster::Draw& draw, glm::ivec2 size_px, MaskedDepth& buffer, OccluderWork& work) {
  viewport_ = reference::make_viewport({{0, 0}, size_px});
  cull_ = draw.cull;
  const std::span<const glm::vec3> positions = std::get<raster::ObjectVertices>(draw.vertices).positions;
  vertices_.resize(positions.size());
  for (std::size_t i = 0; i < positions.size(); ++i) {
    Vertex& v = vertices_[i];
    v.clip = reference::clip_position(draw.vertices, std::uint32_t(i));
    v.outside = reference::has_nan(v.clip) ? kNotANumber : reference::outside_planes(viewport_, v.clip);
    if (v.outside != 0) continue;
    const reference::WindowVertex window = reference::window_vertex(viewport_, v.clip);
    v.p_fx8 = window.p_fx8;
    v.z = window.z;
  }
  if (!draw.indices) {
    for (std::uint32_t i = 0; i + 2 < vertices_.size(); i += 3) draw_triangle(i, i + 1, i + 2, buffer, work);
    return;
  }
  const std::span<const std::uint32_t> corners = *draw.indices;
  for (std::size_t i = 0; i + 2 < corners.size(); i += 3) {
    draw_triangle(corners[i], corners[i + 1], corners[i + 2], buffer, work);
  }
}

void OccluderDrawer::draw_triangle(std::uint32_t i, std::uint32_t j, std::uint32_t k, MaskedDepth& buffer,
                                   OccluderWork& work) {
  ++work.triangles;
  const Vertex &a = vertices_[i], &b = vertices_[j], &c = vertices_[k];
  if ((a.outside & b.outside & c.outside) != 0) return;
  if ((a.outside | b.outside | c.outside) != 0) {
    if (a.outside != kNotANumber && b.outside != kNotANumber && c.outside != kNotANumber) {
      draw_clipped(a, b, c, buffer, work);
    }
    return;
  }
  const ScreenTriangle triangle = {{a.p_fx8, b.p_fx8, c.p_fx8}, {a.z, b.z, c.z}};
  const std::int64_t area = doubled_area(triangle);
  if (area == 0 || drops(cull_, area) || sample_box(triangle, buffer.n_subtiles()).empty()) return;
  if (cull_ != raster::Cull::none && reference::culled(cull_, reference::facing_sign({a.clip, b.clip, c.clip}))) return;
  draw_part(triangle, buffer, work);
}

/// As DrawAssembler::add_clipped_triangle: corners in canonical order, then the fan of what is left.
void OccluderDrawer::draw_clipped(const Vertex& a, const Vertex& b, const Vertex& c, MaskedDepth& buffer,
                                  OccluderWork& work) const {
  const std::array<glm::dvec4, 3> corners = {a.clip, b.clip, c.clip};
  if (cull_ != raster::Cull::none && reference::culled(cull_, reference::facing_sign(corners))) return;
  std::array<std::size_t, 3> order = {0, 1, 2};
  std::sort(order.begin(), order.end(), [&](std::size_t i, std::size_t j) {
    return reference::canonically_before(corners[i], corners[j]) ||
           (!reference::canonically_before(corners[j], corners[i]) && i < j);
  });
  const bool even = (order[0] + 1) % 3 == order[1];
  const reference::ClipPolygon cut =
      reference::clip_triangle(viewport_, {corners[order[0]], corners[order[1]], corners[order[2]]});

  std::vector<ScreenTriangle> pieces;
  std::int64_t largest = 0, smallest = 0;
  for (int i = 1; i + 1 < cut.n; ++i) {
    ScreenTriangle piece;
    const int fan[3] = {0, i, i + 1};
    for (std::size_t k = 0; k < 3; ++k) {
      const auto v = reference::window_vertex(viewport_, cut.vertices[std::size_t(fan[k])].position);
      piece.p_fx8[k] = v.p_fx8;
      piece.z[k] = v.z;
    }
    const std::int64_t area = doubled_area(piece);
    largest = std::max(largest, area);
    smallest = std::min(smallest, area);
    if (area != 0 && !drops(cull_, even ? area : -area)) pieces.push_back(piece);
  }
  if (largest > 0 && smallest < 0) return;  // the outline's winding would have to decide
  for (const ScreenTriangle& piece : pieces) draw_part(piece, buffer, work);
}

}  // namespace lode::techniques
