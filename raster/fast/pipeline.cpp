#include "raster/fast/pipeline.h"

#include <algorithm>
#include <array>
#include <bit>
#include <cstring>
#include <memory>
#include <optional>
#include <vector>

#include "raster/blend.h"
#include "raster/fast/kernels.h"
#include "raster/parallel.h"
#include "raster/reference/assemble.h"
#include "raster/reference/pipeline.h"
#include "raster/reference/shade.h"

namespace lode::raster::fast {
namespace {

using reference::Assembly;
using reference::Piece;
using reference::PixelBox;

constexpr std::uint32_t kPieceBit = 0x80000000u;
constexpr std::uint32_t kTrianglesPerResident = 128;

/// A draw that the kernels draw.
struct FastDraw {
  std::uint32_t draw = 0;
  const Clusters* clusters = nullptr;
  DrawView view;
  PixelBox limits;
  Projected root;
  bool flat = false;  ///< neither texture nor shader
  FlatJob flat_job;
  std::vector<std::uint32_t> unclean;  ///< triangles of clusters that may need clipping
};

bool is_fast(const Draw& draw) {
  return draw.topology == Topology::triangles && draw.order_free() && !draw.alpha_test &&
         std::holds_alternative<ObjectVertices>(draw.vertices) && !draw.stipple;
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
  return view;
}

struct Scene {
  const Frame& frame;
  std::vector<FastDraw> fast;
  std::vector<Clusters> made;  ///< for draws that brought none
  Assembly assembly;
  std::vector<std::size_t> row_first;
  std::vector<std::uint32_t> row_pieces;
  const Kernels* kernels;
};

/// A node or cluster waiting for its turn: the nearest first, then by draw and node.
struct Waiting {
  float nearest;
  std::uint32_t fast_draw;
  std::uint32_t node;
  friend bool operator<(const Waiting& a, const Waiting& b) {
    if (a.nearest != b.nearest) return a.nearest < b.nearest;
    if (a.fast_draw != b.fast_draw) return a.fast_draw > b.fast_draw;
    return a.node > b.node;
  }
};

struct Worker {
  TileBuffers tile;
  std::vector<Waiting> heap;
  std::vector<Resident> residents;
  std::vector<WindowVertices128> vertices;  ///< [residents + 1], reused
  std::vector<Ids> ids;
  std::vector<glm::u8vec4> rgba8;
  std::vector<glm::vec4> rgba32f;
  FrameStats stats;
  RasterCounts counts;
  std::uint64_t nodes_tested = 0, nodes_outside = 0, nodes_hidden = 0, clusters_drawn = 0, clusters_facing = 0;
};

class TileDrawer {
 public:
  TileDrawer(const Scene& scene, Worker& worker, Image& image, PixelBox box, std::size_t row)
      : scene_(scene), w_(worker), image_(image), box_(box), row_(row), format_(image.format) {
    size_ = box.end_px - box.begin_px;
    has_color_ = !image.rgba8.empty() || !image.rgba32f.empty();
  }

  void draw() {
    sample_fx8_ = scene_.frame.samples_fx8[0];
    clear();
    for (const std::uint32_t i : pieces()) {
      if (touches(i) && draw_of(i).order_free()) draw_order_free(i);
    }
    draw_clusters();
    resolve();
    for (const std::uint32_t i : pieces()) {
      if (touches(i) && !draw_of(i).order_free()) draw_ordered(i);
    }
    write();
  }

 private:
  [[nodiscard]] std::span<const std::uint32_t> pieces() const {
    return {scene_.row_pieces.data() + scene_.row_first[row_], scene_.row_first[row_ + 1] - scene_.row_first[row_]};
  }
  [[nodiscard]] const Piece& piece(std::uint32_t i) const { return scene_.assembly.pieces[i]; }
  [[nodiscard]] const Draw& draw_of(std::uint32_t i) const { return scene_.frame.draws[piece(i).draw]; }
  [[nodiscard]] bool touches(std::uint32_t i) const { return !intersect(piece(i).bounds_px, box_).empty(); }
  [[nodiscard]] std::size_t place_of(glm::ivec2 px) const {
    return std::size_t(place_in_tile(px.x - box_.begin_px.x, px.y - box_.begin_px.y));
  }

  void clear() {
    std::fill_n(w_.tile.depth, kTilePixels, -1.0f);
    std::fill_n(w_.tile.owner, kTilePixels, kNoOwner);
    std::fill_n(w_.tile.block_min, kBlocksPerRow * kBlocksPerRow, -1.0f);
    std::fill_n(w_.tile.stale, kBlocksPerRow * kBlocksPerRow, std::uint8_t(0));
    // Places outside the picture must not keep a block from being covered.
    if (size_.x < kTile_px || size_.y < kTile_px) {
      for (int y = 0; y < kTile_px; ++y) {
        for (int x = y < size_.y ? size_.x : 0; x < kTile_px; ++x) w_.tile.depth[place_in_tile(x, y)] = 2.0f;
      }
    }
    w_.residents.clear();
  }

  // ---- Keys ----

  struct Key {
    std::uint32_t draw_id, primitive_id, number, draw;
    friend auto operator<=>(const Key&, const Key&) = default;
  };
  [[nodiscard]] Key key_of(std::uint32_t owner) const {
    if (owner & kPieceBit) {
      const Piece& p = piece(owner & ~kPieceBit);
      return {p.ids.draw, p.ids.primitive, p.number, p.draw};
    }
    const auto [fast, primitive] = triangle_of(owner);
    const Draw& draw = scene_.frame.draws[fast->draw];
    return {draw.draw_id.value_or(fast->draw), draw.primitive_id.value_or(primitive), 0, fast->draw};
  }
  struct TriangleRef {
    const FastDraw* fast;
    std::uint32_t primitive;
  };
  [[nodiscard]] TriangleRef triangle_of(std::uint32_t owner) const {
    const Resident& r = w_.residents[owner / kTrianglesPerResident];
    const FastDraw& fast = scene_.fast[r.fast_draw];
    const Cluster& cluster = fast.clusters->clusters[r.cluster];
    return {&fast, fast.clusters->primitives[cluster.first_triangle + owner % kTrianglesPerResident]};
  }
  static bool key_before(const void* self, std::uint32_t a, std::uint32_t b) {
    const auto* drawer = static_cast<const TileDrawer*>(self);
    return b == kNoOwner || drawer->key_of(a) < drawer->key_of(b);
  }
  static int facing_sign(const void* self, std::uint32_t triangle) {
    const auto* drawer = static_cast<const TileDrawer*>(self);
    const Resident& r = drawer->w_.residents.back();
    const FastDraw& fast = drawer->scene_.fast[r.fast_draw];
    const Cluster& cluster = fast.clusters->clusters[r.cluster];
    const Draw& draw = drawer->scene_.frame.draws[fast.draw];
    std::array<glm::dvec4, 3> corners;
    for (std::size_t k = 0; k < 3; ++k) {
      const std::uint8_t local = fast.clusters->corners[3 * (cluster.first_triangle + triangle) + k];
      corners[k] = reference::clip_position(draw.vertices, fast.clusters->vertices[cluster.first_vertex + local]);
    }
    return reference::facing_sign(corners);
  }

  // ---- Clusters, front to back ----

  void draw_clusters() {
    w_.heap.clear();
    for (std::uint32_t f = 0; f < scene_.fast.size(); ++f) {
      const FastDraw& fast = scene_.fast[f];
      if (fast.root.outside || fast.clusters->nodes.empty()) continue;
      add(f, 0, fast.root);
    }
    while (!w_.heap.empty()) {
      std::pop_heap(w_.heap.begin(), w_.heap.end());
      const Waiting next = w_.heap.back();
      w_.heap.pop_back();
      visit(next);
    }
  }

  /// Puts a node where it waits for its turn, unless the tile has nothing of it.
  void add(std::uint32_t f, std::uint32_t node, const Projected& p) {
    if (p.outside) {
      ++w_.nodes_outside;
      return;
    }
    float nearest = 2.0f;
    if (p.clean) {
      if (rect_in_tile(scene_.fast[f], p).empty()) {
        ++w_.nodes_outside;
        return;
      }
      nearest = p.nearest;
    }
    w_.heap.push_back({nearest, f, node});
    std::push_heap(w_.heap.begin(), w_.heap.end());
  }

  [[nodiscard]] PixelBox rect_in_tile(const FastDraw& fast, const Projected& p) const {
    const PixelBox rect = {{p.begin_x, p.begin_y}, {p.end_x, p.end_y}};
    return intersect(intersect(rect, fast.limits), box_);
  }

  void visit(const Waiting& next) {
    const FastDraw& fast = scene_.fast[next.fast_draw];
    const ClusterNode& node = fast.clusters->nodes[next.node];
    const Projected p = scene_.kernels->project(fast.view, node.low, node.high);
    ++w_.nodes_tested;
    if (!p.clean) {
      if (node.leaf) return;  // its triangles are pieces
      for (std::uint32_t c = 0; c < 2; ++c) add_child(next.fast_draw, node.first + c);
      return;
    }
    const PixelBox rect = rect_in_tile(fast, p);
    const glm::ivec2 begin = rect.begin_px - box_.begin_px, end = rect.end_px - box_.begin_px;
    if (p.nearest < scene_.kernels->least_depth(w_.tile, begin.x, begin.y, end.x, end.y)) {
      ++w_.nodes_hidden;
      return;
    }
    if (!node.leaf) {
      for (std::uint32_t c = 0; c < 2; ++c) add_child(next.fast_draw, node.first + c);
      return;
    }
    draw_cluster(next.fast_draw, node.first, begin, end);
  }

  void add_child(std::uint32_t f, std::uint32_t child) {
    const FastDraw& fast = scene_.fast[f];
    const ClusterNode& node = fast.clusters->nodes[child];
    add(f, child, scene_.kernels->project(fast.view, node.low, node.high));
  }

  void draw_cluster(std::uint32_t f, std::uint32_t c, glm::ivec2 begin, glm::ivec2 end) {
    const FastDraw& fast = scene_.fast[f];
    const Clusters& all = *fast.clusters;
    const Cluster& cluster = all.clusters[c];
    ++w_.clusters_drawn;
    const std::size_t slot = w_.residents.size();
    if (w_.vertices.size() <= slot) w_.vertices.resize(std::max<std::size_t>(64, 2 * slot));
    WindowVertices128& vertices = w_.vertices[slot];
    scene_.kernels->transform(fast.view, all.x.data() + cluster.first_vertex, all.y.data() + cluster.first_vertex,
                              all.z.data() + cluster.first_vertex, cluster.n_vertices, box_.begin_px.x * 256,
                              box_.begin_px.y * 256, &vertices);
    w_.residents.push_back({cluster.first_vertex, cluster.first_triangle, f, c});
    RasterJob job;
    job.corners = all.corners.data() + 3 * std::size_t(cluster.first_triangle);
    job.n_triangles = cluster.n_triangles;
    job.vertices = &vertices;
    job.cull = fast.view.cull;
    job.begin_x = begin.x, job.begin_y = begin.y, job.end_x = end.x, job.end_y = end.y;
    job.sample_x_fx8 = sample_fx8_.x, job.sample_y_fx8 = sample_fx8_.y;
    job.first_owner = std::uint32_t(slot) * kTrianglesPerResident;
    job.context = this;
    job.key_before = key_before;
    job.facing_sign = facing_sign;
    if (!scene_.kernels->rasterize(job, w_.tile, w_.counts)) w_.residents.pop_back();
  }

  // ---- Pieces, as the reference draws them ----

  template <class Visit>
  void for_each_fragment(const Piece& p, const Draw& draw, Visit visit) {
    const PixelBox window = intersect(p.bounds_px, box_);
    const auto fragment = [&](glm::ivec2 px) {
      ++w_.stats.fragments_covered;
      const float depth = reference::depth_of(p, reference::sample_position_fx8(px, sample_fx8_));
      glm::vec4 rgba;
      if (draw.alpha_test) {
        reference::shade(draw, p, format_, {{&px, 1}, {&depth, 1}, sample_fx8_}, &rgba, w_.stats);
        const double full = format_ == ColorFormat::rgba8 ? 255.0 : 1.0;
        if (!(double(rgba.a) / full >= *draw.alpha_test)) {
          ++w_.stats.fragments_alpha_failed;
          return;
        }
      }
      visit(place_of(px), px, depth, rgba);
    };
    reference::visit_shape(p.shape, [&](const auto& shape) { for_each_covered(shape, window, sample_fx8_, fragment); });
  }

  void draw_order_free(std::uint32_t index) {
    const Piece& p = piece(index);
    const std::uint32_t owner = index | kPieceBit;
    for_each_fragment(p, draw_of(index), [&](std::size_t i, glm::ivec2, float depth, const glm::vec4&) {
      const bool wins =
          depth > w_.tile.depth[i] || (depth == w_.tile.depth[i] && key_before(this, owner, w_.tile.owner[i]));
      if (!wins) {
        ++w_.stats.fragments_depth_failed;
        return;
      }
      w_.tile.depth[i] = depth;
      w_.tile.owner[i] = owner;
      w_.tile.stale[i / 64] = 1;
    });
  }

  void draw_ordered(std::uint32_t index) {
    const Piece& p = piece(index);
    const Draw& draw = draw_of(index);
    for_each_fragment(p, draw, [&](std::size_t i, glm::ivec2 px, float depth, glm::vec4& rgba) {
      if (draw.depth_test && w_.tile.owner[i] != kNoOwner && !(depth > w_.tile.depth[i])) {
        ++w_.stats.fragments_depth_failed;
        return;
      }
      if (has_color_) {
        if (!draw.alpha_test) reference::shade(draw, p, format_, {{&px, 1}, {&depth, 1}, sample_fx8_}, &rgba, w_.stats);
        store(i, rgba, draw.blend);
        if (draw.blend != Blend::none) ++w_.stats.fragments_blended;
      }
      if (draw.writes_depth()) {
        w_.tile.depth[i] = depth;
        w_.tile.owner[i] = index | kPieceBit;
        w_.ids[i] = p.ids;
      }
    });
  }

  void store(std::size_t i, const glm::vec4& rgba, Blend blend) {
    if (format_ == ColorFormat::rgba8) {
      w_.rgba8[i] = blend_rgba8(blend, store_rgba8(rgba), w_.rgba8[i]);
    } else {
      w_.rgba32f[i] = blend_rgba32f(blend, rgba, w_.rgba32f[i]);
    }
  }

  // ---- Shading, once a sample ----

  void resolve() {
    const glm::u8vec4 clear8 = store_rgba8(scene_.frame.clear);
    const glm::vec4 clear32 = store_rgba32f(scene_.frame.clear);
    for (int qy = 0; qy < size_.y; qy += 4) {
      for (int qx = 0; qx < size_.x; qx += 4) {
        const auto base = std::size_t(place_in_tile(qx, qy));
        std::uint32_t left = 0;  // samples in the picture that are not yet done
        for (std::uint32_t k = 0; k < 16; ++k) {
          if (qx + int(k & 3) < size_.x && qy + int(k >> 2) < size_.y) left |= 1u << k;
        }
        while (left != 0) left &= ~resolve_some(qx, qy, base, left, clear8, clear32);
      }
    }
  }

  /// Shades the first sample that is left and those that go with it; returns which.
  std::uint32_t resolve_some(int qx, int qy, std::size_t base, std::uint32_t left, glm::u8vec4 clear8,
                             const glm::vec4& clear32) {
    const std::uint32_t* owners = w_.tile.owner + base;
    const std::uint32_t owner = owners[std::countr_zero(left)];
    const auto select = [&](auto same) {
      std::uint32_t lanes = 0;
      for (std::uint32_t k = 0; k < 16; ++k) {
        if ((left >> k & 1) && same(owners[k])) lanes |= 1u << k;
      }
      return lanes;
    };
    const auto for_each = [](std::uint32_t lanes, auto visit) {
      for (; lanes != 0; lanes &= lanes - 1) visit(std::uint32_t(std::countr_zero(lanes)));
    };
    if (owner == kNoOwner) {
      const std::uint32_t lanes = select([](std::uint32_t o) { return o == kNoOwner; });
      for_each(lanes, [&](std::uint32_t k) {
        if (!image_.ids.empty()) w_.ids[base + k] = {kNoId, kNoId};
        if (!w_.rgba8.empty()) w_.rgba8[base + k] = clear8;
        if (!w_.rgba32f.empty()) w_.rgba32f[base + k] = clear32;
      });
      return lanes;
    }
    if (!(owner & kPieceBit)) {
      const std::uint32_t f = w_.residents[owner / kTrianglesPerResident].fast_draw;
      if (scene_.fast[f].flat || !has_color_) {
        const std::uint32_t lanes = select([&](std::uint32_t o) {
          return !(o & kPieceBit) && w_.residents[o / kTrianglesPerResident].fast_draw == f;
        });
        resolve_flat(scene_.fast[f], qx, qy, base, lanes, owner);
        if (!image_.ids.empty()) {
          const Draw& draw = scene_.frame.draws[scene_.fast[f].draw];
          for_each(lanes, [&](std::uint32_t k) {
            const Resident& r = w_.residents[owners[k] / kTrianglesPerResident];
            const std::uint32_t primitive =
                scene_.fast[f].clusters->primitives[r.first_triangle + owners[k] % kTrianglesPerResident];
            w_.ids[base + k] = {draw.draw_id.value_or(scene_.fast[f].draw), draw.primitive_id.value_or(primitive)};
          });
        }
        return lanes;
      }
    }
    const std::uint32_t lanes = select([&](std::uint32_t o) { return o == owner; });
    std::array<glm::ivec2, 16> pixels;
    std::array<float, 16> depths;
    std::array<glm::vec4, 16> rgba;
    std::size_t n = 0;
    for_each(lanes, [&](std::uint32_t k) {
      depths[n] = w_.tile.depth[base + k];
      pixels[n++] = box_.begin_px + glm::ivec2(qx + int(k & 3), qy + int(k >> 2));
    });
    Piece made;
    if (!(owner & kPieceBit)) make_piece(owner, made);
    const Piece& p = owner & kPieceBit ? piece(owner & ~kPieceBit) : made;
    if (has_color_) {
      reference::shade(scene_.frame.draws[p.draw], p, format_, {{pixels.data(), n}, {depths.data(), n}, sample_fx8_},
                       rgba.data(), w_.stats);
    }
    n = 0;
    for_each(lanes, [&](std::uint32_t k) {
      if (!image_.ids.empty()) w_.ids[base + k] = p.ids;
      if (has_color_) store(base + k, rgba[n++], Blend::none);
    });
    return lanes;
  }

  void resolve_flat(const FastDraw& fast, int qx, int qy, std::size_t base, std::uint32_t lanes,
                    std::uint32_t any_owner) {
    if (!has_color_) return;
    w_.stats.fragments_shaded += std::uint64_t(std::popcount(lanes));
    FlatJob job = fast.flat_job;
    job.residents = w_.residents.data();
    job.vertices = w_.vertices.data();
    job.x_fx8 = qx * 256 + sample_fx8_.x;
    job.y_fx8 = qy * 256 + sample_fx8_.y;
    std::array<std::uint32_t, 16> owners;
    for (std::uint32_t k = 0; k < 16; ++k) owners[k] = lanes >> k & 1 ? w_.tile.owner[base + k] : any_owner;
    alignas(64) std::array<float, 64> rgba;
    if (job.colors) {
      scene_.kernels->shade_flat(job, owners.data(), rgba.data());
    } else {
      for (std::size_t i = 0; i < 64; ++i) rgba[i] = job.color[i / 16];
    }
    if (!w_.rgba8.empty()) {
      std::array<std::uint32_t, 16> bytes;
      scene_.kernels->store_bytes(rgba.data(), bytes.data());
      for (std::uint32_t k = 0; k < 16; ++k) {
        if (lanes >> k & 1) std::memcpy(&w_.rgba8[base + k], &bytes[k], 4);
      }
    } else {
      for (std::uint32_t k = 0; k < 16; ++k) {
        if (lanes >> k & 1) w_.rgba32f[base + k] = store_rgba32f({rgba[k], rgba[16 + k], rgba[32 + k], rgba[48 + k]});
      }
    }
  }

  /// A kernel's triangle as the reference has it.
  void make_piece(std::uint32_t owner, Piece& p) const {
    const Resident& r = w_.residents[owner / kTrianglesPerResident];
    const FastDraw& fast = scene_.fast[r.fast_draw];
    const Clusters& all = *fast.clusters;
    const Cluster& cluster = all.clusters[r.cluster];
    const std::size_t t = cluster.first_triangle + owner % kTrianglesPerResident;
    const WindowVertices128& v = w_.vertices[owner / kTrianglesPerResident];
    std::array<reference::WindowVertex, 3> corners;
    std::array<std::uint32_t, 3> vertices;
    for (std::size_t k = 0; k < 3; ++k) {
      const std::uint8_t local = all.corners[3 * t + k];
      corners[k] = {
          {v.x_fx8[local] + box_.begin_px.x * 256, v.y_fx8[local] + box_.begin_px.y * 256}, v.z[local], v.w[local]};
      vertices[k] = all.vertices[cluster.first_vertex + local];
    }
    std::array<int, 3> order;
    const auto triangle = reference::make_triangle(corners, order);
    const Draw& draw = scene_.frame.draws[fast.draw];
    p.shape = *triangle;
    p.draw = fast.draw;
    p.ids = {draw.draw_id.value_or(fast.draw), draw.primitive_id.value_or(all.primitives[t])};
    for (std::size_t k = 0; k < 3; ++k) p.vertices[k] = vertices[std::size_t(order[k])];
    p.n_vertices = 3;
    p.front_facing = reference::doubled_area_fx16(corners[0].p_fx8, corners[1].p_fx8, corners[2].p_fx8) < 0;
  }

  void write() {
    for (int y = 0; y < size_.y; ++y) {
      const std::size_t row =
          std::size_t(box_.begin_px.y + y) * std::size_t(image_.size_px.x) + std::size_t(box_.begin_px.x);
      for (int x = 0; x < size_.x; x += 4) {  // four neighbours lie together
        const auto from = std::size_t(place_in_tile(x, y)), to = row + std::size_t(x);
        const auto n = std::size_t(std::min(4, size_.x - x));
        if (!image_.rgba8.empty()) copy(&image_.rgba8[to], &w_.rgba8[from], n);
        if (!image_.rgba32f.empty()) copy(&image_.rgba32f[to], &w_.rgba32f[from], n);
        if (!image_.ids.empty()) copy(&image_.ids[to], &w_.ids[from], n);
        if (image_.depth.empty()) continue;
        for (std::size_t i = 0; i < n; ++i) image_.depth[to + i] = std::max(w_.tile.depth[from + i], 0.0f);
      }
    }
  }

  template <class T>
  static void copy(T* to, const T* from, std::size_t n) {
    if (n == 4) {
      std::memcpy(static_cast<void*>(to), from, 4 * sizeof(T));
    } else {
      std::copy_n(from, n, to);
    }
  }

  const Scene& scene_;
  Worker& w_;
  Image& image_;
  PixelBox box_;
  std::size_t row_;
  ColorFormat format_;
  glm::ivec2 size_{0, 0};
  glm::ivec2 sample_fx8_{128, 128};
  bool has_color_ = false;
};

/// Triangles of clusters that may have to be clipped.
void collect_unclean(const Kernels& kernels, FastDraw& fast, std::uint32_t node_index) {
  const ClusterNode& node = fast.clusters->nodes[node_index];
  const Projected p = kernels.project(fast.view, node.low, node.high);
  if (p.outside || p.clean) return;
  if (!node.leaf) {
    collect_unclean(kernels, fast, node.first);
    collect_unclean(kernels, fast, node.first + 1);
    return;
  }
  const Cluster& cluster = fast.clusters->clusters[node.first];
  const auto first = fast.clusters->primitives.begin() + cluster.first_triangle;
  fast.unclean.insert(fast.unclean.end(), first, first + cluster.n_triangles);
}

}  // namespace

FrameStats render_fast(const Frame& frame, Image& image, const RenderOptions& options) {
  if (frame.samples_fx8.size() != 1 || !options.per_draw.empty() || options.ids_from_ordered_draws) {
    return reference::render_reference(frame, image, options);
  }
  const glm::ivec2 size = image.size_px;
  const std::size_t n_columns = std::size_t((size.x + kTile_px - 1) / kTile_px);
  const std::size_t n_rows = std::size_t((size.y + kTile_px - 1) / kTile_px);
  const int threads = worker_count(options.threads);

  Scene scene{frame, {}, {}, {}, {}, {}, find_kernels(options.target)};
  std::vector<reference::Selection> selections(frame.draws.size());
  scene.made.reserve(frame.draws.size());
  for (std::uint32_t d = 0; d < frame.draws.size(); ++d) {
    const Draw& draw = frame.draws[d];
    if (!is_fast(draw)) continue;
    FastDraw fast;
    fast.draw = d;
    fast.clusters = draw.clusters;
    if (!fast.clusters) {
      scene.made.push_back(make_clusters(std::get<ObjectVertices>(draw.vertices).positions, draw.indices, threads));
      fast.clusters = &scene.made.back();
    }
    fast.view = make_view(frame, draw, size);
    fast.limits = reference::drawable_pixels(frame, draw, size);
    fast.flat = !draw.texture && !draw.shader.function;
    fast.flat_job.corners = fast.clusters->corners.data();
    fast.flat_job.mesh_vertices = fast.clusters->vertices.data();
    fast.flat_job.colors = draw.colors.empty() ? nullptr : &draw.colors[0].x;
    fast.flat_job.has_color = draw.color.has_value();
    fast.flat_job.full = image.format == ColorFormat::rgba8 ? 255.0f : 1.0f;
    const glm::vec4 color = draw.color.value_or(glm::vec4(fast.flat_job.full));
    fast.flat_job.color = {color.r, color.g, color.b, color.a};
    if (!fast.clusters->nodes.empty()) {
      const ClusterNode& root = fast.clusters->nodes[0];
      fast.root = scene.kernels->project(fast.view, root.low, root.high);
      collect_unclean(*scene.kernels, fast, 0);
    }
    scene.fast.push_back(std::move(fast));
  }
  for (FastDraw& fast : scene.fast) selections[fast.draw] = {false, fast.unclean};
  scene.assembly = reference::assemble(frame, size, selections, threads);
  scene.row_first.assign(n_rows + 1, 0);
  const auto rows_of = [&](const Piece& p, auto visit) {
    for (int r = p.bounds_px.begin_px.y / kTile_px; r <= (p.bounds_px.end_px.y - 1) / kTile_px; ++r)
      visit(std::size_t(r));
  };
  for (const Piece& p : scene.assembly.pieces) rows_of(p, [&](std::size_t r) { ++scene.row_first[r + 1]; });
  for (std::size_t r = 0; r < n_rows; ++r) scene.row_first[r + 1] += scene.row_first[r];
  scene.row_pieces.resize(scene.row_first[n_rows]);
  std::vector<std::size_t> next(scene.row_first.begin(), scene.row_first.end() - 1);
  for (std::size_t i = 0; i < scene.assembly.pieces.size(); ++i) {
    rows_of(scene.assembly.pieces[i], [&](std::size_t r) { scene.row_pieces[next[r]++] = std::uint32_t(i); });
  }

  std::vector<std::unique_ptr<Worker>> workers;
  for (int w = 0; w < threads; ++w) {
    workers.push_back(std::make_unique<Worker>());
    workers.back()->ids.resize(kTilePixels);
    if (image.format == ColorFormat::rgba8) workers.back()->rgba8.resize(kTilePixels);
    if (image.format == ColorFormat::rgba32f) workers.back()->rgba32f.resize(kTilePixels);
  }
  parallel_for(n_columns * n_rows, threads, [&](std::size_t t, int worker) {
    const glm::ivec2 begin = {int(t % n_columns) * kTile_px, int(t / n_columns) * kTile_px};
    const PixelBox box = {begin, {std::min(begin.x + kTile_px, size.x), std::min(begin.y + kTile_px, size.y)}};
    TileDrawer(scene, *workers[std::size_t(worker)], image, box, t / n_columns).draw();
    if (options.on_tile) options.on_tile();
  });
  FrameStats stats = scene.assembly.stats;
  for (const auto& worker : workers) stats += worker->stats;
  return stats;
}

}  // namespace lode::raster::fast

namespace lode::raster {

struct FrameMemory::Parts {};

FrameMemory::FrameMemory() = default;
FrameMemory::~FrameMemory() = default;
FrameMemory::FrameMemory(FrameMemory&&) noexcept = default;
FrameMemory& FrameMemory::operator=(FrameMemory&&) noexcept = default;

}  // namespace lode::raster
