#pragma once
/// Random draws: a mesh or a few primitives of any kind, with any attributes, material and state.

#include "random_meshes.h"

namespace lode::raster::test {

/// Textures of both formats, with and without mips, for all frames.
[[nodiscard]] inline const std::vector<Texture>& some_textures() {
  static const std::vector<Texture> textures = [] {
    HashedNumbers random(4);
    std::vector<glm::u8vec4> texels;
    for (int i = 0; i < 13 * 8; ++i) {
      const std::uint32_t r = random.below(256), g = random.below(256), b = random.below(256);
      texels.push_back(glm::u8vec4(glm::uvec4(r, g, b, i % 3 == 0 ? random.below(256) : 255)));
    }
    std::vector<Texture> made;
    made.push_back(make_raw_texture({13, 8}, texels, Mips::all));
    made.push_back(make_raw_texture({8, 13}, texels, Mips::none));
    made.push_back(make_raw_texture({1, 1}, {texels.data(), 1}, Mips::all));
    made.push_back(make_srgb_texture({13, 8}, texels, Mips::all));
    return made;
  }();
  return textures;
}

class RandomDraw {
 public:
  RandomDraw(HashedNumbers& random, const OwnedFrame& frame) : random_(random), frame_(frame) {
    full_ = frame.format == ColorFormat::rgba8 ? 255.0f : 1.0f;
  }

  /// A draw of about `most` primitives at most.
  [[nodiscard]] std::shared_ptr<const OwnedDraw> make(std::uint32_t most) {
    to_ = std::make_shared<OwnedDraw>();
    const std::uint32_t kind = random_.below(12);
    if (kind < 6) {
      add_object_triangles(most);
    } else if (kind < 8) {
      add_window_or_clip(Topology(random_.below(2)), 1 + random_.below(std::min(most, 24u)));
    } else {
      add_others(1 + random_.below(std::min(most, 12u)));
    }
    add_attributes();
    set_material();
    set_state();
    to_->bind();
    return to_;
  }

 private:
  [[nodiscard]] bool one_in(std::uint32_t n) { return random_.below(n) == 0; }
  [[nodiscard]] float unit() { return float(random_.unit()); }

  void add_object_triangles(std::uint32_t most) {
    OwnedDraw& d = *to_;
    const std::uint32_t shape = random_.below(7);
    const std::uint32_t n = 1 + random_.below(most);
    bool in_pixels = true;
    if (shape < 2) {
      add_soup(random_, frame_.size_px, n, d.object);
    } else if (shape == 2) {
      add_slivers(random_, frame_.size_px, n, d.object);
    } else if (shape == 3) {
      add_layers_of_quads(random_, frame_.size_px, (n + 1) / 2, d.object);
    } else {
      const std::uint32_t side = std::max(1u, std::uint32_t(std::sqrt(n / 2.0)));
      if (shape == 4) {
        add_ball(side + 2, side + 1, d);
      } else {
        add_grid(random_, side, side, d);
      }
      in_pixels = false;
    }
    if (in_pixels) {
      d.clip_from_object = clip_from_pixels(frame_.size_px);
      if (one_in(3)) add_perspective_to_pixels();
    } else {
      const double distance = one_in(3) ? 0.5 * random_.unit() : 1.0 + 4.0 * random_.unit();
      const glm::dvec3 from{random_.unit() - 0.5, random_.unit() - 0.5, distance};
      const double turn_rad = one_in(2) ? 0.0 : 0.7 * random_.unit();
      d.clip_from_object = perspective_from(from, turn_rad, one_in(3) ? 0.5 : 0.01);
    }
    if (one_in(6)) break_some(random_, d.object);
    if (one_in(24)) d.clip_from_object[int(random_.below(4))] *= one_in(2) ? 0.0 : -1.0;
    if (!d.indexed && one_in(4)) share_vertices();
    d.clustered = !one_in(4);
  }

  /// w that grows with depth or across the picture; at times through 0.
  void add_perspective_to_pixels() {
    glm::dmat4 tilt(1.0);
    const int axis = int(random_.below(3));
    const double reach = axis == 2 ? 1.0 : 2.0 / double(frame_.size_px[axis]);
    tilt[axis][3] = (one_in(4) ? -1.2 : 0.6) * reach * random_.unit();
    to_->clip_from_object = to_->clip_from_object * tilt;
  }

  /// Indices that pick among the positions at random.
  void share_vertices() {
    OwnedDraw& d = *to_;
    for (std::uint32_t i = 0; i < d.object.size(); ++i) {
      d.indices.push_back(one_in(5) ? random_.below(std::uint32_t(d.object.size())) : i);
    }
    d.indexed = true;
  }

  void add_window_or_clip(Topology topology, std::uint32_t n) {
    OwnedDraw& d = *to_;
    d.draw.topology = topology;
    std::vector<glm::vec3> p;
    while (p.size() < n * vertices_each(topology)) add_soup(random_, frame_.size_px, 1 + random_.below(4), p);
    p.resize(n * vertices_each(topology));
    if (one_in(3)) {
      for (const glm::vec3& q : p) {
        const double w = one_in(12) ? -random_.unit() : 0.25 + random_.unit();
        const glm::dvec2 ndc = 2.0 * glm::dvec2(q) / glm::dvec2(frame_.size_px) - 1.0;
        d.clip.push_back({ndc.x * w, -ndc.y * w, one_in(3) ? 0.25 : double(q.z) * w, w});
      }
    } else if (one_in(2) && topology != Topology::triangles) {
      d.object = p;
      d.clip_from_object = clip_from_pixels(frame_.size_px);
    } else {
      for (const glm::vec3& q : p) d.window.push_back(glm::dvec3(q));
      if (one_in(6)) d.window[random_.below(std::uint32_t(p.size()))].x = std::numeric_limits<double>::quiet_NaN();
    }
  }

  void add_others(std::uint32_t n) {
    OwnedDraw& d = *to_;
    const Topology topology = Topology(2 + random_.below(5));
    if (topology == Topology::surfels) {
      d.draw.topology = topology;
      for (std::uint32_t i = 0; i < n; ++i) {
        d.object.push_back({2.0f * unit() - 1.0f, 2.0f * unit() - 1.0f, unit()});
        d.normals.push_back({unit() - 0.5f, unit() - 0.5f, unit()});
      }
      const double distance = 1.0 + 3.0 * random_.unit();
      d.clip_from_object = perspective_from({0, 0, distance}, random_.unit(), 0.1);
    } else {
      add_window_or_clip(topology, n);
    }
    for (std::size_t i = 0; i < d.n_positions(); ++i) {
      d.radii.push_back(topology == Topology::discs ? 15.0f * unit() - 0.5f : unit());
    }
    d.draw.point_size_px = 6.0f * unit();
    if (one_in(3)) d.draw.stipple = Stipple{std::uint16_t(random_.below(65536)), random_.between(1, 5)};
  }

  void add_attributes() {
    OwnedDraw& d = *to_;
    const std::size_t n = d.n_positions();
    if (one_in(2)) {
      const bool wild = one_in(12);
      for (std::size_t i = 0; i < n; ++i) d.colors.push_back(color(wild && one_in(4)));
      if (one_in(4)) std::fill(d.colors.begin(), d.colors.end(), d.colors[0]);
    }
    if (one_in(3)) {
      const float scale = one_in(4) ? 50.0f : 2.0f;
      for (std::size_t i = 0; i < n; ++i) d.uvs.push_back({scale * (unit() - 0.5f), scale * (unit() - 0.25f)});
    }
    if (d.normals.empty() && one_in(3)) {
      for (std::size_t i = 0; i < n; ++i) d.normals.push_back({unit() - 0.5f, unit() - 0.5f, unit() - 0.5f});
    }
  }

  [[nodiscard]] glm::vec4 color(bool wild) {
    glm::vec4 c;
    for (int k = 0; k < 4; ++k) c[k] = full_ * unit();
    if (one_in(8)) c = glm::round(c);
    if (!wild) return c;
    static constexpr float kWild[] = {
        std::numeric_limits<float>::quiet_NaN(), std::numeric_limits<float>::infinity(), -20.0f, 1e30f, 300.0f, -0.0f};
    c[int(random_.below(4))] = kWild[random_.below(std::size(kWild))];
    return c;
  }

  void set_material() {
    Draw& draw = to_->draw;
    if (one_in(2)) draw.color = color(one_in(24));
    if (one_in(3)) {
      draw.texture = &some_textures()[random_.below(frame_.format == ColorFormat::rgba8 ? 3 : 4)];
      draw.sampler = {.filter = Filter(random_.below(4)),
                      .wrap_u = Wrap(random_.below(4)),
                      .wrap_v = Wrap(random_.below(4)),
                      .max_anisotropy = random_.between(1, 16)};
      draw.sampler.border = glm::vec4(draw.texture->format == TextureFormat::raw ? 51.0f : 0.25f);
    }
    if (one_in(4)) {
      MaterialShading shading;
      if (one_in(2)) shading.cut_out = CutOut{.cutoff = random_.unit(), .full = one_in(8) ? 2.0f : full_};
      if (shading.cut_out && one_in(3)) shading.cut_out->pixels = std::uint16_t(random_.below(0x10000));
      if (!shading.cut_out || one_in(2)) shading.light = lambert();
      draw.shader = material_shader(shading);
    } else if (one_in(8)) {
      draw.shader = pixel_shader([](const Pixel& p) {
        return p.material * (p.front_facing ? 1.0f : 0.5f) * p.depth +
               glm::vec4(float(p.primitive % 7), p.uv, p.normal.x);
      });
    }
  }

  [[nodiscard]] Lambert lambert() {
    Lambert l{.to_light = {0, 0.6f, 0.8f}};
    l.two_sided = one_in(2);
    l.turns_backs = one_in(2);
    l.front_is_clockwise = one_in(2);
    if (one_in(2)) return l;
    static constexpr float kScales[] = {1.0f, 1.0f, 1e30f, 1e-38f, std::numeric_limits<float>::infinity()};
    for (int column = 0; column < 3; ++column) {
      for (int row = 0; row < 3; ++row) l.light_from_normal[column][row] = unit() - 0.5f;
      l.light_from_normal[column] *= kScales[random_.below(std::size(kScales))];
    }
    return l;
  }

  void set_state() {
    Draw& draw = to_->draw;
    if (one_in(2)) draw.cull = Cull(random_.below(3));
    if (one_in(5)) draw.blend = Blend(random_.below(3));
    if (one_in(8)) draw.depth_test = false;
    if (one_in(8)) draw.depth_write = one_in(2);
    if (one_in(5)) draw.alpha_test = random_.unit();
    if (one_in(6)) {
      draw.scissor = Rect{{random_.between(-9, frame_.size_px.x), random_.between(-9, frame_.size_px.y)},
                          {random_.between(0, 64), random_.between(0, 64)}};
    }
    if (one_in(8)) draw.draw_id = random_.below(4);
    if (one_in(12)) draw.primitive_id = random_.below(4);
  }

  HashedNumbers& random_;
  const OwnedFrame& frame_;
  float full_ = 255.0f;
  std::shared_ptr<OwnedDraw> to_;
};

}  // namespace lode::raster::test
