#pragma once
/// What a primitive covers, as sorted pixels and as text.

#include <algorithm>
#include <glm/vec2.hpp>
#include <string>
#include <utility>
#include <vector>

#include "raster/reference/primitive.h"

namespace lode::tests {

inline constexpr glm::ivec2 kCentre{128, 128};

/// (y, x) of every visit, sorted; a pixel visited twice is there twice.
using Pixels = std::vector<std::pair<int, int>>;

template <class Primitive>
void add_covered(Pixels& pixels, const Primitive& primitive, const raster::reference::PixelBox& window,
                 glm::ivec2 sample_fx8 = kCentre) {
  for_each_covered(primitive, window, sample_fx8, [&](glm::ivec2 p) { pixels.emplace_back(p.y, p.x); });
  std::sort(pixels.begin(), pixels.end());
}
template <class Primitive>
[[nodiscard]] Pixels covered(const Primitive& primitive, const raster::reference::PixelBox& window,
                             glm::ivec2 sample_fx8 = kCentre) {
  Pixels pixels;
  add_covered(pixels, primitive, window, sample_fx8);
  return pixels;
}

/// Rows of '.' and '#', or the number of visits where that is not 1; a line break before each row.
[[nodiscard]] inline std::string picture(const Pixels& pixels, glm::ivec2 size_px) {
  std::string text;
  for (int y = 0; y < size_px.y; ++y) {
    text += '\n';
    for (int x = 0; x < size_px.x; ++x) {
      const auto n = std::count(pixels.begin(), pixels.end(), std::pair{y, x});
      text += n == 0 ? '.' : n == 1 ? '#' : char('0' + std::min<long>(n, 9));
    }
  }
  return text + '\n';
}
template <class Primitive>
[[nodiscard]] std::string picture_of(const Primitive& primitive, glm::ivec2 size_px, glm::ivec2 sample_fx8 = kCentre) {
  return picture(covered(primitive, {{0, 0}, size_px}, sample_fx8), size_px);
}

}  // namespace lode::tests
