#pragma once
/// One small frame that uses everything the rasterizer has: what must hold for any frame is tried on this one.

#include "hashed_numbers.h"
#include "small_scene.h"

namespace lode::raster::test {

/// A reversed-depth perspective with an infinite far plane, looking down −z: depth near/d.
inline glm::dmat4 perspective(double near) {
  glm::dmat4 m(0.0);
  m[0][0] = 1.0;
  m[1][1] = 1.5;
  m[3][2] = near;
  m[2][3] = -1.0;
  return m;
}

/// Adds draws of every kind, in a frame of any size from 32×16 up: solid, cut out, blended, textured, lit, clipped at
/// the near plane and the guard band, stippled, culled, partly NaN.
inline void add_everything(SmallScene& scene) {
  HashedNumbers numbers(2024);
  const bool bytes = scene.image.format == ColorFormat::rgba8;
  const float full = bytes ? 255.0f : 1.0f;
  const auto unit = [&] { return float(numbers.unit()); };
  const auto random_colors = [&](std::size_t n) {
    std::vector<glm::vec4> colors;
    for (std::size_t i = 0; i < n; ++i) colors.push_back(glm::vec4{unit(), unit(), unit(), unit()} * full);
    return scene.keep(std::move(colors));
  };
  const auto random_uvs = [&](std::size_t n) {
    std::vector<glm::vec2> uvs;
    for (std::size_t i = 0; i < n; ++i) uvs.push_back({3.0f * unit() - 1.0f, 3.0f * unit() - 1.0f});
    return scene.keep(std::move(uvs));
  };
  const double w = scene.image.size_px.x, h = scene.image.size_px.y;
  const auto random_window = [&](std::size_t n) {
    std::vector<glm::dvec3> p;
    for (std::size_t i = 0; i < n; ++i) p.push_back({(1.2 * unit() - 0.1) * w, (1.2 * unit() - 0.1) * h, unit()});
    return p;
  };
  std::vector<glm::u8vec4> texels;
  for (int i = 0; i < 8 * 5; ++i)
    texels.push_back(
        glm::u8vec4(glm::uvec4{numbers.below(256), numbers.below(256), numbers.below(256), i % 3 == 0 ? 40u : 255u}));
  const Texture* texture = &scene.keep(std::vector<Texture>{make_raw_texture({8, 5}, texels, Mips::all)})[0];

  Draw& ground =
      scene.object(Topology::quads, {{-9, -1, 3}, {9, -1, 3}, {30, -1, -80}, {-30, -1, -80}}, perspective(0.1));
  ground.uvs = random_uvs(4);  // behind the eye at one end, so clipped
  ground.texture = texture;
  ground.sampler = {.filter = Filter::anisotropic, .wrap_u = Wrap::repeat, .wrap_v = Wrap::mirror};

  Draw& mesh =
      scene.object(Topology::triangles,
                   {{-2, -1, -4}, {1, -1, -3}, {0, 1.5f, -5}, {2, 1, -2}, {-3, 2, -9}, {-1, 0, -1}}, perspective(0.1));
  mesh.indices = scene.keep<std::uint32_t>({0, 1, 2, 1, 3, 2, 4, 0, 2, 5, 1, 0, 3, 4, 5});
  mesh.normals = scene.keep<glm::vec3>({{0, 0, 1}, {1, 0, 1}, {0, 1, 0}, {-1, 0, 0}, {0, 0, 0}, {1, 1, 1}});
  mesh.colors = random_colors(6);
  mesh.shader = lambert_shader({.to_light = {0, 0.6f, 0.8f}, .two_sided = true});
  mesh.cull = Cull::back;

  scene
      .clip(Topology::triangles,
            {{-5e5, -0.2, 0.2, 1}, {8e5, 0.1, 0.9, 1}, {0, 0.3, 0.4, 1}, {0, 0, 2, 1}, {1, 0, 2, 1}, {0, 1, 2, 1}})
      .colors = random_colors(6);
  scene.window(Topology::triangles, random_window(60)).colors = random_colors(60);

  Draw& cut_out = scene.window(Topology::triangles, random_window(24));
  cut_out.uvs = random_uvs(24);
  cut_out.texture = texture;
  cut_out.sampler = {.filter = Filter::trilinear, .wrap_u = Wrap::clamp, .wrap_v = Wrap::border};
  cut_out.alpha_test = 0.5f;

  Draw& lines = scene.window(Topology::lines, random_window(40));
  lines.colors = random_colors(40);
  lines.stipple = Stipple{0x3F35, 2};
  Draw& strip = scene.window(Topology::line_strip, random_window(20));
  strip.stipple = Stipple{0x0F0F, 3};
  strip.blend = Blend::over;
  strip.color = glm::vec4(0.25f, 0.5f, 0.0f, 0.5f) * full;
  strip.depth_test = false;
  scene.object(Topology::lines, {{0, 0, 5}, {1, 1, -7}, {-1, 0, -2}, {1, -0.5f, -3}}, perspective(0.1)).colors =
      random_colors(4);

  Draw& points = scene.window(Topology::points, random_window(12));
  points.point_size_px = 3.3f;
  points.colors = random_colors(12);
  Draw& discs = scene.window(Topology::discs, random_window(9));
  discs.radii = scene.keep<float>({9, 2.5f, 0, -1, 14, 0.3f, 12, 11.75f, std::numeric_limits<float>::quiet_NaN()});
  discs.texture = texture;
  discs.blend = Blend::add;
  discs.color = glm::vec4(0.5f) * full;

  Draw& surfels = scene.object(Topology::surfels, {{-1, 0, -4}, {0, 0.5f, -3.6f}, {1, -0.5f, -6}, {0.5f, 0.5f, -5}},
                               perspective(3.5));
  surfels.normals = scene.keep<glm::vec3>({{0, 0, 1}, {1, 1, 1}, {0, 1, 0.2f}, {0, 0, 0}});
  surfels.radii = scene.keep<float>({0.5f, 0.4f, 1.5f, 1.0f});
  surfels.colors = random_colors(4);

  Draw& glass = scene.window(
      Topology::quads,
      {{0, 0, 0.98}, {w, 0, 0.6}, {w, h, 0.9}, {0, h, 0.2}, {1, 1, 0.9}, {w, 2, 0.99}, {9, h, 0.4}, {2, h, 0.1}});
  glass.blend = Blend::over;
  glass.depth_write = true;
  glass.colors = random_colors(8);
  glass.scissor = Rect{{3, 2}, {25, 12}};

  std::vector<glm::dvec3> broken = random_window(9);
  broken[4].x = std::numeric_limits<double>::quiet_NaN();
  Draw& last = scene.window(Topology::triangles, broken);
  last.draw_id = 0;
  last.primitive_id = 4294967294u;
  last.shader = pixel_shader([](const Pixel& p) { return p.color * (((p.x_px ^ p.y_px) & 1) != 0 ? 0.25f : 1.0f); });
  scene.frame.clear = glm::vec4(0.1f, 0.2f, 0.3f, 1.0f) * full;
}

}  // namespace lode::raster::test
