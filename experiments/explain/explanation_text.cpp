#include <cmath>
#include <cstdarg>
#include <cstdio>

#include "experiments/error.h"
#include "experiments/explain/explained_scene.h"
#include "raster/srgb.h"

namespace lode::experiments {
namespace {

using raster::ExplainedPiece;
using raster::ExplainedSample;
using raster::Fate;

constexpr std::size_t kMaxMisses = 6;  // primitives beside the sample that are told

[[gnu::format(printf, 1, 2)]] std::string formatted(const char* format, ...) {
  char text[400];
  std::va_list arguments;
  va_start(arguments, format);
  std::vsnprintf(text, sizeof text, format, arguments);
  va_end(arguments);
  return text;
}

class TextWriter {
 public:
  explicit TextWriter(const ExplainedScene& explained) : e_(explained) {}

  std::string run() {
    const raster::PixelExplanation& x = e_.explanation;
    line(0, formatted("pixel %d,%d of %d x %d: ", x.pixel.x, x.pixel.y, e_.view.size_px.x, e_.view.size_px.y) +
                one_line(e_.view.scene.name));
    line(1, "colour   " + color_text(x.color) + encoded_text(x.color));
    if (x.samples.size() > 1) write_samples();
    write_sample(x.samples[e_.sample]);
    write_frame();
    return text_;
  }

 private:
  void line(int depth, const std::string& words) { text_ += std::string(std::size_t(2 * depth), ' ') + words + "\n"; }

  [[nodiscard]] bool raw() const { return e_.color_space == techniques::ColorSpace::raw; }

  [[nodiscard]] std::string color_text(const glm::vec4& c) const {
    const char* format = raw() ? "%.6g %.6g %.6g %.6g" : "%.6f %.6f %.6f %.6f";
    return formatted(format, double{c.r}, double{c.g}, double{c.b}, double{c.a});
  }
  /// What a .png shows of a linear colour.
  [[nodiscard]] std::string encoded_text(const glm::vec4& c) const {
    if (raw()) return "  (bytes, as stored)";
    const glm::u8vec4 b = raster::srgb8_from_linear(c);
    return formatted("  (linear, premultiplied; as sRGB %d %d %d, alpha %d)", int(b.r), int(b.g), int(b.b), int(b.a));
  }
  [[nodiscard]] std::string depth_text(float depth) const {
    return formatted("%.9g, view distance %.6g", double{depth}, view_distance(e_.view.camera, double{depth}));
  }
  [[nodiscard]] std::string name_of(const ExplainedPiece& p) const {
    std::string text = formatted("draw %u", p.draw);
    const std::string name = draw_name(e_.view.scene, p.draw);
    if (!name.empty()) text += " \"" + one_line(shortened(name, 60)) + "\"";
    text += formatted(", primitive %u", p.primitive);
    if (p.clipped) text += formatted(", piece %u of what clipping left", p.number);
    return text;
  }

  void write_samples() {
    line(1, formatted("the mean of %zu samples:", e_.explanation.samples.size()));
    for (std::size_t k = 0; k < e_.explanation.samples.size(); ++k) {
      const ExplainedSample& s = e_.explanation.samples[k];
      const std::string who = s.ids.draw == raster::kNoId
                                  ? std::string("nothing solid")
                                  : formatted("draw %u, primitive %u", s.ids.draw, s.ids.primitive);
      line(2, formatted("%zu at (%.9g, %.9g): ", k, s.p_fx8.x / 256.0, s.p_fx8.y / 256.0) + color_text(s.color) + "  " +
                  who);
    }
  }

  void write_sample(const ExplainedSample& s) {
    line(0, "");
    line(0, formatted("At the sample (%.9g, %.9g):", s.p_fx8.x / 256.0, s.p_fx8.y / 256.0));
    if (s.ids.draw == raster::kNoId) {
      line(1, "depth    0: nothing wrote depth here, so ids are 4294967295 twice");
    } else {
      line(1, "depth    " + depth_text(s.depth));
      line(1, formatted("ids      draw %u, primitive %u", s.ids.draw, s.ids.primitive));
    }
    const std::size_t n_tested = write_tested(s);
    if (n_tested == 0) line(1, "nothing covers it: the clear colour is what is seen");
    write_dropped(s);
  }

  /// Pieces that reached the depth test, in the order in which they count.
  std::size_t write_tested(const ExplainedSample& s) {
    std::size_t n = 0;
    const ExplainedPiece* shown = nullptr;
    for (const ExplainedPiece& p : s.pieces) {
      if (p.fate == Fate::shown) shown = &p;
      const bool tested =
          p.fate == Fate::shown || p.fate == Fate::hidden || p.fate == Fate::drawn || p.fate == Fate::behind;
      if (!tested) continue;
      line(0, "");
      line(1, formatted("%zu. ", ++n) + verdict(p, shown) + ": " + name_of(p));
      line(2, "depth    " + depth_text(*p.depth));
      write_edges(p);
      write_weights(p);
      if (p.lookup) write_lookup(p);
      if (p.color) write_color(p);
    }
    return n;
  }

  [[nodiscard]] static std::string verdict(const ExplainedPiece& p, const ExplainedPiece* shown) {
    switch (p.fate) {
      case Fate::shown:
        return "SHOWN, nearest of the solid ones";
      case Fate::hidden:
        if (*p.depth == *shown->depth) {
          return formatted("hidden, at the same depth: key (%u, %u, %u) comes after (%u, %u, %u)", p.ids.draw,
                           p.ids.primitive, p.number, shown->ids.draw, shown->ids.primitive, shown->number);
        }
        return formatted("hidden, farther: depth %.9g < %.9g", double{*p.depth}, double{*shown->depth});
      case Fate::drawn:
        return p.depth_before ? formatted("DRAWN over it, strictly nearer than %.9g", double{*p.depth_before})
                              : std::string("DRAWN over the clear colour");
      default:
        return formatted("not drawn, behind: depth %.9g is not above %.9g", double{*p.depth}, double{*p.depth_before});
    }
  }

  void write_edges(const ExplainedPiece& p) {
    for (std::size_t i = 0; i < p.edges.size(); ++i) {
      const raster::ExplainedEdge& e = p.edges[i];
      std::string where;
      if (e.value == 0) where = e.top_left ? "  on a top or left edge: inside" : "  on a right or bottom edge: outside";
      if (e.value < 0) where = "  outside";
      line(2, formatted("%s%14lld  (%.9g, %.9g) to (%.9g, %.9g)", i == 0 ? "edges    " : "         ",
                        static_cast<long long>(e.value), e.a_fx8.x / 256.0, e.a_fx8.y / 256.0, e.b_fx8.x / 256.0,
                        e.b_fx8.y / 256.0) +
                  where);
    }
  }

  void write_weights(const ExplainedPiece& p) {
    std::string text = "weights ";
    for (std::size_t i = 0; i < p.vertices.size(); ++i)
      text += formatted(" %.9g of vertex %u%s", p.weights[i], p.vertices[i], i + 1 < p.vertices.size() ? "," : "");
    line(2, text);
  }

  void write_lookup(const ExplainedPiece& p) {
    const raster::TextureLookup& l = *p.lookup;
    std::string text = formatted("texture  uv %.9g, %.9g", l.uv.x, l.uv.y);
    if (l.lambda_fx8) text += formatted("; level of detail %.8g", *l.lambda_fx8 / 256.0);
    if (l.probes > 1) text += formatted("; %d probes", l.probes);
    line(2, text);
    for (const raster::TexelRead& read : l.reads) {
      line(2, formatted("         level %d, texel %d, %d: %.5g %%", read.level, read.texel.x, read.texel.y,
                        100.0 * read.weight));
    }
  }

  void write_color(const ExplainedPiece& p) {
    const raster::ExplainedColor& c = *p.color;
    line(2, "factors  " + color_text(c.color));
    if (p.lookup) line(2, "texel    " + color_text(c.texel));
    if (p.lookup) line(2, "product  " + color_text(c.material));
    if (c.shaded != c.material) {
      line(2, "shaded   " + color_text(c.shaded) +
                  formatted("  (normal %.6g, %.6g, %.6g)", double{c.normal.x}, double{c.normal.y}, double{c.normal.z}));
    }
    if (p.before) line(2, "before   " + color_text(*p.before));
    if (p.after) line(2, "after    " + color_text(*p.after));
  }

  /// Why a piece did not get as far as the depth test.
  [[nodiscard]] static std::string reason(const ExplainedPiece& p) {
    switch (p.fate) {
      case Fate::alpha_failed:
        return "below the alpha test";
      case Fate::scissored:
        return "outside the scissor";
      case Fate::facing:
        return p.front_facing ? "culled: shows its front" : "culled: shows its back";
      case Fate::near_clipped:
        return "cut away: nearer than the near plane";
      case Fate::far_clipped:
        return "cut away: beyond the far plane";
      case Fate::empty:
        return "no area after the snap to 1/256 px";
      default:
        return p.other_piece_owns ? "another piece of the same cut triangle has the sample" : "beside the sample";
    }
  }

  void write_dropped(const ExplainedSample& s) {
    std::size_t n_misses = 0;
    bool first = true;
    for (const ExplainedPiece& p : s.pieces) {
      const bool tested =
          p.fate == Fate::shown || p.fate == Fate::hidden || p.fate == Fate::drawn || p.fate == Fate::behind;
      if (tested || (p.fate == Fate::not_covered && ++n_misses > kMaxMisses)) continue;
      if (first) {
        line(0, "");
        line(0, "Not tested for depth:");
        first = false;
      }
      line(1, name_of(p) + ": " + reason(p));
      if (p.fate == Fate::not_covered) write_edges(p);
      if (p.fate == Fate::alpha_failed) write_color(p);
    }
    if (n_misses > kMaxMisses) {
      line(1, formatted("and %zu more whose bounds hold the sample (--json has all)", n_misses - kMaxMisses));
    }
  }

  void write_frame() {
    const raster::FrameStats& d = e_.explanation.discarded;
    const auto n = [](std::uint64_t value) { return static_cast<unsigned long long>(value); };
    line(0, "");
    line(0, formatted(
                "The whole frame: %llu primitives, of which %llu outside the view, %llu culled by facing, %llu without "
                "area, %llu not finite; %llu cut.",
                n(d.primitives_in), n(d.primitives_outside), n(d.primitives_facing), n(d.primitives_empty),
                n(d.primitives_not_finite), n(d.primitives_clipped)));
    line(0, "Edges are (b - a) x (p - a) in 1/65536 px², exact; above 0 is inside. Keys are (draw, primitive, piece).");
  }

  const ExplainedScene& e_;
  std::string text_;
};

}  // namespace

std::string explanation_text(const ExplainedScene& explained) { return TextWriter(explained).run(); }

}  // namespace lode::experiments
