#include <algorithm>
#include <array>
#include <bit>
#include <cstring>

#include "raster/blend.h"
#include "raster/fast/records.h"
#include "raster/fast/surface_resolve.h"
#include "raster/fast/textured.h"
#include "raster/fast/tile.h"
#include "raster/reference/shade.h"

namespace lode::raster::fast {
namespace {

class Resolver {
 public:
  Resolver(const Scene& scene, Worker& worker, const Image& image, const PixelBox& box, glm::ivec2 sample_fx8,
           bool fill, std::uint64_t n_won)
      : scene_(scene),
        w_(worker),
        owners_(scene, worker, box),
        records_(scene, worker, box, sample_fx8),
        surfaces_(scene, worker, owners_, box, sample_fx8, image.format),
        box_(box),
        sample_fx8_(sample_fx8),
        fill_(fill),
        n_won_(n_won) {
    size_ = box.end_px - box.begin_px;
    has_color_ = !image.rgba8.empty() || !image.rgba32f.empty();
    has_ids_ = !image.ids.empty();
    format_ = image.format;
    by_records_ = !image.rgba8.empty();
  }

  void run() {
    if (!has_color_ && !has_ids_) return;
    for (Textured& kept : *w_.textured) kept.owner = kNoOwner;
    clear8_ = store_rgba8(scene_.frame->clear);
    clear32_ = store_rgba32f(scene_.frame->clear);
    if (by_records_) {
      resolve_by_records();
    } else {
      for (int y = 0; y < size_.y; y += 4) {
        for (int x = 0; x < size_.x; x += 4) {
          if (fill_ || touched(*w_.tile, x, y)) resolve_block(x, y);
        }
      }
    }
    surfaces_.finish();
  }

 private:
  using Lanes = std::uint32_t;  // a bit for each sample of a 4×4

  void resolve_by_records() {
    records_.make(n_won_);
    ResolveJob job;
    job.tile = w_.tile.get();
    job.record_of = w_.record_of.get(), job.records = w_.records.get();
    std::memcpy(&job.clear, &clear8_, 4);
    job.fill = fill_;
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

  // ---- Samples ----

  void resolve_block(int x, int y) {
    const auto base = std::size_t(place_in_tile(x, y));
    Lanes left = 0xFFFF;  // samples in the picture that are not yet done
    if (size_.x - x < 4 || size_.y - y < 4) {
      left = 0;
      for (int k = 0; k < 16; ++k) left |= x + (k & 3) < size_.x && y + (k >> 2) < size_.y ? 1u << k : 0u;
    }
    const std::uint32_t* owners = w_.tile->owner + base;
    if (left == 0xFFFF && !has_ids_ && surfaces_.fill_alone(owners, base)) {
      w_.stats.fragments_shaded += 16;
      return;
    }
    Lanes none = 0;
    for (std::uint32_t k = 0; k < 16; ++k) none |= owners[k] == kNoOwner ? 1u << k : 0u;
    none &= left;
    if (none != 0) clear_lanes(none, base);
    left &= ~none;
    if (left == 0) return;
    if (has_ids_) {
      for_each_lane(left, [&](std::size_t k) { w_.ids[base + k] = owners_.ids(owners[k]); });
    }
    if (!has_color_) return;
    w_.stats.fragments_shaded += std::uint64_t(std::popcount(left));
    while (left != 0) left &= ~shade_owner(x, y, base, left);
  }

  void clear_lanes(Lanes lanes, std::size_t base) {
    for_each_lane(lanes, [&](std::size_t k) {
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
    for_each_lane(left, [&](std::size_t k) {
      if (!(owners[k] & kPieceBit)) return;
      const std::uint32_t record = records_.of_piece(owners[k] & ~kPieceBit);
      if (record == kNoRecord) return;
      index[k] = any = record;
      lanes |= 1u << k;
    });
    if (lanes == 0) return 0;
    for_each_lane(0xFFFF & ~lanes, [&](std::size_t k) { index[k] = any; });
    std::array<std::uint32_t, 16> bytes;
    const Lanes doubtful = scene_.kernels->shade_records(w_.records.get(), index.data(), x, y, bytes.data()) & lanes;
    for_each_lane(lanes, [&](std::size_t k) { std::memcpy(static_cast<void*>(&w_.rgba8[base + k]), &bytes[k], 4); });
    for_each_lane(doubtful, [&](std::size_t k) {
      w_.doubtful[n_doubtful_++] = {std::uint32_t(base + k), std::uint16_t(x + int(k & 3)),
                                    std::uint16_t(y + int(k >> 2))};
    });
    return lanes;
  }

  /// All lanes of one owner: by its texture's kernel, as a surface, at once or later with others, or as the reference
  /// shades them; or not at all, if they have their colours.
  Lanes shade_owner(int x, int y, std::size_t base, Lanes left) {
    const std::uint32_t* owners = w_.tile->owner + base;
    const std::uint32_t owner = owners[std::countr_zero(left)];
    Lanes lanes = 0;
    for (std::uint32_t k = 0; k < 16; ++k) lanes |= std::uint32_t(owners[k] == owner) << k;
    lanes &= left;
    const Draw& draw = scene_.frame->draws[owners_.draw(owner)];
    if (draw.alpha_test && format_ == ColorFormat::rgba32f &&
        drawn_by_kernels(owners_.piece(owner & ~kPieceBit))) {
      w_.stats.fragments_shaded -= std::uint64_t(std::popcount(lanes));
      return lanes;  // its colours were kept as it was tested
    }
    if (can_texture(draw, format_) && shade_textured(owner, x, y, base, lanes)) return lanes;
    if (!surfaces_.shade(owner, x, y, lanes)) shade_by_reference(draw, owner, x, y, base, lanes);
    return lanes;
  }

  void shade_by_reference(const Draw& draw, std::uint32_t owner, int x, int y, std::size_t base, Lanes lanes) {
    std::array<glm::ivec2, 16> pixels;
    std::array<float, 16> depths;
    std::array<glm::vec4, 16> rgba;
    std::size_t n = 0;
    for_each_lane(lanes, [&](std::size_t k) {
      depths[n] = w_.tile->depth[base + k];
      pixels[n++] = box_.begin_px + glm::ivec2(x + int(k & 3), y + int(k >> 2));
    });
    Piece made;
    const Piece& p = owners_.piece_of(owner, made);
    FrameStats own;  // of which the samples are counted already
    reference::shade(draw, p, format_, {{pixels.data(), n}, {depths.data(), n}, sample_fx8_}, rgba.data(), own);
    w_.stats.texels_read += own.texels_read;
    n = 0;
    for_each_lane(lanes, [&](std::size_t k) { store(base + k, rgba[n++]); });
  }

  /// A 4×4 of one textured triangle that is at hand, straight into the tile.
  bool shade_whole_block(int x, int y, std::size_t base) {
    const std::uint32_t* owners = w_.tile->owner + base;
    const Textured& kept = (*w_.textured)[owners[0] % w_.textured->size()];
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
    Textured& kept = (*w_.textured)[owner % w_.textured->size()];
    if (kept.owner != owner) {
      Piece made;
      const Piece& p = owners_.piece_of(owner, made);
      const auto* triangle = std::get_if<reference::Triangle>(&p.shape);
      if (!triangle || triangle->polygon) return false;
      kept = {owner, make_textured(scene_.frame->draws[p.draw], p, box_.begin_px)};
    }
    std::array<std::uint32_t, 16> bytes;
    w_.stats.texels_read += scene_.kernels->shade_textured(kept.triangle, x * 256 + sample_fx8_.x,
                                                           y * 256 + sample_fx8_.y, lanes, bytes.data());
    for_each_lane(lanes, [&](std::size_t k) { std::memcpy(static_cast<void*>(&w_.rgba8[base + k]), &bytes[k], 4); });
    return true;
  }

  void store(std::size_t i, const glm::vec4& rgba) {
    if (format_ == ColorFormat::rgba8) {
      w_.rgba8[i] = store_rgba8(rgba);
    } else {
      w_.rgba32f[i] = store_rgba32f(rgba);
    }
  }

  /// Sixteen at a time by the exact kernel; pieces one by one.
  void shade_doubtful() {
    for (std::size_t i = 0; i < n_doubtful_; ++i) {
      const Doubtful& d = w_.doubtful[i];
      const std::uint32_t owner = w_.tile->owner[d.place];
      if (!(owner & kPieceBit)) {
        surfaces_.shade_later(owner, d.x_px, d.y_px);
        continue;
      }
      const Piece& p = owners_.piece(owner & ~kPieceBit);
      const glm::ivec2 px = box_.begin_px + glm::ivec2(d.x_px, d.y_px);
      glm::vec4 rgba;
      FrameStats counted_already;
      reference::shade(scene_.frame->draws[p.draw], p, format_, {{&px, 1}, {&w_.tile->depth[d.place], 1}, sample_fx8_},
                       &rgba, counted_already);
      store(d.place, rgba);
    }
  }

  const Scene& scene_;
  Worker& w_;
  Owners owners_;
  Records records_;
  SurfaceResolver surfaces_;
  PixelBox box_;
  glm::ivec2 sample_fx8_;
  glm::ivec2 size_{0, 0};
  ColorFormat format_ = ColorFormat::rgba8;
  bool fill_;
  std::uint64_t n_won_;
  bool has_color_ = false, has_ids_ = false, by_records_ = false;
  glm::u8vec4 clear8_{0};
  glm::vec4 clear32_{0.0f};
  std::size_t n_doubtful_ = 0;
};

}  // namespace

void resolve(const Scene& scene, Worker& worker, const Image& image, const PixelBox& box, glm::ivec2 sample_fx8,
             bool fill, std::uint64_t n_won) {
  Resolver(scene, worker, image, box, sample_fx8, fill, n_won).run();
}

}  // namespace lode::raster::fast
