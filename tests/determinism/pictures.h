#pragma once
/// A fixed set of small pictures that between them use every primitive, state, filter, blend, clip plane, format and
/// sample pattern. The determinism test hashes them, the benchmarks draw them. Their inputs are made by plain double
/// arithmetic and a counter-based hash, so that they, too, are the same everywhere.

#include <memory>
#include <string>
#include <vector>

#include "raster/render.h"

namespace lode::pictures {

/// A frame and everything that it borrows.
struct Picture {
  std::string name;
  glm::ivec2 size_px{96, 80};
  raster::ColorFormat format = raster::ColorFormat::rgba8;
  glm::vec4 clear{0.0f, 0.0f, 0.0f, 0.0f};
  std::optional<raster::Rect> viewport{};
  std::optional<raster::Rect> scissor{};
  std::vector<glm::ivec2> samples_fx8{{128, 128}};
  std::vector<raster::Draw> draws{};
  std::vector<std::shared_ptr<const void>> owned{};  ///< what the draws' spans and pointers point to

  [[nodiscard]] raster::Frame frame() const {
    return {.draws = draws, .clear = clear, .viewport = viewport, .scissor = scissor, .samples_fx8 = samples_fx8};
  }
  /// Colour, and for one sample a pixel also depth and ids.
  [[nodiscard]] raster::Image image() const {
    const bool one = samples_fx8.size() == 1;
    return raster::make_image(size_px, format, {.color = true, .depth = one, .ids = one});
  }
};

[[nodiscard]] std::vector<Picture> all_pictures();

}  // namespace lode::pictures
