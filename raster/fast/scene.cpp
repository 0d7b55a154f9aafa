#include "raster/fast/scene.h"

#include <algorithm>
#include <cmath>

#include "raster/blend.h"
#include "raster/error.h"

namespace lode::raster::fast {
namespace {

constexpr std::size_t kWorthClusters = 256;  ///< triangles of a draw without clusters that are worth making some

std::size_t triangle_count(const Draw& draw) {
  const auto& positions = std::get<ObjectVertices>(draw.vertices).positions;
  return (draw.indices ? draw.indices->size() : positions.size()) / 3;
}

bool is_fast(const Draw& draw) {
  return drawn_by_clusters(draw) && (draw.clusters != nullptr || triangle_count(draw) >= kWorthClusters);
}

/// The eye: det(x, y, w) of three corners is linear in the plane through them (Cauchy & Binet), so its coefficients are
/// the determinants of the matrix's rows x, y, w without one column.
void set_eye(DrawView& view) {
  const auto minor = [&](std::size_t without) {
    std::array<std::array<double, 3>, 3> m;
    for (std::size_t r = 0; r < 3; ++r) {
      const std::size_t row = r == 2 ? 3 : r;
      std::size_t to = 0;
      for (std::size_t c = 0; c < 4; ++c) {
        if (c != without) m[r][to++] = view.clip_from_object[4 * row + c];
      }
    }
    return (m[0][0] * (m[1][1] * m[2][2] - m[1][2] * m[2][1]) - m[0][1] * (m[1][0] * m[2][2] - m[1][2] * m[2][0])) +
           m[0][2] * (m[1][0] * m[2][1] - m[1][1] * m[2][0]);
  };
  view.eye = {minor(0), -minor(1), minor(2)};
  view.eye_w = -minor(3);
}

/// Whether products of three of the elements, times an object's coordinates, are far from overflow and underflow.
bool is_moderate(const std::array<double, 16>& m) {
  return std::all_of(m.begin(), m.end(),
                     [](double v) { return v == 0.0 || (std::fabs(v) >= 0x1p-150 && std::fabs(v) <= 0x1p150); });
}

DrawView make_view(const Frame& frame, const Draw& draw, glm::ivec2 target_size_px) {
  DrawView view;
  const glm::dmat4& m = std::get<ObjectVertices>(draw.vertices).clip_from_object;
  for (int row = 0; row < 4; ++row) {
    for (int column = 0; column < 4; ++column) view.clip_from_object[std::size_t(4 * row + column)] = m[column][row];
  }
  const reference::Viewport viewport = reference::make_viewport(frame.viewport.value_or(Rect{{0, 0}, target_size_px}));
  view.centre_fx8 = viewport.centre_fx8;
  view.half_fx8 = viewport.half_fx8;
  view.cull = draw.cull;
  view.boxes_may_face = is_moderate(view.clip_from_object);
  set_eye(view);
  return view;
}

/// Those of a primitive that becomes a piece: of clustered draws no others are read.
void check_indices(const Draw& draw, std::uint32_t draw_index, std::uint32_t primitive) {
  const std::size_t n = std::get<ObjectVertices>(draw.vertices).positions.size();
  for (std::size_t k = 3 * std::size_t(primitive); draw.indices && k < 3 * std::size_t(primitive) + 3; ++k) {
    if ((*draw.indices)[k] >= n) {
      throw Error(ErrorKind::bad_input, "draw %u: index %zu is %u, expected below %zu", draw_index, k,
                  (*draw.indices)[k], n);
    }
  }
}

constexpr std::uint32_t kNotFinite = 1u << 31;  ///< beside the planes that a vertex is outside of

/// Sorts the triangles of a cluster that reaches beyond a clip plane: whole ones to the kernels, others to be cut, but
/// for those that one plane cuts off wholly.
void sort_unclean(const Frame& frame, FastDraw& fast, const reference::Viewport& viewport, std::uint32_t index) {
  const Clusters& all = *fast.clusters;
  const Cluster& cluster = all.clusters[index];
  const Draw& draw = frame.draws[fast.draw];
  std::array<reference::WindowVertex, kMaxClusterVertices> window;
  std::array<std::uint32_t, kMaxClusterVertices> outside;
  for (std::size_t i = 0; i < cluster.n_vertices; ++i) {
    const std::size_t at = cluster.first_vertex + i;
    const glm::dvec4 p = reference::clip_position(draw.vertices, all.vertices[at]);
    // The kernels do not know how infinite coordinates are read.
    const bool finite = std::isfinite(all.x[at]) && std::isfinite(all.y[at]) && std::isfinite(all.z[at]);
    outside[i] = finite && !reference::has_nan(p) ? reference::outside_planes(viewport, p) : kNotFinite;
    if (outside[i] == 0) window[i] = reference::window_vertex(viewport, p);
  }
  UncleanCluster unclean;
  unclean.cluster = index;
  unclean.nearest = 0.0f;
  glm::ivec2 low(reference::kGuard_fx8), high(-reference::kGuard_fx8);
  for (std::uint32_t t = 0; t < cluster.n_triangles; ++t) {
    const std::uint8_t* corners = &all.corners[3 * std::size_t(cluster.first_triangle + t)];
    const std::uint32_t a = outside[corners[0]], b = outside[corners[1]], c = outside[corners[2]];
    if ((a & b & c & ~kNotFinite) != 0) continue;
    if ((a | b | c) != 0) {
      check_indices(draw, fast.draw, all.primitives[cluster.first_triangle + t]);
      fast.cut.push_back(all.primitives[cluster.first_triangle + t]);
      continue;
    }
    unclean.wanted[t / 64] |= std::uint64_t(1) << (t % 64);
    for (int k = 0; k < 3; ++k) {
      const reference::WindowVertex& v = window[corners[k]];
      low = glm::min(low, v.p_fx8), high = glm::max(high, v.p_fx8);
      unclean.nearest = std::max(unclean.nearest, std::nextafter(float(v.z), 2.0f));
    }
  }
  // A pixel is covered if its sample, anywhere in it, is.
  unclean.pixels =
      intersect({{(low.x >> 8) - 1, (low.y >> 8) - 1}, {(high.x >> 8) + 1, (high.y >> 8) + 1}}, fast.limits);
  if ((unclean.wanted[0] | unclean.wanted[1]) != 0 && !unclean.pixels.empty()) fast.unclean.push_back(unclean);
}

void find_unclean(const Scene& scene, FastDraw& fast, const reference::Viewport& viewport, std::uint32_t g) {
  const ClusterGroup& group = fast.clusters->groups[g];
  std::array<BoxSight, ClusterGroup::kMost> sights;
  Skips skips;
  skips.facing = false;
  scene.kernels->look(fast.view, group, {{0, 0}, scene.size_px}, skips, sights.data());
  for (std::size_t i = 0; i < std::size_t(group.n); ++i) {
    if (sights[i].sight != Sight::unclean) continue;
    if (group.child[i] & ClusterGroup::kIsCluster) {
      sort_unclean(*scene.frame, fast, viewport, group.child[i] & ~ClusterGroup::kIsCluster);
    } else {
      find_unclean(scene, fast, viewport, group.child[i]);
    }
  }
}

/// Where the whole draw is.
void look_at_draw(const Scene& scene, FastDraw& fast) {
  fast.pixels = {};
  fast.nearest = 2.0f;
  if (fast.clusters->groups.empty()) return;
  ClusterGroup box{};
  for (int axis = 0; axis < 3; ++axis)
    box.low[axis][0] = fast.clusters->low[axis], box.high[axis][0] = fast.clusters->high[axis];
  box.n = 1;
  std::array<BoxSight, ClusterGroup::kMost> sights;
  Skips skips = scene.options->skips;
  skips.facing = false;
  scene.kernels->look(fast.view, box, {{0, 0}, scene.size_px}, skips, sights.data());
  if (sights[0].sight == Sight::outside) return;
  fast.pixels = fast.limits;
  if (sights[0].sight != Sight::clean) return;
  fast.nearest = sights[0].nearest;
  fast.pixels = intersect(sights[0].pixels, fast.limits);
}

void set_colors(const Draw& draw, ColorFormat format, FastDraw& fast) {
  const float full = format == ColorFormat::rgba8 ? 255.0f : 1.0f;
  const glm::vec4 color = draw.color.value_or(glm::vec4(full));
  fast.flat = !draw.texture && !draw.shader.function;
  fast.constant = fast.flat && draw.colors.empty();
  const glm::u8vec4 bytes = store_rgba8(color);
  fast.bytes = bytes.r | bytes.g << 8 | bytes.b << 16 | std::uint32_t(bytes.a) << 24;
  fast.scale = {1.0f, 1.0f, 1.0f, 1.0f};
  if (draw.color) fast.scale = {color.r / full, color.g / full, color.b / full, color.a / full};
  OwnersJob& job = fast.owners_job;
  job.corners = fast.clusters->corners.data();
  job.mesh_vertices = fast.clusters->vertices.data();
  job.colors = draw.colors.empty() ? nullptr : &draw.colors[0].x;
  job.normals = draw.normals.empty() ? nullptr : &draw.normals[0].x;
}

void add_draw(std::uint32_t d, ColorFormat format, int threads, Scene& scene) {
  const Draw& draw = scene.frame->draws[d];
  if (scene.n_fast == scene.fast.size()) scene.fast.emplace_back();
  FastDraw& fast = scene.fast[scene.n_fast++];
  fast.draw = d;
  fast.clusters = draw.clusters;
  if (!fast.clusters) {
    scene.made.push_back(make_clusters(std::get<ObjectVertices>(draw.vertices).positions, draw.indices, threads));
    fast.clusters = &scene.made.back();
  }
  fast.view = make_view(*scene.frame, draw, scene.size_px);
  fast.limits = reference::drawable_pixels(*scene.frame, draw, scene.size_px);
  fast.unclean.clear();
  fast.cut.clear();
  set_colors(draw, format, fast);
  ++scene.stats.draws_in;
  look_at_draw(scene, fast);
  if (fast.pixels.empty()) {
    ++scene.stats.draws_culled_frustum;
  } else {
    const auto viewport = reference::make_viewport(scene.frame->viewport.value_or(Rect{{0, 0}, scene.size_px}));
    find_unclean(scene, fast, viewport, 0);
  }
  scene.selections[d] = {false, fast.cut};
  scene.n_boxes += 1 + fast.clusters->groups.size() + fast.clusters->clusters.size();
}

/// For each row of tiles, the pieces whose bounds touch it.
void bin_rows(Scene& scene) {
  const auto n_rows = std::size_t((scene.size_px.y + kTile_px - 1) / kTile_px);
  scene.row_first.assign(n_rows + 1, 0);
  const auto for_each_row = [](const Piece& p, auto visit) {
    for (int r = p.bounds_px.begin_px.y / kTile_px; r <= (p.bounds_px.end_px.y - 1) / kTile_px; ++r)
      visit(std::size_t(r));
  };
  for (const Piece& p : scene.assembly.pieces) for_each_row(p, [&](std::size_t r) { ++scene.row_first[r + 1]; });
  for (std::size_t r = 0; r < n_rows; ++r) scene.row_first[r + 1] += scene.row_first[r];
  scene.row_pieces.resize(scene.row_first[n_rows]);
  for (std::size_t i = 0; i < scene.assembly.pieces.size(); ++i) {
    for_each_row(scene.assembly.pieces[i],
                 [&](std::size_t r) { scene.row_pieces[scene.row_first[r]++] = std::uint32_t(i); });
  }
  for (std::size_t r = n_rows; r > 0; --r) scene.row_first[r] = scene.row_first[r - 1];
  scene.row_first[0] = 0;
}

}  // namespace

bool drawn_by_clusters(const Draw& draw) {
  return draw.topology == Topology::triangles && draw.order_free() && !draw.alpha_test &&
         std::holds_alternative<ObjectVertices>(draw.vertices);
}

bool drawn_by_kernels(const Piece& piece) {
  const auto* triangle = std::get_if<reference::Triangle>(&piece.shape);
  return triangle && !(triangle->polygon && triangle->polygon->has_turned_piece);
}

void make_scene(const Frame& frame, const Image& image, const RenderOptions& options, int threads, Scene& scene) {
  scene.frame = &frame;
  scene.options = &options;
  scene.kernels = find_kernels(options.target);
  scene.size_px = image.size_px;
  scene.n_fast = 0;
  scene.n_boxes = 0;
  scene.stats = {};
  scene.made.clear();
  scene.made.reserve(frame.draws.size());
  scene.surfaces.clear();
  for (const Draw& draw : frame.draws) scene.surfaces.push_back(make_surface(draw, image.format));
  scene.selections.assign(frame.draws.size(), {});
  bool any_pieces = false;
  for (std::uint32_t d = 0; d < frame.draws.size(); ++d) {
    if (is_fast(frame.draws[d])) {
      add_draw(d, image.format, threads, scene);
      any_pieces |= !scene.selections[d].primitives.empty();
    } else {
      any_pieces = true;
    }
  }
  scene.assembly.pieces.clear();
  if (any_pieces) {
    reference::assemble(frame, image.size_px, scene.selections, threads, scene.assembly);
    scene.stats = scene.assembly.stats;
  }
  for (std::size_t i = 0; i < scene.n_fast; ++i) {  // the pieces are counted already
    scene.stats.primitives_in += scene.fast[i].clusters->n_primitives - scene.fast[i].cut.size();
  }
  bin_rows(scene);
}

}  // namespace lode::raster::fast
