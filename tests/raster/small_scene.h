#pragma once
/// Small frames for tests. A SmallScene owns what its draws borrow; pictures come back as text.

#include <gtest/gtest.h>

#include <cstring>
#include <memory>
#include <string>
#include <utility>
#include <vector>

#include "both_pipelines.h"

namespace lode::raster::test {

/// A frame under construction and the image it is drawn into.
class SmallScene {
 public:
  explicit SmallScene(glm::ivec2 size_px, ColorFormat format = ColorFormat::rgba8, Planes planes = {})
      : image(make_image(size_px, format, planes)) {
    draws.reserve(kMaxDraws);
  }

  /// Keeps the values as long as the scene lives.
  template <class T>
  std::span<const T> keep(std::vector<T> values) {
    auto owned = std::make_shared<const std::vector<T>>(std::move(values));
    kept_.push_back(owned);
    return *owned;
  }

  /// The reference stays good for kMaxDraws draws.
  Draw& add(Topology topology, Vertices vertices) {
    EXPECT_LT(draws.size(), kMaxDraws);
    Draw& draw = draws.emplace_back();
    draw.topology = topology;
    draw.vertices = std::move(vertices);
    return draw;
  }
  Draw& window(Topology topology, std::vector<glm::dvec3> positions_px) {
    return add(topology, WindowVertices{keep(std::move(positions_px))});
  }
  Draw& clip(Topology topology, std::vector<glm::dvec4> positions) {
    return add(topology, ClipVertices{keep(std::move(positions))});
  }
  Draw& object(Topology topology, std::vector<glm::vec3> positions,
               const glm::dmat4& clip_from_object = glm::dmat4(1.0)) {
    return add(topology, ObjectVertices{keep(std::move(positions)), clip_from_object});
  }
  /// A quad on whole pixels: covers exactly [from, to).
  Draw& rect(glm::ivec2 from, glm::ivec2 to, double z, const glm::vec4& color) {
    const double x0 = from.x, y0 = from.y, x1 = to.x, y1 = to.y;
    Draw& draw = window(Topology::quads, {{x0, y0, z}, {x1, y0, z}, {x1, y1, z}, {x0, y1, z}});
    draw.color = color;
    return draw;
  }

  /// By both pipelines: see both_pipelines.h.
  FrameStats render(const RenderOptions& options = {.threads = 1}) {
    frame.draws = draws;
    return render_by_both(frame, image, options);
  }

  Frame frame;
  std::vector<Draw> draws;
  Image image;

 private:
  static constexpr std::size_t kMaxDraws = 256;
  std::vector<std::shared_ptr<const void>> kept_;
};

/// One line a row: `letter(pixel index)` for each pixel.
template <class Letter>
std::string picture(const Image& image, Letter letter) {
  std::string text;
  for (int y = 0; y < image.size_px.y; ++y) {
    for (int x = 0; x < image.size_px.x; ++x)
      text += letter(std::size_t(y) * std::size_t(image.size_px.x) + std::size_t(x));
    text += '\n';
  }
  return text;
}

/// A letter per draw id, A first; '.' where nothing was drawn.
inline std::string ids_picture(const Image& image) {
  return picture(image,
                 [&](std::size_t i) { return image.ids[i].draw == kNoId ? '.' : char('A' + image.ids[i].draw); });
}

template <class T>
bool same_bytes(const PixelPlane<T>& a, const PixelPlane<T>& b) {
  return a.size() == b.size() && (a.empty() || std::memcmp(a.data(), b.data(), a.size() * sizeof(T)) == 0);
}

/// Every plane, bit for bit.
inline bool same_bytes(const Image& a, const Image& b) {
  return a.size_px == b.size_px && a.format == b.format && same_bytes(a.rgba8, b.rgba8) &&
         same_bytes(a.rgba32f, b.rgba32f) && same_bytes(a.depth, b.depth) && same_bytes(a.ids, b.ids);
}

/// Every counter by name: what a failed comparison should print.
inline std::string text_of(const FrameStats& stats) {
  std::string text;
  for_each_counter(stats, [&](const char* name, std::uint64_t n) {
    if (n != 0) text += std::string(name) + " " + std::to_string(n) + "\n";
  });
  return text;
}

}  // namespace lode::raster::test
