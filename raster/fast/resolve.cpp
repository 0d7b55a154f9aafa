#include <algorithm>
#include <array>
#include <bit>
#include <cstring>

#include "raster/blend.h"
#include "raster/fast/textured.h"
#include "raster/fast/tile.h"
#include "raster/reference/shade.h"

namespace lode::raster::fast {
namespace {

constexpr int kNarrow_fx8 = 64 * 256;  // corners of triangles whose records the kernels make

class Resolver {
 public:
  Resolver(const Scene& scene, Worker& worker, const Image& image, const PixelBox& box, glm::ivec2 sample_fx8)
      : scene_(scene), w_(worker), owners_(scene, worker, box), box_(box), sample_fx8_(sample_fx8) {
    size_ = box.end_px - box.begin_px;
    has_color_ = !image.rgba8.empty() || !image.rgba32f.empty();
    has_ids_ = !image.ids.empty();
    format_ = image.format;
    by_records_ = !image.rgba8.empty();
  }

  void run() {
    if (!has_color_ && !has_ids_) return;
    if (by_records_) make_records();
    clear8_ = store_rgba8(scene_.frame->clear);
    clear32_ = store_rgba32f(scene_.frame->clear);
    if (by_records_) return resolve_by_records();
    for (int y = 0; y < size_.y; y += 4) {
      for (int x = 0; x < size_.x; x += 4) resolve_block(x, y);
    }
  }

 private:
  using Lanes = std::uint32_t;  // a bit for each sample of a 4×4

  template <class Visit>
  static void for_each_lane(Lanes lanes, Visit visit) {
    for (; lanes != 0; lanes &= lanes - 1) visit(std::uint32_t(std::countr_zero(lanes)));
  }

  void resolve_by_records() {
    ResolveJob job;
    job.tile = w_.tile.get();
    job.record_of = w_.record_of.get(), job.records = w_.records.get();
    std::memcpy(&job.clear, &clear8_, 4);
    job.rgba8 = reinterpret_cast<std::uint32_t*>(w_.rgba8.data());
    job.width_px = size_.x, job.height_px = size_.y;
    job.doubtful = w_.doubtful.get(), job.n_doubtful = &n_doubtful_;
    job.n_shaded = &w_.stats.fragments_shaded;
    job.context = this;
    job.shade_others = [](const void* self, int x, int y, Lanes lanes) {
      auto* resolver = static_cast<Resolver*>(const_cast<void*>(self));
      const auto base = std::size_t(place_in_tile(x, y));
      if (lanes == 0xFFFF && resolver->shade_whole_block(x, y, base)) return;
      lanes &= ~resolver->shade_by_records(x, y, base, lanes);
      while (lanes != 0) lanes &= ~resolver->shade_owner(x, y, base, lanes);
    };
    scene_.kernels->resolve_records(job);
    shade_doubtful();
    if (!has_ids_) return;
    for (int y = 0; y < size_.y; ++y) {
      for (int x = 0; x < size_.x; ++x) {
        const auto i = std::size_t(place_in_tile(x, y));
        const std::uint32_t owner = w_.tile->owner[i];
        w_.ids[i] = owner == kNoOwner ? Ids{kNoId, kNoId} : owners_.ids(owner);
      }
    }
  }

  // ---- Records: the colours of each visible triangle as planes ----

  void make_records() {
    n_records_ = 0;
    recent_.fill({kNoOwner, kNoRecord});
    for (const Resident& r : w_.residents) {
      std::memset(&w_.visible[std::size_t(&r - w_.residents.data()) * kSlotTriangles], 0, kSlotTriangles);
    }
    // Without branches: whose the next sample is, is hard to guess. Pieces and nothing mark a place of no slot.
    constexpr std::uint32_t kNowhere = kSlots * kSlotTriangles;
    for (std::size_t block = 0; block < std::size_t(kBlocksPerRow * kBlocksPerRow); ++block) {
      if ((w_.tile->written[block] & kTouched) == 0) continue;
      for (std::size_t i = 64 * block; i < 64 * block + 64; ++i) {
        const std::uint32_t owner = w_.tile->owner[i];
        w_.visible[owner & kPieceBit ? kNowhere : owner] = 1;
      }
    }
    for (std::uint32_t slot = 0; slot < w_.residents.size(); ++slot) {
      if (slot + 1 < w_.residents.size()) prefetch_colors(slot + 1);
      make_records_of(slot);
    }
  }

  /// Asks memory for the colours of the vertices of a slot that has anything visible.
  void prefetch_colors(std::uint32_t slot) const {
    std::array<std::uint64_t, kSlotTriangles / 8> visible;
    std::memcpy(visible.data(), &w_.visible[std::size_t(slot) * kSlotTriangles], kSlotTriangles);
    std::uint64_t any = 0;
    for (const std::uint64_t eight : visible) any |= eight;
    const Resident& r = w_.residents[slot];
    const FastDraw& fast = scene_.fast[r.fast_draw];
    if (any == 0 || !fast.flat || fast.constant) return;
    const std::uint32_t* vertices = &fast.clusters->vertices[r.first_vertex];
    const std::size_t n = fast.clusters->clusters[r.cluster].n_vertices;
    for (std::size_t i = 0; i < n; ++i) __builtin_prefetch(fast.flat_job.colors + 4 * std::size_t(vertices[i]));
  }

  void make_records_of(std::uint32_t slot) {
    const std::uint8_t* visible = &w_.visible[std::size_t(slot) * kSlotTriangles];
    std::array<std::uint8_t, kSlotTriangles> narrow, wide;
    std::size_t n_narrow = 0, n_wide = 0;
    const Resident& r = w_.residents[slot];
    const FastDraw& fast = scene_.fast[r.fast_draw];
    std::uint32_t* record_of = &w_.record_of[std::size_t(slot) * kSlotTriangles];
    if (!fast.flat) {
      std::fill_n(record_of, kSlotTriangles, kNoRecord);
      return;
    }
    if (fast.constant) {
      std::uint32_t record = kNoRecord;
      for (std::size_t t = 0; t < kSlotTriangles; ++t) {
        if (!visible[t]) continue;
        if (record == kNoRecord) record = add_constant(fast.bytes);
        record_of[t] = record;
      }
      return;
    }
    const WindowVertices128& v = w_.vertices[slot];
    const std::uint8_t* corners = &fast.clusters->corners[3 * std::size_t(r.first_triangle)];
    for (std::size_t first = 0; first < kSlotTriangles; first += 8) {
      std::uint64_t eight;
      std::memcpy(&eight, visible + first, 8);
      for (; eight != 0; eight &= eight - 1) {
        const std::size_t t = first + std::size_t(std::countr_zero(eight)) / 8;
        if (is_narrow(v, corners + 3 * t)) {
          record_of[t] = n_records_ + std::uint32_t(n_narrow);
          narrow[n_narrow++] = std::uint8_t(t);
        } else {
          wide[n_wide++] = std::uint8_t(t);
        }
      }
    }
    if (n_narrow > 0) {
      prepare_corners(v, corners, {narrow.data(), n_narrow}, fast.flat_job.colors,
                      &fast.clusters->vertices[r.first_vertex]);
      RecordJob job;
      job.corners = corners;
      job.vertices = w_.corners.get();
      job.scale = fast.scale;
      job.scaled = fast.flat_job.has_color;
      job.sample_x_fx8 = sample_fx8_.x, job.sample_y_fx8 = sample_fx8_.y;
      scene_.kernels->make_records(job, narrow.data(), int(n_narrow), &w_.records[n_records_]);
      n_records_ += std::uint32_t(n_narrow);
    }
    for (std::size_t i = 0; i < n_wide; ++i) {
      Piece p;
      owners_.make_piece(slot * kSlotTriangles + wide[i], p);
      record_of[wide[i]] = add_piece(p);
    }
  }

  /// What records need of the vertices of some triangles.
  void prepare_corners(const WindowVertices128& v, const std::uint8_t* corners, std::span<const std::uint8_t> triangles,
                       const float* colors, const std::uint32_t* mesh_vertices) {
    std::array<std::uint64_t, 2> wanted{};
    for (const std::uint8_t t : triangles) {
      for (std::size_t k = 0; k < 3; ++k) {
        const std::uint8_t corner = corners[3 * std::size_t(t) + k];
        wanted[corner / 64] |= std::uint64_t(1) << (corner % 64);
      }
    }
    for (std::size_t half = 0; half < 2; ++half) {
      for (std::uint64_t bits = wanted[half]; bits != 0; bits &= bits - 1) {
        const std::size_t i = 64 * half + std::size_t(std::countr_zero(bits));
        CornerRecord& out = w_.corners[i];
        std::memcpy(&out.x_fx8, &v.xy_fx8[i], 8);
        out.inverse_w = float(1.0 / v.w[i]);
        std::memcpy(out.rgba, colors + 4 * std::size_t(mesh_vertices[i]), 16);
      }
    }
  }

  static bool is_narrow(const WindowVertices128& v, const std::uint8_t* corners) {
    const auto [x0, x1] = std::minmax({v.x_fx8(corners[0]), v.x_fx8(corners[1]), v.x_fx8(corners[2])});
    const auto [y0, y1] = std::minmax({v.y_fx8(corners[0]), v.y_fx8(corners[1]), v.y_fx8(corners[2])});
    return x1 - x0 < kNarrow_fx8 && y1 - y0 < kNarrow_fx8;
  }

  std::uint32_t add_constant(std::uint32_t bytes) {
    ColorRecord record{};
    for (std::size_t c = 0; c < 4; ++c) record.quads[1][c] = float(bytes >> (8 * c) & 255);
    w_.records[n_records_] = record;
    return n_records_++;
  }

  /// The planes of one triangle in double; of a clipped polygon, too.
  std::uint32_t add_piece(const Piece& p) {
    const auto& t = std::get<reference::Triangle>(p.shape);
    const Draw& draw = scene_.frame->draws[p.draw];
    const float full = 255.0f;
    const glm::vec4 color = draw.color.value_or(glm::vec4(full));
    if (draw.colors.empty()) {
      const glm::u8vec4 b = store_rgba8(color);
      return add_constant(b.r | b.g << 8 | b.b << 16 | std::uint32_t(b.a) << 24);
    }
    const auto edges = reference::edges_of(t);
    const PixelBox inside = intersect(intersect(reference::bounds_px(t, sample_fx8_), p.bounds_px), box_);
    const glm::ivec2 middle = (inside.begin_px + inside.end_px) / 2;
    const glm::dvec2 reach = glm::dvec2(glm::max(middle - inside.begin_px, inside.end_px - middle));
    const glm::ivec2 at_fx8 = reference::sample_position_fx8(middle, sample_fx8_);
    std::array<double, 3> at, right, down;
    double sum = 0.0, d_right = 0.0, d_down = 0.0, terms = 0.0, most = 255.0;
    for (std::size_t k = 0; k < 3; ++k) {
      at[k] = double(edges[k].at(at_fx8)) / t.v[k].w;
      right[k] = -256.0 * double(edges[k].dy) / t.v[k].w, down[k] = 256.0 * double(edges[k].dx) / t.v[k].w;
      sum += at[k], d_right += right[k], d_down += down[k];
      terms += std::abs(at[k]) + reach.x * std::abs(right[k]) + reach.y * std::abs(down[k]);
    }
    ColorRecord record{};
    for (int c = 0; c < 4; ++c) {
      double v = 0.0, v_right = 0.0, v_down = 0.0;
      for (std::size_t k = 0; k < 3; ++k) {
        double corner = 0.0;
        if (t.polygon) {
          const auto& weights = t.polygon->weights[std::size_t(t.polygon_vertex[k])];
          for (std::size_t j = 0; j < 3; ++j) {
            const double own = double(draw.colors[p.vertices[j]][c]) * double(color[c]) / full;
            corner += weights[j] * own;
            most = std::max(most, std::abs(own));
          }
        } else {
          corner = double(draw.colors[p.vertices[k]][c]) * double(color[c]) / full;
          most = std::max(most, std::abs(corner));
        }
        v += at[k] * corner, v_right += right[k] * corner, v_down += down[k] * corner;
      }
      record.quads[1][c] = float(v / sum), record.quads[2][c] = float(v_right / sum),
      record.quads[3][c] = float(v_down / sum);
    }
    record.quads[0][0] = float(d_right / sum), record.quads[0][1] = float(d_down / sum);
    const glm::ivec2 in_tile = middle - box_.begin_px;
    const std::int32_t reference = in_tile.x | in_tile.y << 8;
    std::memcpy(&record.quads[0][2], &reference, 4);
    record.quads[0][3] = float(terms / std::abs(sum) * most * 0x1p-19);  // as the kernels': their bound holds here
    w_.records[n_records_] = record;
    return n_records_++;
  }

  /// The record of a piece, kept while its neighbours ask for it.
  std::uint32_t record_of_piece(std::uint32_t index) {
    for (const auto& [piece, record] : recent_) {
      if (piece == index) return record;
    }
    const Piece& p = owners_.piece(index);
    const Draw& draw = scene_.frame->draws[p.draw];
    const bool flat = std::holds_alternative<reference::Triangle>(p.shape) && !draw.texture && !draw.shader.function;
    if (!flat || n_records_ + 1 >= kMostRecords) return kNoRecord;
    recent_[next_recent_++ % recent_.size()] = {index, add_piece(p)};
    return recent_[(next_recent_ - 1) % recent_.size()].second;
  }

  // ---- Samples ----

  void resolve_block(int x, int y) {
    const auto base = std::size_t(place_in_tile(x, y));
    Lanes left = 0xFFFF;  // samples in the picture that are not yet done
    if (size_.x - x < 4 || size_.y - y < 4) {
      left = 0;
      for (int k = 0; k < 16; ++k) left |= x + (k & 3) < size_.x && y + (k >> 2) < size_.y ? 1u << k : 0u;
    }
    const std::uint32_t* owners = w_.tile->owner + base;
    Lanes none = 0;
    for (std::uint32_t k = 0; k < 16; ++k) none |= owners[k] == kNoOwner ? 1u << k : 0u;
    none &= left;
    if (none != 0) clear_lanes(none, base);
    left &= ~none;
    if (left == 0) return;
    if (has_ids_) {
      for_each_lane(left, [&](std::uint32_t k) { w_.ids[base + k] = owners_.ids(owners[k]); });
    }
    if (!has_color_) return;
    w_.stats.fragments_shaded += std::uint64_t(std::popcount(left));
    while (left != 0) left &= ~shade_owner(x, y, base, left);
  }

  void clear_lanes(Lanes lanes, std::size_t base) {
    for_each_lane(lanes, [&](std::uint32_t k) {
      if (has_ids_) w_.ids[base + k] = {kNoId, kNoId};
      if (!w_.rgba8.empty()) w_.rgba8[base + k] = clear8_;
      if (!w_.rgba32f.empty()) w_.rgba32f[base + k] = clear32_;
    });
  }

  /// Those lanes whose owners are pieces with records.
  Lanes shade_by_records(int x, int y, std::size_t base, Lanes left) {
    const std::uint32_t* owners = w_.tile->owner + base;
    std::array<std::uint32_t, 16> index;
    Lanes lanes = 0;
    std::uint32_t any = 0;
    for_each_lane(left, [&](std::uint32_t k) {
      if (!(owners[k] & kPieceBit)) return;
      const std::uint32_t record = record_of_piece(owners[k] & ~kPieceBit);
      if (record == kNoRecord) return;
      index[k] = any = record;
      lanes |= 1u << k;
    });
    if (lanes == 0) return 0;
    for_each_lane(0xFFFF & ~lanes, [&](std::uint32_t k) { index[k] = any; });
    std::array<std::uint32_t, 16> bytes;
    const Lanes doubtful = scene_.kernels->shade_records(w_.records.get(), index.data(), x, y, bytes.data()) & lanes;
    for_each_lane(lanes, [&](std::uint32_t k) { std::memcpy(static_cast<void*>(&w_.rgba8[base + k]), &bytes[k], 4); });
    for_each_lane(doubtful, [&](std::uint32_t k) {
      w_.doubtful[n_doubtful_++] = {std::uint32_t(base + k), std::uint16_t(x + int(k & 3)),
                                    std::uint16_t(y + int(k >> 2))};
    });
    return lanes;
  }

  /// All lanes of one owner, as the reference shades them.
  Lanes shade_owner(int x, int y, std::size_t base, Lanes left) {
    const std::uint32_t* owners = w_.tile->owner + base;
    const std::uint32_t owner = owners[std::countr_zero(left)];
    Lanes lanes = 0;
    for_each_lane(left, [&](std::uint32_t k) { lanes |= owners[k] == owner ? 1u << k : 0u; });
    std::array<glm::ivec2, 16> pixels;
    std::array<float, 16> depths;
    std::array<glm::vec4, 16> rgba;
    std::size_t n = 0;
    for_each_lane(lanes, [&](std::uint32_t k) {
      depths[n] = w_.tile->depth[base + k];
      pixels[n++] = box_.begin_px + glm::ivec2(x + int(k & 3), y + int(k >> 2));
    });
    const std::uint32_t draw_index =
        owner & kPieceBit ? owners_.piece(owner & ~kPieceBit).draw : owners_.fast_draw(owner).draw;
    if (can_texture(scene_.frame->draws[draw_index], format_) && shade_textured(owner, x, y, base, lanes)) return lanes;
    Piece made;
    if (!(owner & kPieceBit)) owners_.make_piece(owner, made);
    const Piece& p = owner & kPieceBit ? owners_.piece(owner & ~kPieceBit) : made;
    w_.stats.fragments_shaded -= n;  // counted by the caller; the reference counts, too
    reference::shade(scene_.frame->draws[p.draw], p, format_, {{pixels.data(), n}, {depths.data(), n}, sample_fx8_},
                     rgba.data(), w_.stats);
    n = 0;
    for_each_lane(lanes, [&](std::uint32_t k) { store(base + k, rgba[n++]); });
    return lanes;
  }

  /// A 4×4 of one textured triangle that is at hand, straight into the tile.
  bool shade_whole_block(int x, int y, std::size_t base) {
    const std::uint32_t* owners = w_.tile->owner + base;
    const Textured& kept = textured_[owners[0] % textured_.size()];
    std::uint32_t differ = owners[0] ^ kept.owner;
    for (std::size_t k = 1; k < 16; ++k) differ |= owners[k] ^ owners[0];
    if (differ != 0) return false;
    auto* bytes = reinterpret_cast<std::uint32_t*>(&w_.rgba8[base]);
    w_.stats.texels_read +=
        scene_.kernels->shade_textured(kept.triangle, x * 256 + sample_fx8_.x, y * 256 + sample_fx8_.y, 0xFFFF, bytes);
    return true;
  }

  /// False if the owner is not a whole triangle.
  bool shade_textured(std::uint32_t owner, int x, int y, std::size_t base, Lanes lanes) {
    Textured& kept = textured_[owner % textured_.size()];
    if (kept.owner != owner) {
      Piece made;
      if (!(owner & kPieceBit)) owners_.make_piece(owner, made);
      const Piece& p = owner & kPieceBit ? owners_.piece(owner & ~kPieceBit) : made;
      const auto* triangle = std::get_if<reference::Triangle>(&p.shape);
      if (!triangle || triangle->polygon) return false;
      kept = {owner, make_textured(scene_.frame->draws[p.draw], p, box_.begin_px)};
    }
    std::array<std::uint32_t, 16> bytes;
    w_.stats.texels_read += scene_.kernels->shade_textured(kept.triangle, x * 256 + sample_fx8_.x,
                                                           y * 256 + sample_fx8_.y, lanes, bytes.data());
    for_each_lane(lanes, [&](std::uint32_t k) { std::memcpy(static_cast<void*>(&w_.rgba8[base + k]), &bytes[k], 4); });
    return true;
  }

  void store(std::size_t i, const glm::vec4& rgba) {
    if (format_ == ColorFormat::rgba8) {
      w_.rgba8[i] = store_rgba8(rgba);
    } else {
      w_.rgba32f[i] = store_rgba32f(rgba);
    }
  }

  /// Sixteen at a time by the exact kernel, where they are one draw's; pieces one by one.
  void shade_doubtful() {
    std::array<std::uint32_t, 16> owners, places;
    std::array<std::int32_t, 16> x, y;
    std::size_t n = 0;
    std::uint32_t batch = 0;  // fast draw
    const auto flush = [&] {
      if (n == 0) return;
      for (std::size_t k = n; k < 16; ++k) owners[k] = owners[0], x[k] = x[0], y[k] = y[0];
      FlatJob job = scene_.fast[batch].flat_job;
      job.residents = w_.residents.data();
      job.vertices = w_.vertices.get();
      job.x_fx8 = x.data(), job.y_fx8 = y.data();
      alignas(64) std::array<float, 64> rgba;
      std::array<std::uint32_t, 16> bytes;
      scene_.kernels->shade_flat(job, owners.data(), rgba.data());
      scene_.kernels->store_bytes(rgba.data(), bytes.data());
      for (std::size_t k = 0; k < n; ++k) std::memcpy(static_cast<void*>(&w_.rgba8[places[k]]), &bytes[k], 4);
      n = 0;
    };
    for (std::size_t i = 0; i < n_doubtful_; ++i) {
      const Doubtful& d = w_.doubtful[i];
      const std::uint32_t owner = w_.tile->owner[d.place];
      if (owner & kPieceBit) {
        const Piece& p = owners_.piece(owner & ~kPieceBit);
        const glm::ivec2 px = box_.begin_px + glm::ivec2(d.x_px, d.y_px);
        glm::vec4 rgba;
        FrameStats counted_already;
        reference::shade(scene_.frame->draws[p.draw], p, format_,
                         {{&px, 1}, {&w_.tile->depth[d.place], 1}, sample_fx8_}, &rgba, counted_already);
        store(d.place, rgba);
        continue;
      }
      const std::uint32_t fast = w_.residents[owner / kSlotTriangles].fast_draw;
      if (n == 16 || (n > 0 && fast != batch)) flush();
      batch = fast;
      owners[n] = owner, places[n] = d.place;
      x[n] = d.x_px * 256 + sample_fx8_.x, y[n] = d.y_px * 256 + sample_fx8_.y;
      ++n;
    }
    flush();
  }

  const Scene& scene_;
  Worker& w_;
  Owners owners_;
  PixelBox box_;
  glm::ivec2 sample_fx8_;
  glm::ivec2 size_{0, 0};
  ColorFormat format_ = ColorFormat::rgba8;
  bool has_color_ = false, has_ids_ = false, by_records_ = false;
  glm::u8vec4 clear8_{0};
  glm::vec4 clear32_{0.0f};
  std::uint32_t n_records_ = 0;
  std::size_t n_doubtful_ = 0;
  std::array<std::pair<std::uint32_t, std::uint32_t>, 8> recent_;  // piece and record
  std::size_t next_recent_ = 0;
  struct Textured {
    std::uint32_t owner = kNoOwner;
    TexturedTriangle triangle;
  };
  std::array<Textured, 16> textured_;  ///< kept while their neighbours ask for them
};

}  // namespace

void resolve(const Scene& scene, Worker& worker, const Image& image, const PixelBox& box, glm::ivec2 sample_fx8) {
  Resolver(scene, worker, image, box, sample_fx8).run();
}

}  // namespace lode::raster::fast
