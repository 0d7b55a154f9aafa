/// Two assemblies of the frame, both with the pixel as their scissor: one of all primitives with culling as the draws
/// ask for it, and one without culling, which tells what was culled. Then the steps of reference/tile.cpp, for one
/// sample at a time and with a note of each.

#include "raster/explain.h"

#include <list>
#include <new>
#include <utility>

#include "raster/blend.h"
#include "raster/error.h"
#include "raster/fp_environment.h"
#include "raster/parallel.h"
#include "raster/reference/assemble.h"
#include "raster/reference/discarded.h"
#include "raster/reference/shade.h"
#include "raster/reference/texture_trace.h"
#include "raster/validate.h"

namespace lode::raster {
namespace {

using reference::Assembly;
using reference::Piece;

bool inside(const std::optional<Rect>& rect, glm::ivec2 pixel) {
  if (!rect) return true;
  const auto holds = [](std::int64_t origin, std::int64_t size, int p) { return p >= origin && p < origin + size; };
  return holds(rect->origin_px.x, rect->size_px.x, pixel.x) && holds(rect->origin_px.y, rect->size_px.y, pixel.y);
}

/// Pieces that may touch the pixel, and the primitive of each within its draw, whatever id it was given.
struct PixelPieces {
  std::vector<Piece> pieces;
  std::vector<std::uint32_t> primitives;
  FrameStats stats;  ///< of the whole frame's primitives
  std::vector<reference::AssemblyPart> parts;  ///< what the pieces point to
};

/// The frame's draws, without culling if so asked, and without their scissors.
PixelPieces assemble_at(const Frame& frame, glm::ivec2 size_px, glm::ivec2 pixel, bool with_culling, int n_workers) {
  std::vector<Draw> draws(frame.draws.begin(), frame.draws.end());
  for (Draw& draw : draws) {
    draw.scissor.reset();
    draw.primitive_id.reset();
    if (!with_culling) draw.cull = Cull::none;
  }
  Frame part = frame;
  part.draws = draws;
  part.scissor = Rect{pixel, {1, 1}};
  Assembly assembly = reference::assemble(part, size_px, n_workers);

  PixelPieces result{std::move(assembly.pieces), {}, assembly.stats, std::move(assembly.parts)};
  for (Piece& piece : result.pieces) {
    result.primitives.push_back(piece.ids.primitive);
    piece.ids.primitive = frame.draws[piece.draw].primitive_id.value_or(piece.ids.primitive);
  }
  return result;
}

bool covers(const Piece& piece, glm::ivec2 pixel, glm::ivec2 sample_fx8) {
  bool covered = false;
  const reference::PixelBox window = {pixel, pixel + 1};
  reference::visit_shape(piece.shape, [&](const auto& shape) {
    for_each_covered(shape, window, sample_fx8, [&](glm::ivec2) { covered = true; });
  });
  return covered;
}

bool bounds_hold(const Piece& piece, glm::ivec2 pixel, glm::ivec2 sample_fx8) {
  return reference::visit_shape(piece.shape, [&](const auto& shape) {
    return !intersect(bounds_px(shape, sample_fx8), reference::PixelBox{pixel, pixel + 1}).empty();
  });
}

/// Replays one sample of the pixel.
class SampleReplay {
 public:
  SampleReplay(const Frame& frame, ColorFormat format, glm::ivec2 pixel, glm::ivec2 sample_fx8, const PixelPieces& kept)
      : frame_(frame), format_(format), pixel_(pixel), sample_fx8_(sample_fx8), kept_(kept) {
    p_fx8_ = reference::sample_position_fx8(pixel, sample_fx8);
  }

  /// Fills in the sample: its result and the pieces of the assembly.
  void run(ExplainedSample& sample) {
    sample.p_fx8 = p_fx8_;
    color_ = format_ == ColorFormat::rgba8 ? glm::vec4(store_rgba8(frame_.clear)) : store_rgba32f(frame_.clear);
    for (std::uint32_t i = 0; i < kept_.pieces.size(); ++i) look_at(i);
    resolve();
    for (const std::uint32_t i : ordered_) draw_ordered(i);
    for (Tested& t : order_free_) sample.pieces.push_back(std::move(t.piece));
    sample.color = color_;
    sample.depth = owner_ ? depth_ : 0.0f;
    if (owner_) sample.ids = kept_.pieces[*owner_].ids;
    for (std::vector<ExplainedPiece>* list : {&drawn_, &rest_}) {
      sample.pieces.insert(sample.pieces.end(), list->begin(), list->end());
    }
  }

  /// What can be said of any piece: who it is, and where its edges lie.
  [[nodiscard]] ExplainedPiece described(const Piece& piece, std::uint32_t primitive, Fate fate) const {
    const Draw& draw = frame_.draws[piece.draw];
    ExplainedPiece e;
    e.fate = fate;
    e.draw = piece.draw;
    e.primitive = primitive;
    e.number = piece.number;
    e.ids = piece.ids;
    e.topology = draw.topology;
    e.front_facing = piece.front_facing;
    e.vertices.assign(piece.vertices.begin(), piece.vertices.begin() + piece.n_vertices);
    if (const auto* triangle = std::get_if<reference::Triangle>(&piece.shape)) describe_triangle(*triangle, fate, e);
    return e;
  }

 private:
  const Draw& draw_of(std::uint32_t i) const { return frame_.draws[kept_.pieces[i].draw]; }

  void describe_triangle(const reference::Triangle& t, Fate fate, ExplainedPiece& e) const {
    e.clipped = t.polygon != nullptr;
    bool inside_all = true;
    const std::array<reference::EdgeFunction, 3> edges = edges_of(t);
    for (std::size_t i = 0; i < 3; ++i) {
      const glm::ivec2 next = t.v[(i + 1) % 3].p_fx8, after_next = t.v[(i + 2) % 3].p_fx8;
      const bool forward = t.sign > 0.0;
      e.edges.push_back(
          {forward ? next : after_next, forward ? after_next : next, edges[i].at(p_fx8_), edges[i].bias == 0});
      inside_all = inside_all && edges[i].at(p_fx8_) >= edges[i].bias;
    }
    e.other_piece_owns = inside_all && fate == Fate::not_covered;
  }

  /// A piece whose sample is covered and will be tested.
  [[nodiscard]] ExplainedPiece tested(std::uint32_t i, Fate fate) const {
    const Piece& piece = kept_.pieces[i];
    ExplainedPiece e = described(piece, kept_.primitives[i], fate);
    e.depth = reference::depth_of(piece, p_fx8_);
    e.weights = reference::visit_shape(piece.shape, [&](const auto& shape) { return weights_at(shape, p_fx8_); });
    const Draw& draw = draw_of(i);
    if (draw.texture) {
      const reference::VertexUvs uvs = reference::piece_uvs(draw, piece);
      e.lookup = reference::trace_lookup(
          *draw.texture, draw.sampler,
          reference::visit_shape(piece.shape, [&](const auto& shape) { return footprint_at(shape, uvs, p_fx8_); }));
    }
    return e;
  }

  void look_at(std::uint32_t i) {
    const Piece& piece = kept_.pieces[i];
    const Draw& draw = draw_of(i);
    if (!covers(piece, pixel_, sample_fx8_)) {
      if (bounds_hold(piece, pixel_, sample_fx8_))
        rest_.push_back(described(piece, kept_.primitives[i], Fate::not_covered));
    } else if (!inside(frame_.scissor, pixel_) || !inside(draw.scissor, pixel_)) {
      rest_.push_back(described(piece, kept_.primitives[i], Fate::scissored));
    } else if (!draw.order_free()) {
      ordered_.push_back(i);
    } else {
      test_order_free(i);
    }
  }

  void test_order_free(std::uint32_t i) {
    ExplainedPiece e = tested(i, Fate::hidden);
    if (!passes_alpha_test(i, e)) {
      rest_.push_back(std::move(e));
      return;
    }
    const bool wins =
        !owner_ || *e.depth > depth_ || (*e.depth == depth_ && key_before(kept_.pieces[i], kept_.pieces[*owner_]));
    if (wins) {
      owner_ = i;
      depth_ = *e.depth;
    }
    order_free_.push_back({i, std::move(e)});
  }

  void resolve() {
    if (!owner_) return;
    order_free_.sort([&](const Tested& a, const Tested& b) {  // stable
      if (*a.piece.depth != *b.piece.depth) return *a.piece.depth > *b.piece.depth;
      return key_before(kept_.pieces[a.index], kept_.pieces[b.index]);
    });
    ExplainedPiece& winner = order_free_.front().piece;
    winner.fate = Fate::shown;
    winner.before = color_;
    if (!winner.color) shade(*owner_, winner);
    store(winner, Blend::none);
  }

  void draw_ordered(std::uint32_t i) {
    const Draw& draw = draw_of(i);
    ExplainedPiece e = tested(i, Fate::drawn);
    if (owner_) e.depth_before = depth_;
    if (!passes_alpha_test(i, e)) {
      rest_.push_back(std::move(e));
      return;
    }
    if (draw.depth_test && owner_ && !(*e.depth > depth_)) {
      e.fate = Fate::behind;
    } else {
      e.before = color_;
      if (!e.color) shade(i, e);
      store(e, draw.blend);
      if (draw.writes_depth()) {
        owner_ = i;
        depth_ = *e.depth;
      }
    }
    drawn_.push_back(std::move(e));
  }

  bool passes_alpha_test(std::uint32_t i, ExplainedPiece& e) {
    const Draw& draw = draw_of(i);
    if (!draw.alpha_test) return true;
    shade(i, e);
    const double full = format_ == ColorFormat::rgba8 ? 255.0 : 1.0;
    if (double(e.color->shaded.a) / full >= *draw.alpha_test) return true;  // NaN fails
    e.fate = Fate::alpha_failed;
    return false;
  }

  /// The shader's result; before it, a shader that keeps what it is given.
  void shade(std::uint32_t i, ExplainedPiece& e) {
    const Piece& piece = kept_.pieces[i];
    const reference::SampleRun run{{&pixel_, 1}, {&*e.depth, 1}, sample_fx8_};
    ExplainedColor color;
    ExplainedColor* const kept = &color;
    Draw watched = draw_of(i);
    watched.shader = pixel_shader([kept](const Pixel& p) {
      kept->color = p.color;
      kept->texel = p.texel;
      kept->material = p.material;
      kept->normal = p.normal;
      return p.material;
    });
    FrameStats not_counted;
    glm::vec4 material;
    reference::shade(watched, piece, format_, run, &material, not_counted);
    reference::shade(draw_of(i), piece, format_, run, &color.shaded, not_counted);
    e.color = color;
  }

  void store(ExplainedPiece& e, Blend blend) {
    if (format_ == ColorFormat::rgba8) {
      color_ = glm::vec4(blend_rgba8(blend, store_rgba8(e.color->shaded), glm::u8vec4(color_)));
    } else {
      color_ = blend_rgba32f(blend, e.color->shaded, color_);
    }
    e.after = color_;
  }

  const Frame& frame_;
  ColorFormat format_;
  glm::ivec2 pixel_, sample_fx8_, p_fx8_;
  const PixelPieces& kept_;

  std::optional<std::uint32_t> owner_;  ///< piece that last wrote depth
  float depth_ = 0.0f;
  glm::vec4 color_{0.0f};
  std::vector<std::uint32_t> ordered_;  ///< covering pieces of ordered draws, in submission order
  struct Tested {
    std::uint32_t index;
    ExplainedPiece piece;
  };
  std::list<Tested> order_free_;
  std::vector<ExplainedPiece> drawn_, rest_;
};

glm::vec4 averaged(const std::vector<ExplainedSample>& samples, ColorFormat format) {
  if (samples.size() == 1) return samples.front().color;
  const auto n = static_cast<unsigned>(samples.size());
  glm::uvec4 bytes(0u);
  glm::dvec4 floats(0.0);
  for (const ExplainedSample& s : samples) {
    if (format == ColorFormat::rgba8) bytes += glm::uvec4(s.color);
    floats += glm::dvec4(s.color);
  }
  if (format == ColorFormat::rgba8) return glm::vec4((2u * bytes + glm::uvec4(n)) / (2u * n));  // rounded half up
  return store_rgba32f(glm::vec4(floats / double(n)));
}

PixelExplanation explain(const Frame& frame, glm::ivec2 size_px, ColorFormat format, glm::ivec2 pixel, int n_workers) {
  const PixelPieces kept = assemble_at(frame, size_px, pixel, true, n_workers);
  const PixelPieces all = assemble_at(frame, size_px, pixel, false, n_workers);
  const auto same = [&](std::size_t i, std::size_t j) {
    const Piece &a = kept.pieces[i], &b = all.pieces[j];
    return a.draw == b.draw && kept.primitives[i] == all.primitives[j] && a.number == b.number;
  };

  PixelExplanation explanation;
  explanation.pixel = pixel;
  explanation.discarded = kept.stats;
  explanation.samples.resize(frame.samples_fx8.size());
  for (std::size_t k = 0; k < explanation.samples.size(); ++k) {
    ExplainedSample& sample = explanation.samples[k];
    SampleReplay replay(frame, format, pixel, frame.samples_fx8[k], kept);
    replay.run(sample);
    // Both lists are in the same order: what the first lacks was culled.
    std::size_t next = 0;
    for (std::size_t j = 0; j < all.pieces.size(); ++j) {
      if (next < kept.pieces.size() && same(next, j)) {
        ++next;
      } else if (covers(all.pieces[j], pixel, frame.samples_fx8[k])) {
        sample.pieces.push_back(replay.described(all.pieces[j], all.primitives[j], Fate::facing));
      }
    }
  }
  reference::add_discarded(frame, size_px, pixel, explanation.samples);
  explanation.color = averaged(explanation.samples, format);
  return explanation;
}

}  // namespace

PixelExplanation explain_pixel(const Frame& frame, glm::ivec2 size_px, ColorFormat format, glm::ivec2 pixel,
                               int threads) {
  const FpEnvironment environment;
  const Image target{.size_px = size_px, .format = format, .rgba8 = {}, .rgba32f = {}, .depth = {}, .ids = {}};
  validate(frame, target, {.threads = threads});
  if (pixel.x < 0 || pixel.y < 0 || pixel.x >= size_px.x || pixel.y >= size_px.y) {
    throw Error(ErrorKind::bad_input, "pixel (%d, %d): outside the picture of %d x %d pixels", pixel.x, pixel.y,
                size_px.x, size_px.y);
  }
  try {
    return explain(frame, size_px, format, pixel, worker_count(threads));
  } catch (const std::bad_alloc&) {
    throw Error(ErrorKind::out_of_memory, "out of memory for explaining a pixel of %zu draws", frame.draws.size());
  }
}

}  // namespace lode::raster
