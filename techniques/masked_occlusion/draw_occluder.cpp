#include "techniques/masked_occlusion/draw_occluder.h"

#include <algorithm>
#include <cmath>

#include "raster/reference/assemble.h"

namespace lode::techniques {
namespace {

namespace reference = raster::reference;

/// Draws triangles of vertices that are on the screen already.
class TriangleDrawer {
 public:
  TriangleDrawer(raster::Cull cull, const reference::Viewport& viewport, const OccluderKernels& kernels,
                 MaskedDepth& buffer, OccluderWork& work)
      : cull_(cull), viewport_(viewport), kernels_(kernels), buffer_(buffer), work_(work) {}

  void draw(const OccluderVertex& a, const OccluderVertex& b, const OccluderVertex& c) {
    ++work_.triangles;
    if ((a.outside & b.outside & c.outside) != 0) return;
    if ((a.outside | b.outside | c.outside) != 0) {
      if (a.outside == kNotANumber || b.outside == kNotANumber || c.outside == kNotANumber) return;
      return draw_clipped({a.clip, b.clip, c.clip});
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
    const std::uint64_t n_subtiles = kernels_.draw_triangle(triangle, buffer_);
    work_.drawn += n_subtiles > 0 ? 1 : 0;
    work_.subtiles_written += n_subtiles;
  }
  void draw_clipped(const std::array<glm::dvec4, 3>& corners);

  raster::Cull cull_;
  const reference::Viewport& viewport_;
  const OccluderKernels& kernels_;
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

/// A cluster and how its points come to the screen: for those of its triangles that are drawn one by one.
struct OneCluster {
  const raster::Clusters& all;
  const raster::Cluster& cluster;
  const ToScreen& to_screen;
  TriangleDrawer& triangles;

  [[nodiscard]] OccluderVertex vertex(std::size_t k) const {
    const std::size_t i = cluster.first_vertex + k;
    return to_screen({all.x[i], all.y[i], all.z[i]});
  }
  [[nodiscard]] const std::uint8_t* corners() const {
    return all.corners.data() + 3 * std::size_t(cluster.first_triangle);
  }
  void draw(int triangle) const {
    const std::uint8_t* const c = corners() + 3 * std::size_t(triangle);
    triangles.draw(vertex(c[0]), vertex(c[1]), vertex(c[2]));
  }
};

/// Asks memory for a cluster that will be next.
void prefetch(const raster::Clusters& all, std::uint32_t k) {
  const auto ask = [](const auto* begin, std::size_t n) {
    const auto* bytes = reinterpret_cast<const char*>(begin);
    for (std::size_t i = 0; i < n * sizeof(*begin); i += 64) __builtin_prefetch(bytes + i);
  };
  const raster::Cluster& cluster = all.clusters[k];
  for (const auto* axis : {&all.x, &all.y, &all.z}) ask(axis->data() + cluster.first_vertex, cluster.n_vertices);
  ask(all.corners.data() + 3 * std::size_t(cluster.first_triangle), 3 * std::size_t(cluster.n_triangles));
}

/// The matrix as the renderer's kernels take it, and the viewport of the whole picture: all that a transform needs.
raster::fast::DrawView view_of(const glm::dmat4& clip_from_object, const reference::Viewport& viewport) {
  raster::fast::DrawView view;
  for (int row = 0; row < 4; ++row) {
    for (int column = 0; column < 4; ++column) {
      view.clip_from_object[std::size_t(4 * row + column)] = clip_from_object[column][row];
    }
  }
  view.centre_fx8 = viewport.centre_fx8;
  view.half_fx8 = viewport.half_fx8;
  return view;
}

/// Whether no sum of a finite point's products can be infinite or NaN.
bool is_moderate(const raster::fast::DrawView& view) {
  return std::all_of(view.clip_from_object.begin(), view.clip_from_object.end(),
                     [](double v) { return std::fabs(v) <= 0x1p500; });
}

}  // namespace

void OccluderDrawer::draw(const raster::Draw& draw, glm::ivec2 size_px, raster::Target target, MaskedDepth& buffer,
                          OccluderWork& work) {
  if (draw.clusters != nullptr) return draw_clusters(draw, size_px, target, buffer, work);
  const auto& object = std::get<raster::ObjectVertices>(draw.vertices);
  const ToScreen to_screen(object.clip_from_object, size_px);
  TriangleDrawer triangles(draw.cull, to_screen.viewport(), occluder_kernels(target), buffer, work);
  vertices_.clear();
  for (const glm::vec3& p : object.positions) vertices_.push_back(to_screen(p));
  const std::size_t n_corners = draw.indices ? draw.indices->size() : vertices_.size();
  const auto vertex = [&](std::size_t i) -> const OccluderVertex& {
    return vertices_[draw.indices ? (*draw.indices)[i] : i];
  };
  for (std::size_t i = 0; i + 2 < n_corners; i += 3) triangles.draw(vertex(i), vertex(i + 1), vertex(i + 2));
}

void OccluderDrawer::draw_clusters(const raster::Draw& draw, glm::ivec2 size_px, raster::Target target,
                                   MaskedDepth& buffer, OccluderWork& work) {
  const glm::dmat4& clip_from_object = std::get<raster::ObjectVertices>(draw.vertices).clip_from_object;
  const ToScreen to_screen(clip_from_object, size_px);
  const OccluderKernels& kernels = occluder_kernels(target);
  TriangleDrawer triangles(draw.cull, to_screen.viewport(), kernels, buffer, work);
  const raster::Clusters& all = *draw.clusters;
  const raster::fast::Kernels* const renderers = raster::fast::find_kernels(target);
  const raster::fast::DrawView view = view_of(clip_from_object, to_screen.viewport());
  raster::fast::WindowVertices128 window;
  const bool by_kernel = renderers != nullptr && is_moderate(view);
  const std::span<const std::uint32_t> wanted = walk_.worth_drawing(draw, size_px, buffer, work.subtiles_read);
  for (std::size_t next = 0; next < wanted.size(); ++next) {
    if (next + 1 < wanted.size()) prefetch(all, wanted[next + 1]);
    const raster::Cluster& cluster = all.clusters[wanted[next]];
    OneCluster one{all, cluster, to_screen, triangles};
    if (by_kernel) {
      const std::size_t first = cluster.first_vertex;
      renderers->transform(view, all.x.data() + first, all.y.data() + first, all.z.data() + first, cluster.n_vertices,
                           0, 0, &window);
      if (kernels.clean(window, cluster.n_vertices)) {
        kernels.draw_cluster({.corners = one.corners(),
                              .n_triangles = cluster.n_triangles,
                              .vertices = &window,
                              .cull = draw.cull,
                              .context = &one,
                              .draw_other = [](void* self, int t) { static_cast<const OneCluster*>(self)->draw(t); }},
                             buffer, work);
        continue;
      }
    }
    vertices_.clear();
    for (std::size_t i = 0; i < cluster.n_vertices; ++i) vertices_.push_back(one.vertex(i));
    const std::uint8_t* corner = one.corners();
    for (int t = 0; t < cluster.n_triangles; ++t, corner += 3) {
      triangles.draw(vertices_[corner[0]], vertices_[corner[1]], vertices_[corner[2]]);
    }
  }
}

}  // namespace lode::techniques
