#pragma once
/// Random textured triangles over a tile, as the kernels and the reference pipeline get them.

#include <algorithm>
#include <array>
#include <optional>
#include <vector>

#include "raster/fast/kernels.h"
#include "raster/fast/textured.h"
#include "texture_cases.h"

namespace lode::raster::test {

struct TexturedCase {
  Texture texture;
  std::vector<glm::vec2> uvs;
  std::vector<glm::vec4> colors;
  Draw draw;
  reference::Piece piece;
  glm::ivec2 tile_origin_px{0, 0};
  glm::ivec2 sample_fx8{128, 128};
};

/// Corners near the tile, in the guard band, or within two pixels of one another.
[[nodiscard]] inline std::array<glm::ivec2, 3> random_corners_fx8(HashedNumbers& random, glm::ivec2 origin_fx8) {
  const std::uint32_t kind = random.below(4);
  const int reach = kind == 0 ? reference::kGuard_fx8 - 16384 * 256 : kind == 1 ? 400 * 256 : 160 * 256;
  std::array<glm::ivec2, 3> corners;
  for (glm::ivec2& p : corners) {
    p = origin_fx8 + glm::ivec2(random.between(-reach, reach), random.between(-reach, reach));
    if (kind == 3) p = corners[0] + glm::ivec2(random.between(-512, 512), random.between(-512, 512));
  }
  if (kind == 2 && random.below(2) == 0)
    corners[2] = corners[1] + glm::ivec2(random.between(-9, 9), random.between(-9, 9));
  if (random.below(8) == 0)
    corners = {origin_fx8, origin_fx8 + glm::ivec2(32768, 0), origin_fx8 + glm::ivec2(0, 32768)};
  return corners;
}

/// A few texels across the tile, or many; sometimes on a grid, where coordinates meet ties, or all the same. Half of
/// them are as if most of a picture of 256 texels a side were across a tile, away from its edges.
inline void set_random_uvs(HashedNumbers& random, TexturedCase& c) {
  const double scale = random.of_magnitude(-12, 7);
  const std::uint32_t kind = random.below(8);
  const glm::vec2 centre = {float(random.unit()), float(random.unit())};
  const glm::ivec2 origin_fx8 = c.tile_origin_px * 256 + 64 * 256;
  const auto& corners = std::get<reference::Triangle>(c.piece.shape).v;
  for (int k = 0; k < 3; ++k) {
    glm::vec2 uv = {float((random.unit() - 0.5) * scale), float((random.unit() - 0.5) * scale)};
    if (kind == 0) uv = {float(random.between(-2, 2)), float(random.between(-2, 2))};
    if (kind == 1) uv = {float(random.between(-512, 512)) / 256.0f, float(random.between(-512, 512)) / 512.0f};
    if (kind == 2 && k > 0) uv = c.uvs[0];
    if (kind == 3) uv += 1000.0f;
    if (kind >= 4) {
      const auto place = std::find(c.piece.vertices.begin(), c.piece.vertices.end(), std::uint32_t(k));
      const glm::ivec2 p_fx8 = corners[std::size_t(place - c.piece.vertices.begin())].p_fx8;
      const glm::vec2 p = glm::vec2(p_fx8 - origin_fx8) / 65536.0f;
      uv = centre + float(kind - 3) * 0.4f * glm::vec2(p.x - 0.7f * p.y, 0.6f * p.x + p.y);
    }
    c.uvs.push_back(uv);
  }
}

inline void set_random_colors(HashedNumbers& random, TexturedCase& c) {
  const auto color = [&] {
    glm::vec4 value;
    for (int k = 0; k < 4; ++k) value[k] = float(random.unit() * 300.0 - 20.0);
    return value;
  };
  if (random.below(3) == 0) c.draw.color = color();
  if (random.below(3) == 0) c.colors = {color(), color(), color()};
  c.draw.colors = c.colors;
}

/// Nothing if the corners span no area. `c` must stay where it is: its draw points into it.
[[nodiscard]] inline bool make_textured_case(HashedNumbers& random, TexturedCase& c) {
  constexpr Filter kFilters[] = {Filter::nearest, Filter::bilinear, Filter::trilinear};
  constexpr glm::ivec2 kSizes[] = {{1, 1}, {3, 7}, {16, 16}, {256, 256}, {64, 8}, {100, 37}};
  c.tile_origin_px = {128 * random.between(0, 20), 128 * random.between(0, 20)};
  c.sample_fx8 = random.below(2) == 0 ? glm::ivec2(128) : glm::ivec2(random.below(256), random.below(256));
  const std::array<glm::ivec2, 3> corners = random_corners_fx8(random, c.tile_origin_px * 256);
  std::array<reference::WindowVertex, 3> vertices;
  const bool affine = random.below(2) == 0;
  const int w_range = random.below(4) == 0 ? 30 : 3;
  const double w = random.of_magnitude(-5, 5);
  for (std::size_t k = 0; k < 3; ++k) {
    vertices[k] = {corners[k], random.unit(), affine ? w : random.of_magnitude(-w_range, w_range)};
  }
  std::array<int, 3> order;
  std::optional<reference::Triangle> triangle = reference::make_triangle(vertices, order);
  if (!triangle) return false;
  c.piece.shape = *triangle;
  c.piece.n_vertices = 3;
  for (std::size_t k = 0; k < 3; ++k) c.piece.vertices[k] = std::uint32_t(order[k]);

  const glm::ivec2 size_px = kSizes[random.below(6)];
  c.texture = make_raw_texture(size_px, random_texels(random, size_px), random.below(4) == 0 ? Mips::none : Mips::all);
  set_random_uvs(random, c);
  set_random_colors(random, c);
  c.draw.uvs = c.uvs;
  c.draw.texture = &c.texture;
  c.draw.sampler.filter = kFilters[random.below(3)];
  c.draw.sampler.wrap_u = kWraps[random.below(3)];
  c.draw.sampler.wrap_v = kWraps[random.below(3)];
  return true;
}

}  // namespace lode::raster::test
