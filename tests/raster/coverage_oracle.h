#pragma once
/// Which samples a triangle or an outline covers, in exact arithmetic and written another way than raster/.
///
/// The top-left rule as a displacement: a sample on an edge belongs to the side that the sample moved by (+ε, +ε²)
/// (y down) lies on. On an edge that is not horizontal ε decides: to the right of a left edge is inside, to the right
/// of a right edge is not. On a horizontal edge only ε² is left: below a top edge is inside, below a bottom edge is
/// not. With coordinates of at most 25 bits ε = 2^-26 and ε² = 2^-52 sub-pixels are small enough, so everything is
/// scaled by 2^52 and the displaced sample lies on no edge at all: no tie rule is left.

#include <array>
#include <cstdint>
#include <glm/vec2.hpp>
#include <span>
#include <vector>

namespace lode::raster::test {

__extension__ typedef __int128 Int128;

using Corners = std::array<glm::ivec2, 3>;  ///< window coordinates in 1/256 px

struct Displacement {
  std::int64_t x = std::int64_t(1) << 26, y = 1;
};

/// The side of the line a→b that the displaced sample lies on: +1 where a clockwise triangle (as seen on screen) has
/// its inside, −1 on the other; 0 only where a and b coincide.
[[nodiscard]] inline int side_of(glm::ivec2 a, glm::ivec2 b, glm::ivec2 p, Displacement by = {}) {
  const Int128 x = (Int128(p.x - a.x) << 52) + by.x, y = (Int128(p.y - a.y) << 52) + by.y;
  const Int128 area = Int128(b.x - a.x) * y - Int128(b.y - a.y) * x;
  return (area > 0) - (area < 0);
}

/// +1 if the triangle covers the sample and its corners run clockwise as seen on screen, −1 if it covers it and they
/// run counter-clockwise, 0 if it does not cover it.
[[nodiscard]] inline int signed_cover(const Corners& t, glm::ivec2 p_fx8, Displacement by = {}) {
  const int s0 = side_of(t[0], t[1], p_fx8, by), s1 = side_of(t[1], t[2], p_fx8, by),
            s2 = side_of(t[2], t[0], p_fx8, by);
  return s0 == s1 && s1 == s2 ? s0 : 0;
}

[[nodiscard]] inline bool covers(const Corners& t, glm::ivec2 p_fx8) { return signed_cover(t, p_fx8) != 0; }

/// How often the closed outline runs clockwise around the sample: signed crossings of the ray to its right.
[[nodiscard]] inline int winding_number(std::span<const glm::ivec2> outline, glm::ivec2 p_fx8) {
  int winding = 0;
  for (std::size_t i = 0; i < outline.size(); ++i) {
    const glm::ivec2 a = outline[i], b = outline[(i + 1) % outline.size()];
    const bool a_below = a.y > p_fx8.y, b_below = b.y > p_fx8.y;  // below the displaced sample: on its level is above
    if (a_below == b_below) continue;
    const int side = side_of(a, b, p_fx8);
    if (b_below && side > 0) ++winding;  // the edge goes down, on the sample's right
    if (a_below && side < 0) --winding;
  }
  return winding;
}

/// The number of columns, 0, 1, …, whose sample lies left of a (not horizontal) line through a and b, on the row of
/// samples at y_fx8: those with 256 · column + 128 < x*, x* where the line meets the row; at most `limit`. A sample on
/// the line is displaced to its right.
[[nodiscard]] inline int columns_left_of(glm::ivec2 a, glm::ivec2 b, std::int32_t y_fx8, int limit) {
  if (a.y > b.y) return columns_left_of(b, a, y_fx8, limit);
  const Int128 dy = b.y - a.y;
  const Int128 above = Int128(a.x - 128) * dy + Int128(b.x - a.x) * (y_fx8 - a.y);  // (x* − 128) · dy
  if (above <= 0) return 0;
  const Int128 n = (above + 256 * dy - 1) / (256 * dy);  // ⌈(x* − 128) / 256⌉
  return n < limit ? int(n) : limit;
}

/// winding_number for all samples of the window [0, size_px), row by row from top to bottom.
[[nodiscard]] inline std::vector<std::int8_t> winding_numbers(std::span<const glm::ivec2> outline, glm::ivec2 size_px) {
  std::vector<std::int8_t> windings(std::size_t(size_px.x) * std::size_t(size_px.y));
  std::vector<int> steps(std::size_t(size_px.x) + 1);
  for (int y = 0; y < size_px.y; ++y) {
    const std::int32_t y_fx8 = 256 * y + 128;
    steps.assign(steps.size(), 0);
    int winding = 0;  // left of everything
    for (std::size_t i = 0; i < outline.size(); ++i) {
      const glm::ivec2 a = outline[i], b = outline[(i + 1) % outline.size()];
      const int down = int(b.y > y_fx8) - int(a.y > y_fx8);
      if (down == 0) continue;
      winding += down;
      steps[std::size_t(columns_left_of(a, b, y_fx8, size_px.x))] -= down;
    }
    for (int x = 0; x < size_px.x; ++x) {
      winding += steps[std::size_t(x)];
      windings[std::size_t(y) * std::size_t(size_px.x) + std::size_t(x)] = std::int8_t(winding);
    }
  }
  return windings;
}

}  // namespace lode::raster::test
