#pragma once
/// What is to be drawn: a frame is a list of draws, a draw one array of primitives with one state. Everything
/// is borrowed (spans and pointers must outlive the render), but for a shader's state, which is shared.

#include <cstdint>
#include <glm/mat4x4.hpp>
#include <glm/vec2.hpp>
#include <glm/vec3.hpp>
#include <glm/vec4.hpp>
#include <optional>
#include <span>
#include <variant>

#include "raster/clusters.h"
#include "raster/shader.h"
#include "raster/texture.h"

namespace lode::raster {

/// Pixels [origin, origin + size). A size may be 0; a negative one is bad input.
struct Rect {
  glm::ivec2 origin_px{0, 0};
  glm::ivec2 size_px{0, 0};
};

/// How vertices (after indexing) make primitives: 3, 4 (as triangles 0 1 2 and 0 2 3), 2, n−1 segments, 1, 1, 1.
enum class Topology : std::uint8_t { triangles, quads, lines, line_strip, points, discs, surfels };

/// Points of an object, taken to clip space in double. Infinite coordinates are read as ±2^128.
struct ObjectVertices {
  std::span<const glm::vec3> positions;
  glm::dmat4 clip_from_object{1.0};
};
/// Clip space: x right and y up in [−w, w], depth z/w in [0, 1], 1 near, w > 0 in front of the eye. Components
/// beyond ±2^300, infinities among them, are read as ±2^300.
struct ClipVertices {
  std::span<const glm::dvec4> positions;
};
/// Window space: x, y in pixels of the target, y down; z in [0, 1] is the depth written. No clipping: a
/// coordinate beyond the guard band of ±32768 px is bad input.
struct WindowVertices {
  std::span<const glm::dvec3> positions_px;
};
using Vertices = std::variant<ObjectVertices, ClipVertices, WindowVertices>;

enum class Cull : std::uint8_t { none, back, front };  ///< triangles and quads; front: counter-clockwise as seen
enum class Blend : std::uint8_t { none, over, add };   ///< over: premultiplied, s + d·(1 − sₐ); add: s + d

/// Lines only. Bit k of the pattern is fragment k·factor … k·factor + factor − 1, lowest bit first; the count
/// starts anew at each segment of `lines`, and once for a `line_strip`. Fragments outside the target and the scissor
/// count; a segment that is cut counts from its cut, and what lies beyond a clip plane counts nothing.
struct Stipple {
  std::uint16_t pattern = 0xFFFF;
  int factor = 1;  ///< 1…256
};

struct Draw {
  Topology topology = Topology::triangles;
  Vertices vertices;
  std::optional<std::span<const std::uint32_t>> indices;  ///< absent: vertices in order; empty: nothing is drawn
  const Clusters* clusters = nullptr;  ///< triangles in object space: made by make_clusters of these positions, indices

  // Per vertex; each empty or as long as the positions.
  std::span<const glm::vec4> colors;   ///< in the target's unit
  std::span<const glm::vec3> normals;  ///< for shading; for surfels: the disc's normal, any length but 0
  std::span<const glm::vec2> uvs;      ///< points, discs and surfels without them have (0,0)…(1,1) across their square
  std::span<const float> radii;        ///< discs: px; surfels: object units; ≤ 0 or NaN draws nothing
  float point_size_px = 1.0f;          ///< points: side of the square

  // Material.
  std::optional<glm::vec4> color;  ///< in the target's unit (255 is full for rgba8, 1 for rgba32f); default: white
  const Texture* texture = nullptr;
  Sampler sampler;
  Shader shader;

  // State.
  Cull cull = Cull::none;
  Blend blend = Blend::none;
  bool depth_test = true;
  std::optional<bool> depth_write;  ///< default: on without blending, off with it
  std::optional<double> alpha_test;  ///< keeps a sample whose shaded alpha, of 1, is at least this
  std::optional<Rect> scissor;
  std::optional<Stipple> stipple;

  // Ids written; default: the draw's index in the frame, the primitive's index in the draw.
  std::optional<std::uint32_t> draw_id;
  std::optional<std::uint32_t> primitive_id;

  [[nodiscard]] bool writes_depth() const { return depth_write.value_or(blend == Blend::none); }
  /// Order-free draws resolve to nearest depth, then lowest (draw, primitive, piece), whatever the submission.
  [[nodiscard]] bool order_free() const { return blend == Blend::none && depth_test && writes_depth(); }
};

/// One sample in the pixel's centre.
inline constexpr glm::ivec2 kCentreSample_fx8[] = {{128, 128}};

struct Frame {
  std::span<const Draw> draws;
  glm::vec4 clear{0.0f, 0.0f, 0.0f, 0.0f};  ///< in the target's unit
  /// Where clip space lands; may leave the target; at most 65536 px a side and from the origin; default all of it.
  std::optional<Rect> viewport;
  std::optional<Rect> scissor;              ///< limits every draw; the clear fills the target
  /// Sample positions in a pixel, 1/256 px from its upper left corner, each in [0, 256). The colours of all are
  /// averaged; with more than one (up to 1024) the image must have neither depth nor ids.
  std::span<const glm::ivec2> samples_fx8 = kCentreSample_fx8;
};

}  // namespace lode::raster
