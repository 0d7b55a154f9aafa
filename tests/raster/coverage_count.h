#pragma once
/// Counts, sample by sample, how often triangles cover a window; what fails is shown as a small picture.

#include <cstdint>
#include <cstdlib>
#include <string>
#include <vector>

#include "coverage_oracle.h"
#include "hashed_numbers.h"
#include "raster/reference/triangle.h"

namespace lode::raster::test {

inline constexpr glm::ivec2 kCentre_fx8{128, 128};

[[nodiscard]] inline glm::ivec2 centre_of(glm::ivec2 pixel) {
  return reference::sample_position_fx8(pixel, kCentre_fx8);
}

[[nodiscard]] inline std::optional<reference::Triangle> triangle_of(const Corners& corners) {
  std::array<int, 3> order;
  return reference::make_triangle({{{corners[0]}, {corners[1]}, {corners[2]}}}, order);
}

/// Twice the area in 1/256² px²; positive if the corners run clockwise as seen on screen.
[[nodiscard]] inline std::int64_t doubled_area(const Corners& t) {
  return reference::doubled_area_fx16(t[0], t[1], t[2]);
}

[[nodiscard]] inline std::uint64_t pixels_in(const reference::PixelBox& box) {
  if (box.empty()) return 0;
  return std::uint64_t(box.end_px.x - box.begin_px.x) * std::uint64_t(box.end_px.y - box.begin_px.y);
}

/// Signed 8-bit counters of a window of pixels.
class CoverageCount {
 public:
  explicit CoverageCount(const reference::PixelBox& window)
      : window_(window), width_px_(window.end_px.x - window.begin_px.x), counts_(pixels_in(window)) {}

  [[nodiscard]] const reference::PixelBox& window() const { return window_; }
  [[nodiscard]] std::int8_t& at(glm::ivec2 px) {
    return counts_[std::size_t(px.y - window_.begin_px.y) * std::size_t(width_px_) +
                   std::size_t(px.x - window_.begin_px.x)];
  }

  /// Adds `by` to each sample covered. Returns the number of samples tested: those of the walk over the bounds.
  std::uint64_t add(const reference::Triangle& t, std::int8_t by = 1) {
    reference::for_each_covered(t, window_, kCentre_fx8, [&](glm::ivec2 px) { at(px) = std::int8_t(at(px) + by); });
    return pixels_in(reference::intersect(reference::bounds_px(t, kCentre_fx8), window_));
  }
  std::uint64_t add(const Corners& corners, std::int8_t by = 1) {
    const std::optional<reference::Triangle> t = triangle_of(corners);
    return t ? add(*t, by) : 0;
  }

  /// Calls visit(pixel, count) for every pixel of the window.
  template <class Visit>
  void for_each(Visit visit) const {
    std::size_t i = 0;
    for (int y = window_.begin_px.y; y < window_.end_px.y; ++y) {
      for (int x = window_.begin_px.x; x < window_.end_px.x; ++x) visit(glm::ivec2{x, y}, int(counts_[i++]));
    }
  }

  /// '.' for 0, digits, '-' for less than 0, '+' for more than 9; rows from top to bottom.
  [[nodiscard]] std::string picture() const {
    std::string rows;
    for_each([&](glm::ivec2 px, int n) {
      rows += n == 0 ? '.' : (n < 0 ? '-' : (n > 9 ? '+' : char('0' + n)));
      if (px.x + 1 == window_.end_px.x) rows += '\n';
    });
    return rows;
  }

 private:
  reference::PixelBox window_;
  int width_px_;
  std::vector<std::int8_t> counts_;
};

/// A coordinate in [0, limit_px] pixels: half of them through sample centres or along pixel edges.
[[nodiscard]] inline std::int32_t random_coordinate_fx8(HashedNumbers& random, int limit_px) {
  switch (random.below(4)) {
    case 0:
      return 256 * random.between(0, limit_px - 1) + 128;
    case 1:
      return 256 * random.between(0, limit_px);
    default:
      return random.between(0, 256 * limit_px);
  }
}
[[nodiscard]] inline glm::ivec2 random_point_fx8(HashedNumbers& random, int limit_px) {
  const std::int32_t x = random_coordinate_fx8(random, limit_px);
  return {x, random_coordinate_fx8(random, limit_px)};
}

[[nodiscard]] inline std::string to_string(const Corners& t) {
  std::string text;
  for (const glm::ivec2 p : t) text += "(" + std::to_string(p.x) + ", " + std::to_string(p.y) + ") ";
  return text + "in 1/256 px";
}

}  // namespace lode::raster::test
