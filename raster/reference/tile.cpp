#include "raster/reference/tile.h"

#include <algorithm>
#include <array>

#include "raster/reference/shade.h"

namespace lode::raster::reference {
namespace {

constexpr std::uint32_t kNoPiece = 0xFFFFFFFFu;

class TilePainter {
 public:
  TilePainter(const TileJob& job, TileScratch& scratch, Image& image)
      : job_(job), s_(scratch), image_(image), format_(image.format) {
    width_px_ = job.box.end_px.x - job.box.begin_px.x;
    n_px_ = std::size_t(width_px_) * std::size_t(job.box.end_px.y - job.box.begin_px.y);
    has_color_ = !image.rgba8.empty() || !image.rgba32f.empty();
  }

  void paint() {
    if (std::any_of(job_.bin.begin(), job_.bin.end(), [&](std::uint32_t i) { return touches_tile(i); })) ++s_.stats.tiles;
    const std::size_t n_samples = job_.frame.samples_fx8.size();
    for (std::size_t k = 0; k < n_samples; ++k) {
      sample_fx8_ = job_.frame.samples_fx8[k];
      clear();
      for (const std::uint32_t i : job_.bin) {
        if (touches_tile(i) && draw_of(i).order_free()) draw_order_free(i);
      }
      resolve();
      for (const std::uint32_t i : job_.bin) {
        if (touches_tile(i) && !draw_of(i).order_free()) draw_ordered(i);
      }
      if (!s_.per_draw.empty()) count_owners();
      if (n_samples > 1) accumulate(k == 0);
    }
    if (n_samples > 1) average(n_samples);
    write();
  }

 private:
  const Draw& draw_of(std::uint32_t piece) const { return job_.frame.draws[job_.pieces[piece].draw]; }
  bool touches_tile(std::uint32_t piece) const { return !intersect(job_.pieces[piece].bounds_px, job_.box).empty(); }
  std::size_t place_of(glm::ivec2 px) const {
    const glm::ivec2 d = px - job_.box.begin_px;
    return std::size_t(d.y) * std::size_t(width_px_) + std::size_t(d.x);
  }
  glm::ivec2 p_fx8(glm::ivec2 px) const { return sample_position_fx8(px, sample_fx8_); }

  void clear() {
    std::fill_n(s_.depth.begin(), n_px_, 0.0f);
    std::fill_n(s_.owner.begin(), n_px_, kNoPiece);
    std::fill_n(s_.ids.begin(), n_px_, Ids{kNoId, kNoId});
    if (format_ == ColorFormat::rgba8) {
      std::fill_n(s_.rgba8.begin(), n_px_, store_rgba8(job_.frame.clear));
    } else {
      std::fill_n(s_.rgba32f.begin(), n_px_, store_rgba32f(job_.frame.clear));
    }
  }

  /// visit(i, px, depth, rgba) for each sample that the piece covers and that passes the draw's alpha test; rgba is the
  /// shaded colour where there is such a test, otherwise not yet set.
  template <class Visit>
  void for_each_fragment(const Piece& piece, const Draw& draw, Visit visit) {
    const PixelBox window = intersect(piece.bounds_px, job_.box);
    const auto fragment = [&](glm::ivec2 px) {
      ++s_.stats.fragments_covered;
      const float depth = depth_of(piece, p_fx8(px));
      glm::vec4 rgba;
      if (draw.alpha_test && !passes_alpha_test(draw, piece, px, depth, &rgba)) return;
      count_covered(piece);
      visit(place_of(px), px, depth, rgba);
    };
    visit_shape(piece.shape, [&](const auto& shape) { for_each_covered(shape, window, sample_fx8_, fragment); });
  }

  /// The shaded colour of one sample if it passes the draw's alpha test; counts.
  bool passes_alpha_test(const Draw& draw, const Piece& piece, glm::ivec2 px, float depth, glm::vec4* rgba) {
    shade(draw, piece, format_, {{&px, 1}, {&depth, 1}, sample_fx8_}, rgba, s_.stats);
    const double full = format_ == ColorFormat::rgba8 ? 255.0 : 1.0;
    if (double(rgba->a) / full >= *draw.alpha_test) return true;  // NaN fails
    ++s_.stats.fragments_alpha_failed;
    return false;
  }

  /// Nearest depth wins, then the lowest key, whatever the submission (C6).
  void draw_order_free(std::uint32_t index) {
    const Piece& piece = job_.pieces[index];
    for_each_fragment(piece, draw_of(index), [&](std::size_t i, glm::ivec2, float depth, const glm::vec4&) {
      const std::uint32_t owner = s_.owner[i];
      const bool wins = owner == kNoPiece || depth > s_.depth[i] ||
                        (depth == s_.depth[i] && key_before(piece, job_.pieces[owner]));
      if (!wins) {
        ++s_.stats.fragments_depth_failed;
        return;
      }
      s_.depth[i] = depth;
      s_.owner[i] = index;
    });
  }

  /// Shades each visible sample once, in runs of one piece along a row.
  void resolve() {
    std::array<glm::ivec2, kMaxShadeBatch> pixels;
    std::array<glm::vec4, kMaxShadeBatch> rgba;
    for (std::size_t i = 0; i < n_px_;) {
      const std::uint32_t owner = s_.owner[i];
      if (owner == kNoPiece) {
        ++i;
        continue;
      }
      const std::size_t row_end = (i / std::size_t(width_px_) + 1) * std::size_t(width_px_);
      std::size_t n = 0;
      for (; n < kMaxShadeBatch && i + n < row_end && s_.owner[i + n] == owner; ++n) {
        s_.ids[i + n] = job_.pieces[owner].ids;
        const int x = int((i + n) % std::size_t(width_px_)), y = int((i + n) / std::size_t(width_px_));
        pixels[n] = job_.box.begin_px + glm::ivec2(x, y);
      }
      if (has_color_) {
        shade(draw_of(owner), job_.pieces[owner], format_, {{pixels.data(), n}, {&s_.depth[i], n}, sample_fx8_},
              rgba.data(), s_.stats);
        for (std::size_t k = 0; k < n; ++k) store(i + k, rgba[k], Blend::none);
      }
      i += n;
    }
  }

  /// Ordered draws test against depth as it then stands: strictly nearer passes; the clear always loses.
  void draw_ordered(std::uint32_t index) {
    const Piece& piece = job_.pieces[index];
    const Draw& draw = draw_of(index);
    for_each_fragment(piece, draw, [&](std::size_t i, glm::ivec2 px, float depth, glm::vec4& rgba) {
      if (draw.depth_test && s_.owner[i] != kNoPiece && !(depth > s_.depth[i])) {
        ++s_.stats.fragments_depth_failed;
        return;
      }
      if (!owns_what_it_covers(draw)) count_visible(piece.draw);
      if (has_color_) {
        if (!draw.alpha_test) {
          shade(draw, piece, format_, {{&px, 1}, {&depth, 1}, sample_fx8_}, &rgba, s_.stats);
        }
        store(i, rgba, draw.blend);
        if (draw.blend != Blend::none) ++s_.stats.fragments_blended;
      }
      if (draw.writes_depth()) {
        s_.depth[i] = depth;
        s_.owner[i] = index;
      }
      if (draw.writes_depth() || job_.ids_from_ordered_draws) s_.ids[i] = piece.ids;
    });
  }

  void store(std::size_t i, const glm::vec4& rgba, Blend blend) {
    if (format_ == ColorFormat::rgba8) {
      s_.rgba8[i] = blend_rgba8(blend, store_rgba8(rgba), s_.rgba8[i]);
    } else {
      s_.rgba32f[i] = blend_rgba32f(blend, rgba, s_.rgba32f[i]);
    }
  }

  static bool owns_what_it_covers(const Draw& draw) { return draw.blend == Blend::none && draw.writes_depth(); }
  void count_covered(const Piece& piece) {
    if (!s_.per_draw.empty()) ++s_.per_draw[piece.draw].covered;
  }
  void count_visible(std::uint32_t draw) {
    if (!s_.per_draw.empty()) ++s_.per_draw[draw].visible;
  }
  void count_owners() {
    for (std::size_t i = 0; i < n_px_; ++i) {
      if (s_.owner[i] != kNoPiece && owns_what_it_covers(draw_of(s_.owner[i]))) count_visible(job_.pieces[s_.owner[i]].draw);
    }
  }

  void accumulate(bool first) {
    for (std::size_t i = 0; i < n_px_; ++i) {
      if (format_ == ColorFormat::rgba8) {
        s_.sum_rgba8[i] = (first ? glm::uvec4(0u) : s_.sum_rgba8[i]) + glm::uvec4(s_.rgba8[i]);
      } else {
        s_.sum_rgba32f[i] = (first ? glm::dvec4(0.0) : s_.sum_rgba32f[i]) + glm::dvec4(s_.rgba32f[i]);
      }
    }
  }

  void average(std::size_t n_samples) {
    const auto n = static_cast<unsigned>(n_samples);
    for (std::size_t i = 0; i < n_px_; ++i) {
      if (format_ == ColorFormat::rgba8) {
        s_.rgba8[i] = glm::u8vec4((2u * s_.sum_rgba8[i] + glm::uvec4(n)) / (2u * n));  // rounded half up
      } else {
        s_.rgba32f[i] = store_rgba32f(glm::vec4(s_.sum_rgba32f[i] / double(n)));
      }
    }
  }

  void write() {
    for (int y = job_.box.begin_px.y; y < job_.box.end_px.y; ++y) {
      const std::size_t from = place_of({job_.box.begin_px.x, y});
      const std::size_t to = std::size_t(y) * std::size_t(image_.size_px.x) + std::size_t(job_.box.begin_px.x);
      const auto copy_row = [&](const auto& tile, auto& plane) {
        if (!plane.empty()) std::copy_n(&tile[from], width_px_, &plane[to]);
      };
      copy_row(s_.rgba8, image_.rgba8);
      copy_row(s_.rgba32f, image_.rgba32f);
      copy_row(s_.depth, image_.depth);
      copy_row(s_.ids, image_.ids);
    }
  }

  const TileJob& job_;
  TileScratch& s_;
  Image& image_;
  ColorFormat format_;
  int width_px_ = 0;
  std::size_t n_px_ = 0;
  bool has_color_ = false;
  glm::ivec2 sample_fx8_{128, 128};
};

}  // namespace

TileScratch::TileScratch(const Frame& frame, const Image& image, int tile_size_px, bool per_draw_stats) {
  const std::size_t n = std::size_t(tile_size_px) * std::size_t(tile_size_px);
  const bool bytes = image.format == ColorFormat::rgba8, several = frame.samples_fx8.size() > 1;
  depth.resize(n);
  owner.resize(n);
  ids.resize(n);
  rgba8.resize(bytes ? n : 0);
  rgba32f.resize(bytes ? 0 : n);
  sum_rgba8.resize(bytes && several ? n : 0);
  sum_rgba32f.resize(!bytes && several ? n : 0);
  per_draw.resize(per_draw_stats ? frame.draws.size() : 0);
}

void draw_tile(const TileJob& job, TileScratch& scratch, Image& image) { TilePainter(job, scratch, image).paint(); }

}  // namespace lode::raster::reference
