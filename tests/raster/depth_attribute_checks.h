#pragma once
/// Pictures of random triangles and lines, each sample's depth and colour held against interpolation_oracle.h. The
/// quick and the stress tests differ in their counts only.

#include <vector>

#include "hashed_numbers.h"
#include "interpolation_oracle.h"
#include "small_scene.h"

namespace lode::raster::test {

/// What a check found. Contract: depth_ulp ≤ 0.501, attribute_ulp ≤ 4, the counts 0.
struct Measured {
  std::uint64_t samples = 0;
  double depth_ulp = 0.0;
  double attribute_ulp = 0.0;
  std::uint64_t outside_hull = 0;    ///< depth or attribute beyond its vertices' values
  std::uint64_t constant_moved = 0;  ///< an attribute equal at all vertices that is not so inside
};

inline void print(const char* what, const Measured& m) {
  std::printf("[ MEASURED ] %s: %llu samples, depth %.6f ULP, attributes %.4f ULP\n", what,
              static_cast<unsigned long long>(m.samples), m.depth_ulp, m.attribute_ulp);
}
inline void expect_contract(const Measured& m) {
  EXPECT_LE(m.depth_ulp, 0.501);
  EXPECT_LE(m.attribute_ulp, 4.0);
  EXPECT_EQ(m.outside_hull, 0u);
  EXPECT_EQ(m.constant_moved, 0u);
}

/// A triangle, or a line in its first two corners.
struct CornerData {
  std::array<glm::ivec2, 3> p_fx8;
  std::array<double, 3> z{};
  std::array<std::int64_t, 3> w{1, 1, 1};
  std::array<glm::vec4, 3> color;  ///< r, g, b vary, a is the same at all
};

/// Which primitives: through clip space with w up to 2^20 (then z = 1/w), or in window space (w = 1).
struct Family {
  Topology topology = Topology::triangles;
  bool perspective = true;
  glm::ivec2 size_px{128, 128};  ///< a power of two, so that clip space holds the corners exactly
  int primitives = 24;
};

/// A float of 10 to 24 bits before the point.
inline float whole_attribute(HashedNumbers& numbers) {
  const std::uint32_t size = (1u << 9) << (1 + numbers.below(14));
  const float value = float(size + numbers.below(size));
  return numbers.below(2) == 0 ? value : -value;
}

inline CornerData random_corners(HashedNumbers& numbers, const Family& family) {
  CornerData c;
  const int n = family.topology == Topology::lines ? 2 : 3;
  const glm::ivec2 size_fx8 = 256 * family.size_px;
  const auto near_target = [&] {
    return glm::ivec2{numbers.between(-size_fx8.x, 2 * size_fx8.x), numbers.between(-size_fx8.y, 2 * size_fx8.y)};
  };
  const auto in_guard_band = [&] {
    return glm::ivec2{numbers.between(-(1 << 23), 1 << 23), numbers.between(-(1 << 23), 1 << 23)};
  };
  const bool far_reaching = !family.perspective && numbers.below(2) == 0;
  c.p_fx8[0] = far_reaching ? in_guard_band() : near_target();
  c.p_fx8[1] = far_reaching ? in_guard_band() : near_target();
  c.p_fx8[2] = near_target();
  const std::uint32_t shape = numbers.below(4);
  if (shape < 2) {
    // Around a point of the target: the last corner lies opposite the others.
    const glm::dvec2 p = {numbers.unit() * size_fx8.x, numbers.unit() * size_fx8.y};
    const double s = numbers.unit(), t = numbers.unit();
    const glm::dvec2 opposite = n == 2 ? p + s * (p - glm::dvec2(c.p_fx8[0]))
                                       : p + s * (p - glm::dvec2(c.p_fx8[0])) + t * (p - glm::dvec2(c.p_fx8[1]));
    const double limit = family.perspective ? 4.0 * size_fx8.x : 8388608.0;
    c.p_fx8[std::size_t(n - 1)] = glm::ivec2(glm::clamp(opposite, -limit, limit));
  } else if (shape == 2) {
    // A sliver: the last corner a few sub-pixels beside a point of the first side.
    const double s = numbers.unit();
    c.p_fx8[2] = glm::ivec2(glm::mix(glm::dvec2(c.p_fx8[0]), glm::dvec2(c.p_fx8[1]), s)) +
                 glm::ivec2{numbers.between(-3, 3), numbers.between(-3, 3)};
  }
  const float constant = float(numbers.unit() * 1000.0);
  const bool same_w = numbers.below(4) == 0;
  for (std::size_t i = 0; i < 3; ++i) {
    if (family.perspective) {
      const std::int64_t scale = std::int64_t(1) << numbers.below(20);
      c.w[i] = same_w && i > 0 ? c.w[0] : scale + std::int64_t(numbers.below(std::uint32_t(scale) + 1));
      c.z[i] = 1.0 / double(c.w[i]);
    } else {
      const double whole = double(numbers.bits() >> 4);
      c.z[i] = std::ldexp(std::rint(whole / double(1u << numbers.below(24))), -60);
    }
    c.color[i] = {whole_attribute(numbers), whole_attribute(numbers), whole_attribute(numbers), constant};
  }
  return c;
}

/// Puts corners into clip space so that they land exactly on their snapped positions.
inline glm::dvec4 clip_corner(const CornerData& c, std::size_t i, glm::ivec2 size_px) {
  const glm::dvec2 half_fx8 = 128.0 * glm::dvec2(size_px);
  const double w = double(c.w[i]);
  return {(c.p_fx8[i].x - half_fx8.x) / half_fx8.x * w, (half_fx8.y - c.p_fx8[i].y) / half_fx8.y * w, 1.0, w};
}

inline void add_corners(SmallScene& scene, const std::vector<CornerData>& all, const Family& family) {
  const std::size_t n = family.topology == Topology::lines ? 2 : 3;
  std::vector<glm::dvec3> window;
  std::vector<glm::dvec4> clip;
  std::vector<glm::vec4> colors;
  for (const CornerData& c : all) {
    for (std::size_t i = 0; i < n; ++i) {
      if (family.perspective) clip.push_back(clip_corner(c, i, family.size_px));
      if (!family.perspective) window.push_back({c.p_fx8[i].x / 256.0, c.p_fx8[i].y / 256.0, c.z[i]});
      colors.push_back(c.color[i]);
    }
  }
  Draw& draw = family.perspective ? scene.clip(family.topology, std::move(clip))
                                  : scene.window(family.topology, std::move(window));
  draw.colors = scene.keep(std::move(colors));
}

inline EdgeValues edges_at(const CornerData& c, Topology topology, glm::ivec2 p_fx8) {
  return topology == Topology::lines ? line_edges(c.p_fx8, p_fx8) : triangle_edges(c.p_fx8, p_fx8);
}

/// Draws pictures of the family until `n_samples` have been checked.
inline Measured check_pictures(const Family& family, std::uint64_t n_samples, std::uint64_t seed) {
  Measured m;
  HashedNumbers numbers(seed);
  const bool line = family.topology == Topology::lines;
  while (m.samples < n_samples) {
    std::vector<CornerData> all;
    for (int k = 0; k < family.primitives; ++k) all.push_back(random_corners(numbers, family));
    SmallScene scene(family.size_px, ColorFormat::rgba32f);
    add_corners(scene, all, family);
    scene.render();
    for (std::size_t i = 0; i < scene.image.ids.size(); ++i) {
      if (scene.image.ids[i].draw == kNoId) continue;
      ++m.samples;
      const CornerData& c = all[scene.image.ids[i].primitive];
      const glm::ivec2 pixel = {int(i) % family.size_px.x, int(i) / family.size_px.x};
      EdgeValues e = edges_at(c, family.topology, 256 * pixel + 128);
      const std::array<double, 3> z = {c.z[0], c.z[1], line ? c.z[1] : c.z[2]};
      const float depth = scene.image.depth[i];
      m.depth_ulp = std::max(m.depth_ulp, depth_error_ulp(depth, e, z, family.perspective ? 73 : 60));
      const auto [low, high] = std::minmax({float(z[0]), float(z[1]), float(z[2])});
      if (depth < low || depth > high) ++m.outside_hull;
      for (int channel = 0; channel < 3; ++channel) {
        const float got = scene.image.rgba32f[i][channel];
        const std::array<float, 3> a = {c.color[0][channel], c.color[1][channel], c.color[line ? 1 : 2][channel]};
        m.attribute_ulp = std::max(m.attribute_ulp, attribute_error_ulp(got, e, c.w, a));
        if (got < std::min({a[0], a[1], a[2]}) || got > std::max({a[0], a[1], a[2]})) ++m.outside_hull;
      }
      if (scene.image.rgba32f[i].a != c.color[0].a) ++m.constant_moved;
    }
  }
  return m;
}

}  // namespace lode::raster::test
