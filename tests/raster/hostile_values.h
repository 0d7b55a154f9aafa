#pragma once
/// Numbers that break programs, and frames made of nothing else.

#include <bit>
#include <limits>

#include "hashed_numbers.h"
#include "raster/error.h"
#include "small_scene.h"

namespace lode::raster::test {

template <class Float>
inline constexpr Float kHostile[] = {std::numeric_limits<Float>::quiet_NaN(),
                                     std::numeric_limits<Float>::infinity(),
                                     -std::numeric_limits<Float>::infinity(),
                                     Float(0),
                                     -Float(0),
                                     std::numeric_limits<Float>::denorm_min(),
                                     -std::numeric_limits<Float>::denorm_min(),
                                     std::numeric_limits<Float>::min(),
                                     std::numeric_limits<Float>::max(),
                                     -std::numeric_limits<Float>::max(),
                                     Float(std::numeric_limits<float>::max()),
                                     Float(1e30),
                                     Float(-1e-30),
                                     Float(1),
                                     Float(-1),
                                     Float(0.5),
                                     Float(7.5)};

/// Some of them half of the time, else a number about as large as a small picture.
template <class Float>
Float hostile(HashedNumbers& numbers) {
  const std::uint32_t n = std::size(kHostile<Float>);
  const std::uint32_t k = numbers.below(2 * n);
  return k < n ? kHostile<Float>[k] : Float(20.0 * numbers.unit() - 4.0);
}
template <class Vector>
std::vector<Vector> hostile_vectors(HashedNumbers& numbers, std::size_t n) {
  std::vector<Vector> vectors(n);
  for (Vector& v : vectors) {
    for (int c = 0; c < Vector::length(); ++c) v[c] = hostile<typename Vector::value_type>(numbers);
  }
  return vectors;
}

/// A draw of any topology, space and state whose every number may be hostile. Window positions stay in the guard band,
/// which is checked, or are NaN.
inline void add_hostile_draw(SmallScene& scene, HashedNumbers& numbers, const Texture* texture) {
  const auto topology = Topology(numbers.below(7));
  const std::size_t n = 12;
  const std::uint32_t space = topology == Topology::surfels ? 0 : numbers.below(3);
  Draw* draw = nullptr;
  if (space == 0) {
    glm::dmat4 matrix(1.0);
    for (int i = 0; i < 4; ++i) {
      for (int j = 0; j < 4; ++j) {
        if (numbers.below(6) == 0) matrix[i][j] = hostile<double>(numbers);
      }
    }
    draw = &scene.object(topology, hostile_vectors<glm::vec3>(numbers, n), matrix);
  } else if (space == 1) {
    draw = &scene.clip(topology, hostile_vectors<glm::dvec4>(numbers, n));
  } else {
    std::vector<glm::dvec3> p = hostile_vectors<glm::dvec3>(numbers, n);
    for (glm::dvec3& v : p) {
      for (int c = 0; c < 2; ++c) {
        if (std::abs(v[c]) > 32768.0) v[c] = v[c] > 0.0 ? 32768.0 : -32768.0;
      }
    }
    draw = &scene.window(topology, p);
  }
  if (numbers.below(2) == 0) draw->colors = scene.keep(hostile_vectors<glm::vec4>(numbers, n));
  if (numbers.below(2) == 0 || topology == Topology::surfels)
    draw->normals = scene.keep(hostile_vectors<glm::vec3>(numbers, n));
  if (numbers.below(2) == 0) draw->uvs = scene.keep(hostile_vectors<glm::vec2>(numbers, n));
  std::vector<float> radii;
  for (std::size_t i = 0; i < n; ++i) radii.push_back(hostile<float>(numbers));
  draw->radii = scene.keep(radii);
  draw->point_size_px = hostile<float>(numbers);
  if (numbers.below(2) == 0) draw->color = hostile_vectors<glm::vec4>(numbers, 1)[0];
  if (numbers.below(2) == 0) draw->texture = texture;
  draw->sampler = {.filter = Filter(numbers.below(4)),
                   .wrap_u = Wrap(numbers.below(4)),
                   .wrap_v = Wrap(numbers.below(4)),
                   .max_anisotropy = numbers.between(1, 16),
                   .border = hostile_vectors<glm::vec4>(numbers, 1)[0]};
  if (numbers.below(3) == 0) draw->shader = lambert_shader({.to_light = {0, 0.6f, 0.8f}});
  draw->cull = Cull(numbers.below(3));
  draw->blend = numbers.below(3) == 0 ? Blend(numbers.below(3)) : Blend::none;
  draw->depth_test = numbers.below(4) != 0;
  if (numbers.below(4) == 0) draw->depth_write = numbers.below(2) == 0;
  if (numbers.below(4) == 0) {
    const float threshold = hostile<float>(numbers);
    if (!std::isnan(threshold)) draw->alpha_test = threshold;
  }
  if (numbers.below(4) == 0) draw->stipple = Stipple{std::uint16_t(numbers.below(65536)), numbers.between(1, 256)};
}

constexpr std::size_t kLayers = 100'000;

/// All in one draw: a triangle that covers a picture of this size, again and again.
inline Draw& add_layers(SmallScene& scene, int size_px) {
  const double reach = 2.0 * size_px;
  Draw& draw = scene.window(Topology::triangles, {{0, 0, 0.5}, {reach, 0, 0.5}, {0, reach, 0.5}});
  std::vector<std::uint32_t> indices(3 * kLayers);
  for (std::size_t i = 0; i < indices.size(); ++i) indices[i] = std::uint32_t(i % 3);
  draw.indices = scene.keep(std::move(indices));
  return draw;
}

/// What holds for any picture: depths in [0, 1] with one zero, depth 0 and no id or an id of a draw, no NaN but
/// 0x7FC00000, no −0.
inline void expect_sound(const Image& image, std::size_t n_draws) {
  for (std::size_t i = 0; i < image.depth.size(); ++i) {
    ASSERT_GE(image.depth[i], 0.0f);
    ASSERT_LE(image.depth[i], 1.0f);
    ASSERT_FALSE(std::signbit(image.depth[i]));
    if (image.ids[i].draw == kNoId) {
      ASSERT_EQ(image.depth[i], 0.0f);
    } else {
      ASSERT_LT(image.ids[i].draw, n_draws);
    }
  }
  for (const glm::vec4& color : image.rgba32f) {
    for (int c = 0; c < 4; ++c) {
      const auto bits = std::bit_cast<std::uint32_t>(color[c]);
      ASSERT_TRUE(!std::isnan(color[c]) || bits == 0x7FC00000u);
      ASSERT_NE(bits, 0x80000000u);
    }
  }
}

/// Draws hostile frames; each twice, with other threads and tiles: the same bytes.
inline void draw_hostile_frames(std::uint64_t n_frames, std::uint64_t seed) {
  std::vector<glm::vec4> texels = {
      {1, 0.5f, 0, 1}, {std::numeric_limits<float>::quiet_NaN(), 1, 1, 0.5f}, {1e38f, -1, 0, 1}};
  const Texture floats = make_linear_texture({3, 1}, texels, Mips::all);
  const std::vector<glm::u8vec4> bytes(21, glm::u8vec4(200, 100, 50, 150));
  const Texture raw = make_raw_texture({3, 7}, bytes, Mips::all);
  for (std::uint64_t k = 0; k < n_frames; ++k) {
    HashedNumbers numbers(seed * 1'000'000'007u + k);
    const ColorFormat format = numbers.below(2) == 0 ? ColorFormat::rgba8 : ColorFormat::rgba32f;
    SmallScene scene({1 + int(numbers.below(17)), 1 + int(numbers.below(17))}, format);
    const Texture* texture = format == ColorFormat::rgba8 || numbers.below(2) == 0 ? &raw : &floats;
    for (int d = 0; d < 4; ++d) add_hostile_draw(scene, numbers, texture);
    scene.frame.clear = hostile_vectors<glm::vec4>(numbers, 1)[0];
    if (numbers.below(4) == 0)
      scene.frame.viewport = Rect{{numbers.between(-65536, 65536), numbers.between(-9, 9)},
                                  {int(numbers.below(65537)), int(numbers.below(40))}};
    scene.render({.threads = 1, .tile_size_px = 8});
    expect_sound(scene.image, scene.draws.size());
    const Image first = scene.image;
    scene.render({.threads = k % 16 == 0 ? 2 : 1, .tile_size_px = 32});
    ASSERT_TRUE(same_bytes(first, scene.image)) << "frame " << k << " of seed " << seed;
  }
}

}  // namespace lode::raster::test
