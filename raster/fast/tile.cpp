#include "raster/fast/tile.h"

#include <algorithm>
#include <array>
#include <cstring>

#include "raster/blend.h"
#include "raster/fast/surface_resolve.h"
#include "raster/fast/textured.h"
#include "raster/reference/shade.h"

namespace lode::raster::fast {
namespace {

class TileDrawer {
 public:
  TileDrawer(const Scene& scene, Worker& worker, Image& image, const PixelBox& box, std::size_t row)
      : scene_(scene),
        w_(worker),
        owners_(scene, worker, box),
        image_(image),
        box_(box),
        row_(row),
        format_(image.format) {
    size_ = box.end_px - box.begin_px;
    has_color_ = !image.rgba8.empty() || !image.rgba32f.empty();
  }

  void draw() {
    if (nothing_here()) return clear_image();
    ++w_.stats.tiles;
    const std::size_t n_samples = scene_.frame->samples_fx8.size();
    const auto row = scene_.row(row_);
    const bool any_ordered =
        std::any_of(row.begin(), row.end(), [&](std::uint32_t i) { return touches(i) && !draw_of(i).order_free(); });
    every_block_ = any_ordered || n_samples > 1;
    for (std::size_t k = 0; k < n_samples; ++k) {
      sample_fx8_ = scene_.frame->samples_fx8[k];
      clear();
      draw_pieces();
      draw_clusters();
      resolve(scene_, w_, image_, box_, sample_fx8_, every_block_, w_.counts.fragments_passed - won_before_);
      for (const std::uint32_t i : scene_.row(row_)) {
        if (touches(i) && !draw_of(i).order_free()) draw_in_order(i);
      }
      if (n_samples > 1) accumulate(k == 0);
    }
    if (n_samples > 1) average(n_samples);
    write();
  }

 private:
  [[nodiscard]] const Draw& draw_of(std::uint32_t piece) const {
    return scene_.frame->draws[owners_.piece(piece).draw];
  }
  [[nodiscard]] bool touches(std::uint32_t piece) const {
    return !intersect(owners_.piece(piece).bounds_px, box_).empty();
  }
  [[nodiscard]] std::size_t place_of(glm::ivec2 px) const {
    return std::size_t(place_in_tile(px.x - box_.begin_px.x, px.y - box_.begin_px.y));
  }

  [[nodiscard]] bool nothing_here() const {
    const auto row = scene_.row(row_);
    if (std::any_of(row.begin(), row.end(), [&](std::uint32_t i) { return touches(i); })) return false;
    return std::none_of(scene_.fast.begin(), scene_.fast.begin() + std::ptrdiff_t(scene_.n_fast),
                        [&](const FastDraw& f) { return !intersect(f.pixels, box_).empty(); });
  }

  void clear_image() {
    WriteJob job = write_job();
    write_planes(job, nullptr, nullptr);
    const glm::vec4 clear32 = store_rgba32f(scene_.frame->clear);
    for (int y = 0; y < size_.y; ++y) {
      const std::size_t to = first_px() + std::size_t(y) * job.pitch_px;
      if (!image_.rgba32f.empty()) std::fill_n(&image_.rgba32f[to], size_.x, clear32);
      if (!image_.ids.empty()) std::fill_n(&image_.ids[to], size_.x, Ids{kNoId, kNoId});
    }
  }

  void clear() {
    TileBuffers& tile = *w_.tile;
    const bool whole_tile = size_.x == kTile_px && size_.y == kTile_px;
    for (std::size_t block = 0; block < kBlocks; ++block) {
      if (whole_tile && w_.whole_tile && (tile.written[block] & kTouched) == 0) continue;
      std::fill_n(tile.depth + 64 * block, 64, -1.0f);
      std::fill_n(tile.owner + 64 * block, 64, kNoOwner);
      tile.block_min[block] = -1.0f;
      tile.written[block] = 0;
    }
    w_.whole_tile = whole_tile;
    // Places outside the picture must not keep a block from being covered.
    if (!whole_tile) {
      for (int y = 0; y < kTile_px; ++y) {
        for (int x = y < size_.y ? size_.x : 0; x < kTile_px; ++x) tile.depth[place_in_tile(x, y)] = 2.0f;
      }
    }
    w_.residents.clear();
    w_.free_slots.clear();
    won_before_ = w_.counts.fragments_passed;
  }

  // ---- Clusters, front to back ----

  void draw_clusters() {
    w_.heap.clear();
    for (std::uint32_t f = 0; f < scene_.n_fast; ++f) {
      const FastDraw& fast = scene_.fast[f];
      add(f, 0, fast.nearest, fast.pixels);
      for (std::size_t u = 0; u < fast.unclean.size(); ++u) {
        const UncleanCluster& unclean = fast.unclean[u];
        add(f, ClusterGroup::kIsCluster | unclean.cluster, unclean.nearest, unclean.pixels, std::int32_t(u));
      }
    }
    while (!w_.heap.empty()) {
      std::pop_heap(w_.heap.begin(), w_.heap.end());
      const Waiting next = w_.heap.back();
      w_.heap.pop_back();
      if (!w_.heap.empty()) prefetch(w_.heap.front());
      const PixelBox pixels = {{next.begin_x, next.begin_y}, {next.end_x, next.end_y}};
      if (scene_.options->skips.occlusion && scene_.kernels->hidden(*w_.tile, pixels, next.nearest)) {
        ++w_.stats.boxes_hidden;
      } else if (next.child & ClusterGroup::kIsCluster) {
        draw_cluster(next);
      } else {
        open(next);
      }
    }
  }

  /// Asks memory for a part of a tree that will be next, or soon.
  void prefetch(const Waiting& next) const {
    const auto ask = [](const auto* begin, std::size_t n) {
      const auto* bytes = reinterpret_cast<const char*>(begin);
      for (std::size_t i = 0; i < n * sizeof(*begin); i += 64) __builtin_prefetch(bytes + i);
    };
    const Clusters& all = *scene_.fast[next.fast_draw].clusters;
    if (!(next.child & ClusterGroup::kIsCluster)) return ask(&all.groups[next.child], 1);
    const Cluster& cluster = all.clusters[next.child & ~ClusterGroup::kIsCluster];
    for (const auto* axis : {&all.x, &all.y, &all.z}) ask(axis->data() + cluster.first_vertex, cluster.n_vertices);
    ask(all.corners.data() + 3 * std::size_t(cluster.first_triangle), 3 * std::size_t(cluster.n_triangles));
  }

  /// Puts a part of a tree where it waits for its turn, unless the tile has nothing of it. pixels: of the picture
  void add(std::uint32_t f, std::uint32_t child, float nearest, const PixelBox& pixels, std::int32_t unclean = -1) {
    const PixelBox here = intersect(pixels, box_);
    if (here.empty()) return;
    const glm::ivec2 begin = here.begin_px - box_.begin_px, end = here.end_px - box_.begin_px;
    w_.heap.push_back({nearest, f, child, unclean, std::uint16_t(begin.x), std::uint16_t(begin.y), std::uint16_t(end.x),
                       std::uint16_t(end.y)});
    std::push_heap(w_.heap.begin(), w_.heap.end());
  }

  void open(const Waiting& next) {
    const FastDraw& fast = scene_.fast[next.fast_draw];
    const ClusterGroup& group = fast.clusters->groups[next.child];
    std::array<BoxSight, ClusterGroup::kMost> sights;
    const PixelBox window = intersect(fast.limits, box_);
    scene_.kernels->look(fast.view, group, window, scene_.options->skips, sights.data());
    w_.stats.boxes_tested += std::uint64_t(group.n);
    for (std::size_t i = 0; i < std::size_t(group.n); ++i) {
      const BoxSight& s = sights[i];
      if (s.sight == Sight::outside) {
        ++w_.stats.boxes_outside;
      } else if (s.sight == Sight::facing) {
        ++w_.stats.boxes_facing;
      } else if (s.sight == Sight::clean) {
        add(next.fast_draw, group.child[i], s.nearest, s.pixels);
      } else if (!(group.child[i] & ClusterGroup::kIsCluster)) {
        add(next.fast_draw, group.child[i], 2.0f, window);
      }
    }
  }

  RasterJob job_of(const PixelBox& limits, Cull cull) {
    const PixelBox window = intersect(limits, box_);
    RasterJob job;
    job.cull = cull;
    job.skips = scene_.options->skips;
    job.begin_x = window.begin_px.x - box_.begin_px.x, job.begin_y = window.begin_px.y - box_.begin_px.y;
    job.end_x = window.end_px.x - box_.begin_px.x, job.end_y = window.end_px.y - box_.begin_px.y;
    job.sample_x_fx8 = sample_fx8_.x, job.sample_y_fx8 = sample_fx8_.y;
    job.context = this;
    job.key_before = [](const void* self, std::uint32_t a, std::uint32_t b) {
      return static_cast<const TileDrawer*>(self)->owners_.key_before(a, b);
    };
    job.facing_sign = [](const void* self, std::uint32_t triangle) {
      const auto* drawer = static_cast<const TileDrawer*>(self);
      return drawer->owners_.facing_sign(drawer->slot_, triangle);
    };
    return job;
  }

  void draw_cluster(const Waiting& next) {
    const FastDraw& fast = scene_.fast[next.fast_draw];
    const Clusters& all = *fast.clusters;
    const std::uint32_t c = next.child & ~ClusterGroup::kIsCluster;
    const Cluster& cluster = all.clusters[c];
    ++w_.stats.clusters_drawn;
    slot_ = take_slot();
    w_.residents[slot_] = {cluster.first_vertex, cluster.first_triangle, next.fast_draw, c};
    WindowVertices128& vertices = w_.vertices[slot_];
    scene_.kernels->transform(fast.view, all.x.data() + cluster.first_vertex, all.y.data() + cluster.first_vertex,
                              all.z.data() + cluster.first_vertex, cluster.n_vertices, box_.begin_px.x * 256,
                              box_.begin_px.y * 256, &vertices);
    RasterJob job = job_of(fast.limits, fast.view.cull);
    job.corners = all.corners.data() + 3 * std::size_t(cluster.first_triangle);
    job.n_triangles = cluster.n_triangles;
    job.wanted = next.unclean >= 0 ? fast.unclean[std::size_t(next.unclean)].wanted.data() : nullptr;
    job.vertices = &vertices;
    job.first_owner = slot_ * kSlotTriangles;
    job.marks = &w_.marks[job.first_owner];
    std::memset(job.marks, 0, kSlotTriangles);
    if (!scene_.kernels->rasterize(job, *w_.tile, w_.counts)) w_.free_slots.push_back(slot_);
  }

  /// A slot for a cluster. When all are taken, those that own no sample any more are taken back.
  std::uint32_t take_slot() {
    if (w_.free_slots.empty() && w_.residents.size() == kSlots) {
      std::vector<std::uint32_t>& in_use = w_.free_slots;  // [kSlots] for the moment: who owns something
      in_use.assign(kSlots, 0);
      for (const std::uint32_t owner : w_.tile->owner) {
        if (!(owner & kPieceBit)) in_use[owner / kSlotTriangles] = 1;
      }
      std::size_t n = 0;
      for (std::uint32_t s = 0; s < kSlots; ++s) {
        if (in_use[s] == 0) in_use[n++] = s;
      }
      in_use.resize(n);
    }
    if (!w_.free_slots.empty()) {
      const std::uint32_t slot = w_.free_slots.back();
      w_.free_slots.pop_back();
      return slot;
    }
    w_.residents.emplace_back();
    return std::uint32_t(w_.residents.size() - 1);
  }

  // ---- Pieces ----

  void draw_pieces() {
    for (const std::uint32_t i : scene_.row(row_)) {
      if (!touches(i) || !draw_of(i).order_free()) continue;
      if (drawn_by_kernels(owners_.piece(i))) {
        draw_triangle(i, std::get<reference::Triangle>(owners_.piece(i).shape));
      } else {
        draw_order_free(i);
      }
    }
  }

  void draw_triangle(std::uint32_t index, const reference::Triangle& t) {
    LoneTriangle lone;
    for (std::size_t k = 0; k < 3; ++k) {
      lone.x_fx8[k] = t.v[k].p_fx8.x - box_.begin_px.x * 256, lone.y_fx8[k] = t.v[k].p_fx8.y - box_.begin_px.y * 256;
      lone.z[k] = t.v[k].z;
    }
    lone.owner = index | kPieceBit;
    RasterJob job = job_of(owners_.piece(index).bounds_px, Cull::none);
    if (draw_of(index).alpha_test) {
      tested_.piece = index;
      tested_.triangle.reset();
      job.passing = [](const void* self, int x, int y, std::uint32_t lanes) {
        return static_cast<TileDrawer*>(const_cast<void*>(self))->passing(x, y, lanes);
      };
      if (!image_.rgba32f.empty()) {
        job.won = [](const void* self, int x, int y, std::uint32_t lanes) {
          static_cast<TileDrawer*>(const_cast<void*>(self))->keep_colors(x, y, lanes);
        };
      }
    }
    scene_.kernels->rasterize_lone(job, lone, *w_.tile, w_.counts);
  }

  /// Which samples of a 4×4 of the tested triangle pass its draw's alpha test.
  std::uint32_t passing(int x_px, int y_px, std::uint32_t lanes) {
    const Piece& p = owners_.piece(tested_.piece);
    const std::optional<Surface>& surface = scene_.surfaces[p.draw];
    if (!surface) return passing_by_reference(p, x_px, y_px, lanes);
    if (surface->least_passing > 0.0f) lanes &= surface->kept_pixels;  // alpha is 0 in the others
    if (lanes == 0) return 0;
    if (!tested_.triangle) tested_.triangle = make_surface_triangle(scene_.frame->draws[p.draw], p, box_.begin_px);
    shade_samples(*scene_.kernels, *surface, *tested_.triangle, glm::ivec2(x_px, y_px) * 256 + sample_fx8_, lanes,
                  w_.stats, tested_.samples);
    w_.stats.fragments_shaded += std::uint64_t(std::popcount(lanes));
    std::uint32_t passing = 0;
    for (std::size_t k = 0; k < 16; ++k) {
      passing |= std::uint32_t(tested_.samples.rgba[3][k] >= surface->least_passing) << k;
    }
    return passing & lanes;
  }

  /// The same of a draw with a shader of its own.
  std::uint32_t passing_by_reference(const Piece& p, int x_px, int y_px, std::uint32_t lanes) {
    std::array<glm::ivec2, 16> pixels;
    std::array<float, 16> depths;
    std::array<glm::vec4, 16> rgba;
    std::size_t n = 0;
    for_each_lane(lanes, [&](std::size_t k) {
      pixels[n] = box_.begin_px + glm::ivec2(x_px + int(k & 3), y_px + int(k >> 2));
      depths[n] = reference::depth_of(p, reference::sample_position_fx8(pixels[n], sample_fx8_));
      ++n;
    });
    reference::shade(scene_.frame->draws[p.draw], p, format_, {{pixels.data(), n}, {depths.data(), n}, sample_fx8_},
                     rgba.data(), w_.stats);
    std::uint32_t passing = 0;
    n = 0;
    for_each_lane(lanes, [&](std::size_t k) {
      passing |= std::uint32_t(passes_alpha_test(p, rgba[n])) << k;
      for (int c = 0; c < 4; ++c) tested_.samples.rgba[c][k] = rgba[n][c];
      ++n;
    });
    return passing;
  }

  [[nodiscard]] bool passes_alpha_test(const Piece& p, const glm::vec4& rgba) const {
    const double full = format_ == ColorFormat::rgba8 ? 255.0 : 1.0;
    return double(rgba.a) / full >= *scene_.frame->draws[p.draw].alpha_test;  // NaN fails
  }

  /// Of what was shaded for the test, so that it is not shaded again.
  void keep_colors(int x_px, int y_px, std::uint32_t lanes) {
    alignas(64) std::array<glm::vec4, 16> colors;
    scene_.kernels->store_floats(tested_.samples, &colors[0].x);
    const auto base = std::size_t(place_in_tile(x_px, y_px));
    for_each_lane(lanes, [&](std::size_t k) { w_.rgba32f[base + k] = colors[k]; });
  }

  /// visit(place, px, depth, rgba) for each sample that the piece covers and that passes the draw's alpha test; rgba is
  /// the shaded colour where there is such a test.
  template <class Visit>
  void for_each_fragment(const Piece& p, const Draw& draw, Visit visit) {
    const PixelBox window = intersect(p.bounds_px, box_);
    const auto fragment = [&](glm::ivec2 px) {
      ++w_.stats.fragments_covered;
      const float depth = reference::depth_of(p, reference::sample_position_fx8(px, sample_fx8_));
      glm::vec4 rgba;
      if (draw.alpha_test) {
        reference::shade(draw, p, format_, {{&px, 1}, {&depth, 1}, sample_fx8_}, &rgba, w_.stats);
        if (!passes_alpha_test(p, rgba)) {
          ++w_.stats.fragments_alpha_failed;
          return;
        }
      }
      visit(place_of(px), px, depth, rgba);
    };
    reference::visit_shape(p.shape, [&](const auto& shape) { for_each_covered(shape, window, sample_fx8_, fragment); });
  }

  void draw_order_free(std::uint32_t index) {
    const std::uint32_t owner = index | kPieceBit;
    TileBuffers& tile = *w_.tile;
    for_each_fragment(
        owners_.piece(index), draw_of(index), [&](std::size_t i, glm::ivec2, float depth, const glm::vec4&) {
          const bool wins =
              depth > tile.depth[i] || (depth == tile.depth[i] && owners_.key_before(owner, tile.owner[i]));
          if (!wins) {
            ++w_.stats.fragments_depth_failed;
            return;
          }
          tile.depth[i] = depth;
          tile.owner[i] = owner;
          tile.written[i / 64] = kStale | kTouched;
        });
  }

  void draw_in_order(std::uint32_t index) {
    const Piece& p = owners_.piece(index);
    const auto* triangle = std::get_if<reference::Triangle>(&p.shape);
    const bool by_kernel = triangle && !triangle->polygon && has_color_ && can_draw_textured(draw_of(index), format_) &&
                           !(scene_.options->ids_from_ordered_draws && !image_.ids.empty());
    if (!by_kernel) return draw_ordered(index);
    const TexturedTriangle textured = make_textured(draw_of(index), p, box_.begin_px);
    const PixelBox window = intersect(p.bounds_px, box_);
    OrderedJob job;
    job.triangle = &textured;
    job.begin_x = window.begin_px.x - box_.begin_px.x, job.begin_y = window.begin_px.y - box_.begin_px.y;
    job.end_x = window.end_px.x - box_.begin_px.x, job.end_y = window.end_px.y - box_.begin_px.y;
    job.sample_x_fx8 = sample_fx8_.x, job.sample_y_fx8 = sample_fx8_.y;
    job.depth_test = draw_of(index).depth_test;
    job.blend = draw_of(index).blend;
    job.tile = w_.tile.get();
    job.rgba8 = reinterpret_cast<std::uint32_t*>(w_.rgba8.data());
    OrderedCounts counts;
    scene_.kernels->draw_textured(job, counts);
    w_.stats.fragments_covered += counts.covered;
    w_.stats.fragments_depth_failed += counts.depth_failed;
    w_.stats.fragments_shaded += counts.shaded;
    w_.stats.fragments_blended += counts.blended;
    w_.stats.texels_read += counts.texels_read;
  }

  /// Ordered draws test against depth as it then stands: strictly nearer passes; the clear always loses.
  void draw_ordered(std::uint32_t index) {
    const Piece& p = owners_.piece(index);
    const Draw& draw = draw_of(index);
    TileBuffers& tile = *w_.tile;
    for_each_fragment(p, draw, [&](std::size_t i, glm::ivec2 px, float depth, glm::vec4& rgba) {
      if (draw.depth_test && tile.owner[i] != kNoOwner && !(depth > tile.depth[i])) {
        ++w_.stats.fragments_depth_failed;
        return;
      }
      if (has_color_) {
        if (!draw.alpha_test) reference::shade(draw, p, format_, {{&px, 1}, {&depth, 1}, sample_fx8_}, &rgba, w_.stats);
        store(i, rgba, draw.blend);
        if (draw.blend != Blend::none) ++w_.stats.fragments_blended;
      }
      if (draw.writes_depth()) {
        tile.depth[i] = depth;
        tile.owner[i] = index | kPieceBit;
        tile.written[i / 64] = kStale | kTouched;
      }
      if (!image_.ids.empty() && (draw.writes_depth() || scene_.options->ids_from_ordered_draws)) w_.ids[i] = p.ids;
    });
  }

  void store(std::size_t i, const glm::vec4& rgba, Blend blend) {
    if (format_ == ColorFormat::rgba8) {
      w_.rgba8[i] = blend_rgba8(blend, store_rgba8(rgba), w_.rgba8[i]);
    } else {
      w_.rgba32f[i] = blend_rgba32f(blend, rgba, w_.rgba32f[i]);
    }
  }

  // ---- The picture ----

  void accumulate(bool first) {
    for (std::size_t i = 0; i < w_.sum_rgba8.size(); ++i) {
      w_.sum_rgba8[i] = (first ? glm::uvec4(0u) : w_.sum_rgba8[i]) + glm::uvec4(w_.rgba8[i]);
    }
    for (std::size_t i = 0; i < w_.sum_rgba32f.size(); ++i) {
      w_.sum_rgba32f[i] = (first ? glm::dvec4(0.0) : w_.sum_rgba32f[i]) + glm::dvec4(w_.rgba32f[i]);
    }
  }

  void average(std::size_t n_samples) {
    const auto n = static_cast<unsigned>(n_samples);
    for (std::size_t i = 0; i < w_.sum_rgba8.size(); ++i) {
      w_.rgba8[i] = glm::u8vec4((2u * w_.sum_rgba8[i] + glm::uvec4(n)) / (2u * n));  // rounded half up
    }
    for (std::size_t i = 0; i < w_.sum_rgba32f.size(); ++i) {
      w_.rgba32f[i] = store_rgba32f(glm::vec4(w_.sum_rgba32f[i] / double(n)));
    }
  }

  /// Of the tile's first pixel in the image.
  [[nodiscard]] std::size_t first_px() const {
    return std::size_t(box_.begin_px.y) * std::size_t(image_.size_px.x) + std::size_t(box_.begin_px.x);
  }
  [[nodiscard]] WriteJob write_job() const {
    constexpr std::size_t kMostCached_px = std::size_t(1) << 20;  // 8 MiB of bytes and depths
    const std::size_t n_px = std::size_t(image_.size_px.x) * std::size_t(image_.size_px.y);
    return {.pitch_px = std::size_t(image_.size_px.x),
            .width_px = size_.x,
            .height_px = size_.y,
            .stream = n_px > kMostCached_px};
  }
  /// Bytes and depths; null: the clear's.
  void write_planes(WriteJob& job, const void* rgba8, const void* depth) {
    if (!image_.rgba8.empty()) {
      const glm::u8vec4 clear8 = store_rgba8(scene_.frame->clear);
      std::memcpy(&job.clear, &clear8, 4);
      job.from = rgba8, job.to = &image_.rgba8[first_px()];
      scene_.kernels->write_tile(job);
    }
    if (!image_.depth.empty()) {
      job.from = depth, job.to = &image_.depth[first_px()], job.depths = true, job.clear = 0;
      scene_.kernels->write_tile(job);
    }
  }

  void write() {
    WriteJob job = write_job();
    job.written = every_block_ ? nullptr : w_.tile->written;
    write_planes(job, w_.rgba8.data(), w_.tile->depth);
    if (!image_.rgba32f.empty()) {
      write_plane(w_.rgba32f.data(), store_rgba32f(scene_.frame->clear), image_.rgba32f.data());
    }
    if (!image_.ids.empty()) write_plane(w_.ids.data(), Ids{kNoId, kNoId}, image_.ids.data());
  }

  /// Four neighbours of a row lie together in a tile. Blocks that nothing has touched are the clear's, unless all are made.
  template <class T>
  void write_plane(const T* from, const T& clear, T* to) const {
    T clears[4];
    std::fill_n(clears, 4, clear);
    for (int y = 0; y < size_.y; ++y) {
      T* row = to + first_px() + std::size_t(y) * std::size_t(image_.size_px.x);
      for (int x = 0; x < size_.x; x += 4) {
        const T* four = every_block_ || touched(*w_.tile, x, y) ? from + place_in_tile(x, y) : clears;
        if (size_.x - x >= 4) {
          std::memcpy(static_cast<void*>(row + x), four, 4 * sizeof(T));  // of a known size: a few instructions
        } else {
          std::copy_n(four, size_.x - x, row + x);
        }
      }
    }
  }

  const Scene& scene_;
  Worker& w_;
  Owners owners_;
  Image& image_;
  PixelBox box_;
  std::size_t row_;
  ColorFormat format_;
  glm::ivec2 size_{0, 0};
  glm::ivec2 sample_fx8_{128, 128};
  bool has_color_ = false;
  bool every_block_ = false;  ///< of the tile's colours is made, not only those that were touched
  std::uint32_t slot_ = 0;
  struct {
    std::uint32_t piece = 0;
    std::optional<SurfaceTriangle> triangle;  ///< made when its first sample is seen
    SurfaceSamples samples;                   ///< of the 4×4 that was tested last
  } tested_;                                  ///< that with an alpha test which is being drawn
  std::uint64_t won_before_ = 0;  ///< samples, before this tile
};

}  // namespace

void Worker::prepare(const Scene& scene, const Image& image) {
  if (!tile) {
    vertices = std::make_unique_for_overwrite<WindowVertices128[]>(kSlots);
    marks = std::make_unique_for_overwrite<std::uint8_t[]>(kSlots * kSlotTriangles + 1);
    record_of = std::make_unique_for_overwrite<std::uint32_t[]>(kSlots * kSlotTriangles);
    records = std::make_unique_for_overwrite<ColorRecord[]>(kMostRecords);
    textured = std::make_unique<std::array<Textured, 16>>();
    surfaces = std::make_unique<std::array<KeptSurface, 64>>();
    residents.reserve(kSlots);
    free_slots.reserve(kSlots);
    doubtful = std::make_unique_for_overwrite<Doubtful[]>(kTilePixels);
    tile = std::make_unique_for_overwrite<TileBuffers>();  // last: it tells that all of them are there
  }
  heap.reserve(scene.n_boxes);
  const std::size_t n = kTilePixels;
  const bool several = scene.frame->samples_fx8.size() > 1;
  ids.resize(image.ids.empty() ? 0 : n);
  if (!image.rgba8.empty() && !bytes) bytes = std::make_unique_for_overwrite<TileBytes>();
  rgba8 = image.rgba8.empty() ? std::span<glm::u8vec4>() : std::span(bytes->rgba8);
  rgba32f.resize(image.rgba32f.empty() ? 0 : n);
  sum_rgba8.resize(several ? rgba8.size() : 0);
  sum_rgba32f.resize(several ? rgba32f.size() : 0);
  stats = {};
  counts = {};
}

void draw_tile(const Scene& scene, Worker& worker, Image& image, const PixelBox& box, std::size_t row) {
  TileDrawer(scene, worker, image, box, row).draw();
}

}  // namespace lode::raster::fast
