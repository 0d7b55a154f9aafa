#pragma once
/// Frames of mixed primitives and states that own what they borrow, so that draws and primitives can be taken out of
/// them until only those are left that matter.

#include <memory>
#include <vector>

#include "hashed_numbers.h"
#include "raster/render.h"

namespace lode::raster::test {

/// A draw and its arrays. The state is in `draw`; bind() makes its spans.
struct OwnedDraw {
  Draw draw;
  std::vector<glm::vec3> object;  ///< one of the three has the positions
  std::vector<glm::dvec4> clip;
  std::vector<glm::dvec3> window;
  glm::dmat4 clip_from_object{1.0};
  std::vector<glm::vec4> colors;
  std::vector<glm::vec3> normals;
  std::vector<glm::vec2> uvs;
  std::vector<float> radii;
  std::vector<std::uint32_t> indices;
  bool indexed = false;
  bool clustered = false;  ///< brings clusters of its own
  std::unique_ptr<Clusters> clusters;

  [[nodiscard]] std::size_t n_positions() const { return object.size() + clip.size() + window.size(); }

  void bind() {
    if (!clip.empty()) {
      draw.vertices = ClipVertices{clip};
    } else if (!window.empty()) {
      draw.vertices = WindowVertices{window};
    } else {
      draw.vertices = ObjectVertices{object, clip_from_object};
    }
    draw.indices.reset();
    if (indexed) draw.indices = indices;
    draw.colors = colors, draw.normals = normals, draw.uvs = uvs, draw.radii = radii;
    if (clustered) clusters = std::make_unique<Clusters>(make_clusters(object, draw.indices, 1));
    draw.clusters = clustered ? clusters.get() : nullptr;
  }
};

/// Vertices that make one primitive; of a strip, those of the first segment are two.
[[nodiscard]] inline std::size_t vertices_each(Topology topology) {
  switch (topology) {
    case Topology::triangles:
      return 3;
    case Topology::quads:
      return 4;
    case Topology::lines:
      return 2;
    default:
      return 1;
  }
}

struct OwnedFrame {
  glm::ivec2 size_px{64, 64};
  ColorFormat format = ColorFormat::rgba8;
  Planes planes;
  glm::vec4 clear{0.0f};
  std::optional<Rect> viewport, scissor;
  std::vector<glm::ivec2> samples_fx8{{128, 128}};
  bool ids_from_ordered_draws = false;
  std::vector<std::shared_ptr<const OwnedDraw>> draws;

  [[nodiscard]] Image image() const { return make_image(size_px, format, planes); }

  /// Renders and gives the counters.
  FrameStats render(Image& image, RenderOptions options) const {
    std::vector<Draw> bound;
    for (const auto& d : draws) bound.push_back(d->draw);
    options.ids_from_ordered_draws = ids_from_ordered_draws;
    Frame frame;
    frame.draws = bound, frame.clear = clear, frame.viewport = viewport, frame.scissor = scissor;
    frame.samples_fx8 = samples_fx8;
    return raster::render(frame, image, options);
  }
};

/// The same draw with only some of its vertices in turn (indices into what it draws now).
[[nodiscard]] inline std::shared_ptr<const OwnedDraw> with_corners(const OwnedDraw& from,
                                                                   const std::vector<std::uint32_t>& corners) {
  auto to = std::make_shared<OwnedDraw>();
  to->draw = from.draw;
  to->object = from.object, to->clip = from.clip, to->window = from.window;
  to->clip_from_object = from.clip_from_object;
  to->colors = from.colors, to->normals = from.normals, to->uvs = from.uvs, to->radii = from.radii;
  to->clustered = from.clustered;
  to->indexed = true;
  for (const std::uint32_t c : corners) to->indices.push_back(from.indexed ? from.indices[c] : c);
  to->bind();
  return to;
}

[[nodiscard]] inline std::size_t corner_count(const OwnedDraw& draw) {
  return draw.indexed ? draw.indices.size() : draw.n_positions();
}

}  // namespace lode::raster::test
