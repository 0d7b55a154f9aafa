#include "techniques/masked_occlusion/draw_occluder.h"

#include <algorithm>

#include "raster/reference/assemble.h"

namespace lode::techniques {
namespace {

namespace reference = raster::reference;

/// Draws triangles of vertices that are on the screen already.
class TriangleDrawer {
 public:
  TriangleDrawer(raster::Cull cull, const reference::Viewport& viewport, MaskedDepth& buffer, OccluderWork& work)
      : cull_(cull), viewport_(viewport), buffer_(buffer), work_(work) {}

  void draw(const OccluderVertex& a, const OccluderVertex& b, const OccluderVertex& c) {
    ++work_.triangles;
    if ((a.outside & b.outside & c.outside) != 0) return;
    if ((a.outside | b.outside | c.outside) != 0) {
      const bool finite = a.outside != kNotANumber && b.outside != kNotANumber && c.outside != kNotANumber;
      return finite ? draw_clipped({a.clip, b.clip, c.clip}) : void();
    }
    const ScreenTriangle triangle = {{a.p_fx8, b.p_fx8, c.p_fx8}, {a.z, b.z, c.z}};
    const std::int64_t area = doubled_area(triangle);
    if (area == 0 || drops(area) || sample_box(triangle, buffer_.n_subtiles()).empty()) return;
    if (!turned_away({a.clip, b.clip, c.clip})) draw_part(triangle);
  }

 private:
  /// Whether the draw drops a triangle of this snapped area (y down: a front face's is negative).
  [[nodiscard]] bool drops(std::int64_t area) const { return reference::culled(cull_, area < 0 ? 1 : -1); }
  /// Or of these corners before the snap.
  [[nodiscard]] bool turned_away(const std::array<glm::dvec4, 3>& corners) const {
    return cull_ != raster::Cull::none && reference::culled(cull_, reference::facing_sign(corners));
  }
  void draw_part(const ScreenTriangle& triangle) {
    const std::uint64_t n_subtiles = draw_triangle(triangle, buffer_);
    work_.drawn += n_subtiles > 0 ? 1 : 0;
    work_.subtiles_written += n_subtiles;
  }
  void draw_clipped(const std::array<glm::dvec4, 3>& corners);

  raster::Cull cull_;
  const reference::Viewport& viewport_;
  MaskedDepth& buffer_;
  OccluderWork& work_;
};

/// As the renderer cuts: corners in canonical order, then the fan of what is left. Nothing if the snap turns pieces of
/// it over, where the outline's winding would have to decide.
void TriangleDrawer::draw_clipped(const std::array<glm::dvec4, 3>& corners) {
  if (turned_away(corners)) return;
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
    if (area != 0 && !drops(even ? area : -area)) pieces.push_back(piece);
  }
  if (largest > 0 && smallest < 0) return;
  for (const ScreenTriangle& piece : pieces) draw_part(piece);
}

}  // namespace

void OccluderDrawer::draw(const raster::Draw& draw, glm::ivec2 size_px, MaskedDepth& buffer, OccluderWork& work) {
  const auto& object = std::get<raster::ObjectVertices>(draw.vertices);
  const ToScreen to_screen(object.clip_from_object, size_px);
  TriangleDrawer triangles(draw.cull, to_screen.viewport(), buffer, work);
  if (draw.clusters != nullptr) {
    const raster::Clusters& clusters = *draw.clusters;
    for (const std::uint32_t k : walk_.worth_drawing(draw, size_px, buffer, work.subtiles_read)) {
      const raster::Cluster& cluster = clusters.clusters[k];
      vertices_.clear();
      for (std::size_t i = cluster.first_vertex; i < cluster.first_vertex + std::size_t(cluster.n_vertices); ++i) {
        vertices_.push_back(to_screen({clusters.x[i], clusters.y[i], clusters.z[i]}));
      }
      const std::uint8_t* corner = clusters.corners.data() + 3 * std::size_t(cluster.first_triangle);
      for (int t = 0; t < cluster.n_triangles; ++t, corner += 3) {
        triangles.draw(vertices_[corner[0]], vertices_[corner[1]], vertices_[corner[2]]);
      }
    }
    return;
  }
  vertices_.clear();
  for (const glm::vec3& p : object.positions) vertices_.push_back(to_screen(p));
  const std::size_t n_corners = draw.indices ? draw.indices->size() : vertices_.size();
  const auto vertex = [&](std::size_t i) -> const OccluderVertex& {
    return vertices_[draw.indices ? (*draw.indices)[i] : i];
  };
  for (std::size_t i = 0; i + 2 < n_corners; i += 3) triangles.draw(vertex(i), vertex(i + 1), vertex(i + 2));
}

}  // namespace lode::techniques
