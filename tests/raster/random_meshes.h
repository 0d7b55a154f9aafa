#pragma once
/// Random positions for random frames: soups, meshes, layers and all that is awkward about them.

#include <limits>

#include "random_frame.h"

namespace lode::raster::test {

inline constexpr double kPi = 3.14159265358979323846;

/// A perspective with reversed depth, infinite far plane, looking down −z from `from`, turned about the y axis.
[[nodiscard]] inline glm::dmat4 perspective_from(glm::dvec3 from, double turn_rad, double near) {
  glm::dmat4 turn(1.0);
  turn[0][0] = turn[2][2] = std::cos(turn_rad);
  turn[0][2] = std::sin(turn_rad), turn[2][0] = -std::sin(turn_rad);
  glm::dmat4 move(1.0);
  move[3] = glm::dvec4(-from, 1.0);
  glm::dmat4 project(0.0);
  project[0][0] = 1.0, project[1][1] = 1.25, project[3][2] = near, project[2][3] = -1.0;
  return project * turn * move;
}

/// Window pixels of the target to clip space with w = 1, so that object positions may be given in pixels.
[[nodiscard]] inline glm::dmat4 clip_from_pixels(glm::ivec2 size_px) {
  glm::dmat4 m(1.0);
  m[0][0] = 2.0 / size_px.x, m[1][1] = -2.0 / size_px.y;
  m[3] = {-1.0, 1.0, 0.0, 1.0};
  return m;
}

/// Triangles anywhere about the picture, of one size or of all: pixels, depth in [0, 1]; often on the sub-pixel grid.
inline void add_soup(HashedNumbers& random, glm::ivec2 size_px, std::size_t n, std::vector<glm::vec3>& out) {
  static constexpr double kSizes_px[] = {0.3, 1, 4, 12, 40, 90, 3000};
  const std::uint32_t of_size = random.below(std::size(kSizes_px) + 2);
  const std::uint32_t grid = random.below(4);  // 0: any position; else multiples of ½ px, ¹/₁₆ px, ¹/₂₅₆ px
  const bool flat = random.below(4) == 0;
  const auto snapped = [&](double x) {
    const double unit = grid == 1 ? 2.0 : grid == 2 ? 16.0 : 256.0;
    return float(grid == 0 ? x : std::round(x * unit) / unit);
  };
  for (std::size_t t = 0; t < n; ++t) {
    const double size = kSizes_px[of_size < std::size(kSizes_px) ? of_size : random.below(std::size(kSizes_px))];
    const double x = (1.2 * random.unit() - 0.1) * size_px.x, y = (1.2 * random.unit() - 0.1) * size_px.y;
    const double z = random.unit(), tilt = flat ? 0.0 : random.unit();
    for (int k = 0; k < 3; ++k) {
      out.push_back({snapped(x + size * (random.unit() - 0.5)), snapped(y + size * (random.unit() - 0.5)),
                     float(std::clamp(z + tilt * (random.unit() - 0.5), 0.0, 1.0))});
    }
  }
}

/// Thin triangles of any direction, in pixels.
inline void add_slivers(HashedNumbers& random, glm::ivec2 size_px, std::size_t n, std::vector<glm::vec3>& out) {
  for (std::size_t t = 0; t < n; ++t) {
    const double a = 2.0 * kPi * random.unit(), length = 100.0 * random.unit(), width = random.unit();
    const glm::dvec3 along{std::cos(a), std::sin(a), 0.0}, across{-std::sin(a), std::cos(a), 0.0};
    const glm::dvec3 p{size_px.x * random.unit(), size_px.y * random.unit(), random.unit()};
    out.push_back(glm::vec3(p));
    out.push_back(glm::vec3(p + length * along));
    out.push_back(glm::vec3(p + length * random.unit() * along + width * across));
  }
}

/// A height field of columns × rows cells with shared vertices about the origin, side 2; its indices.
inline void add_grid(HashedNumbers& random, std::uint32_t columns, std::uint32_t rows, OwnedDraw& to) {
  const double rough = random.below(3) == 0 ? 0.0 : 0.3;
  const auto base = std::uint32_t(to.object.size());
  for (std::uint32_t j = 0; j <= rows; ++j) {
    for (std::uint32_t i = 0; i <= columns; ++i) {
      to.object.push_back({float(2.0 * i / columns - 1.0), float(2.0 * j / rows - 1.0), float(rough * random.unit())});
    }
  }
  for (std::uint32_t j = 0; j < rows; ++j) {
    for (std::uint32_t i = 0; i < columns; ++i) {
      const std::uint32_t a = base + j * (columns + 1) + i, b = a + 1, c = a + columns + 1, d = c + 1;
      for (const std::uint32_t v : {a, b, c, c, b, d}) to.indices.push_back(v);
    }
  }
  to.indexed = true;
}

/// A closed ball about the origin of `columns` · `rows` · 2 triangles, those at the poles without area; seen from
/// outside its triangles are counter-clockwise.
inline void add_ball(std::uint32_t columns, std::uint32_t rows, OwnedDraw& to) {
  for (std::uint32_t j = 0; j <= rows; ++j) {
    for (std::uint32_t i = 0; i <= columns; ++i) {
      const double u = 2.0 * kPi * (i % columns) / columns, v = kPi * j / rows;
      to.object.push_back({float(std::sin(v) * std::cos(u)), float(std::cos(v)), float(-std::sin(v) * std::sin(u))});
    }
  }
  for (std::uint32_t j = 0; j < rows; ++j) {
    for (std::uint32_t i = 0; i < columns; ++i) {
      const std::uint32_t a = j * (columns + 1) + i, b = a + 1, c = a + columns + 1, d = c + 1;
      for (const std::uint32_t v : {a, c, b, b, c, d}) to.indices.push_back(v);
    }
  }
  to.indexed = true;
}

/// Rectangles over one another, in pixels; many of the same depth and place.
inline void add_layers_of_quads(HashedNumbers& random, glm::ivec2 size_px, std::size_t n, std::vector<glm::vec3>& out) {
  for (std::size_t k = 0; k < n; ++k) {
    const float z = float(random.below(5)) * 0.25f, tilt = random.below(3) == 0 ? 0.25f : 0.0f;
    const float x0 = float(random.below(3)) * 7.5f - 3.0f, y0 = float(random.below(3)) * 5.0f - 2.0f;
    const float x1 = random.below(3) == 0 ? x0 + 20.5f : float(size_px.x) + 2.0f, y1 = float(size_px.y) - y0;
    const auto corner = [&](float x, float y) { out.push_back({x, y, x == x0 ? z : std::max(z - tilt, 0.0f)}); };
    corner(x0, y0), corner(x1, y0), corner(x1, y1);
    corner(x0, y0), corner(x1, y1), corner(x0, y1);
  }
}

/// Breaks some positions: NaN, infinities, the largest number, a neighbour's place.
inline void break_some(HashedNumbers& random, std::vector<glm::vec3>& positions) {
  static constexpr float kBroken[] = {std::numeric_limits<float>::quiet_NaN(),
                                      std::numeric_limits<float>::infinity(),
                                      -std::numeric_limits<float>::infinity(),
                                      std::numeric_limits<float>::max(),
                                      -1e30f,
                                      1e7f,
                                      0.0f};
  for (std::size_t i = 1; i < positions.size(); ++i) {
    if (random.below(12) != 0) continue;
    if (random.below(2) == 0) {
      positions[i] = positions[random.below(std::uint32_t(i))];
    } else {
      positions[i][int(random.below(3))] = kBroken[random.below(std::size(kBroken))];
    }
  }
}

}  // namespace lode::raster::test
