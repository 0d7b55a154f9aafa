#pragma once
/// Why a sample of a picture is what it is: every primitive that has to do with it, what became of it, by which rule,
/// and each step from weights to colour. Computed by the functions of the reference pipeline, one after the other, so
/// that depth, ids and colour are those of `render` to the bit.

#include <array>
#include <cstdint>
#include <optional>
#include <vector>

#include "raster/frame.h"
#include "raster/image.h"
#include "raster/stats.h"

namespace lode::raster {

/// What became of a piece at the sample.
enum class Fate : std::uint8_t {
  shown,         ///< order-free: nearest of all, or of those at its depth the one with the lowest key
  hidden,        ///< order-free: another one is shown
  drawn,         ///< ordered: passed the depth test, if any, and was stored or blended
  behind,        ///< ordered: not strictly nearer than the depth as it then stood
  alpha_failed,  ///< below the alpha test
  not_covered,   ///< its bounds hold the sample, its outline does not
  scissored,     ///< outside the frame's or the draw's scissor
  facing,        ///< culled: shows the wrong side
  near_clipped,  ///< cut away: nearer than the near plane there
  far_clipped,   ///< cut away: beyond the far plane there
  empty,         ///< no area (or length) left after the snap, in this pixel
};

/// An edge of a triangle, walked from a to b, and the sample p: E = (b − a) × (p − a), positive inside, exact.
struct ExplainedEdge {
  glm::ivec2 a_fx8{0, 0}, b_fx8{0, 0};  ///< window coordinates after the snap, 1/256 px
  std::int64_t value = 0;               ///< 1/256² px²; 0 on the edge: inside if it is a top or left one
  bool top_left = false;
};

/// One texel that a filter read. The weights of a lookup add up to 1.
struct TexelRead {
  int level = 0;
  glm::ivec2 texel{0, 0};  ///< −1 in either: the border colour
  double weight = 0.0;
};

struct TextureLookup {
  glm::dvec2 uv{0.0, 0.0};
  glm::dvec2 duv_dx{0.0, 0.0}, duv_dy{0.0, 0.0};  ///< per pixel
  std::optional<std::int32_t> lambda_fx8;         ///< level of detail before clamping, where the filter has one
  int probes = 1;
  std::vector<TexelRead> reads;
};

/// Colours on the way, in the target's unit.
struct ExplainedColor {
  glm::vec4 color{0.0f};     ///< draw colour × vertex colour
  glm::vec4 texel{0.0f};     ///< filtered; white without a texture
  glm::vec4 material{0.0f};  ///< their product
  glm::vec4 shaded{0.0f};    ///< the shader's result
  glm::vec3 normal{0.0f};    ///< as the shader was given it
};

/// A piece of a primitive (whole, or after clipping) and its part in the sample.
struct ExplainedPiece {
  Fate fate = Fate::not_covered;
  std::uint32_t draw = 0;       ///< index in the frame
  std::uint32_t primitive = 0;  ///< index in the draw
  std::uint32_t number = 0;     ///< of the piece in its primitive
  Ids ids{0, 0};                ///< as the picture has them; with `number` the key of ties
  Topology topology = Topology::triangles;
  bool front_facing = true;
  bool clipped = false;  ///< a piece of a cut triangle

  std::vector<ExplainedEdge> edges;  ///< three for triangles and quads, otherwise none
  bool other_piece_owns = false;  ///< inside all edges, but the cut polygon's winding gives the sample to another piece

  // From here on only where the sample is covered and was tested.
  std::optional<float> depth;
  std::array<double, 3> weights{0.0, 0.0, 0.0};  ///< perspective-correct, of these vertices:
  std::vector<std::uint32_t> vertices;           ///< one to three
  std::optional<TextureLookup> lookup;           ///< of textured draws
  std::optional<ExplainedColor> color;           ///< where it was shaded
  std::optional<glm::vec4> before, after;        ///< the sample's stored colour, where this one changed it
  std::optional<float> depth_before;             ///< what an ordered draw was tested against; none: nothing there
};

struct ExplainedSample {
  glm::ivec2 p_fx8{0, 0};  ///< window coordinates, 1/256 px
  glm::vec4 color{0.0f};   ///< stored, in the target's unit
  float depth = 0.0f;
  Ids ids{kNoId, kNoId};
  /// First the order-free pieces that were tested, nearest first; then the ordered ones as they were drawn; then the
  /// rest, by draw and primitive.
  std::vector<ExplainedPiece> pieces;
};

struct PixelExplanation {
  glm::ivec2 pixel{0, 0};
  std::vector<ExplainedSample> samples;  ///< in the frame's order
  glm::vec4 color{0.0f};                 ///< of the picture: averaged over the samples
  FrameStats discarded;                  ///< primitives of the whole frame that left before any pixel, by reason
};

/// Explains pixel (x, y) of the picture that `render` makes of the frame on a target of this size and format.
/// Throws Error: bad_input (as `render`; a pixel outside the target), out_of_memory. O(primitives of the frame). What
/// is clipped away or empty is told of triangles and quads only; what is culled or scissored only where it would cover.
[[nodiscard]] PixelExplanation explain_pixel(const Frame& frame, glm::ivec2 size_px, ColorFormat format,
                                             glm::ivec2 pixel, int threads = 0);

}  // namespace lode::raster
