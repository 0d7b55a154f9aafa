#pragma once
/// The part of C5 and C7 that 128-bit integers cannot hold, in GMP rationals: any finite numbers, texture coordinates
/// and their derivatives, clipped triangles.

#include <bit>

#include "depth_attribute_checks.h"
#include "raster/reference/assemble.h"

namespace lode::raster::test {

inline mpq_class rational(std::int64_t value) { return mpq_class(mpz_class(std::to_string(value))); }

/// The float nearest to an exact value, ties to even: get_d cuts off, and a last bit set for what was cut breaks no tie
/// the wrong way.
inline float nearest_float(const mpq_class& exact) {
  double cut = exact.get_d();
  if (mpq_class(cut) != exact) cut = std::bit_cast<double>(std::bit_cast<std::uint64_t>(cut) | 1u);
  return float(cut);
}

// ---- Any finite numbers -------------------------------------------------------------------------------------------

struct RationalMeasured : Measured {
  std::uint64_t other_bits = 0;  ///< attributes that are not the written sum of correctly rounded weights
};
inline void expect_contract(const RationalMeasured& m) {
  expect_contract(static_cast<const Measured&>(m));
  EXPECT_EQ(m.other_bits, 0u);
}

/// Any finite float, each exponent as likely as any other.
inline float any_float(HashedNumbers& numbers) {
  const auto value = std::bit_cast<float>(static_cast<std::uint32_t>(numbers.bits() >> 32));
  return std::isfinite(value) ? value : -0.0f;
}

/// C7's sum, in the order given.
inline float written_sum(const std::array<float, 3>& b, const std::array<float, 3>& a, std::size_t n) {
  float sum = b[0] * a[0] + b[1] * a[1];
  if (n == 3) sum = sum + b[2] * a[2];
  return std::clamp(sum, std::min({a[0], a[1], a[n - 1]}), std::max({a[0], a[1], a[n - 1]}));
}

/// Triangles and lines with w from 2^-140 to 2^100, depths down to denormal doubles, any finite attributes.
inline RationalMeasured check_any_numbers(std::uint64_t n_samples, std::uint64_t seed) {
  RationalMeasured m;
  HashedNumbers numbers(seed);
  constexpr glm::ivec2 kSize{32, 32};
  while (m.samples < n_samples) {
    const bool line = numbers.below(4) == 0;
    const std::size_t n = line ? 2 : 3;
    const Family family{line ? Topology::lines : Topology::triangles, true, kSize, 1};
    CornerData c = random_corners(numbers, family);
    std::array<double, 3> w{}, z{};
    std::vector<glm::dvec4> p;
    std::vector<glm::vec4> colors;
    const bool same_w = numbers.below(4) == 0;
    for (std::size_t i = 0; i < n; ++i) {
      c.w[i] = 1;
      glm::dvec4 corner = clip_corner(c, i, kSize);
      const double w_mantissa = 1.0 + numbers.unit(), z_mantissa = numbers.unit();
      w[i] = same_w && i > 0 ? w[0] : std::ldexp(w_mantissa, numbers.between(-140, 100));
      corner *= w[i];
      corner.z = z_mantissa * w[i] * std::ldexp(1.0, numbers.below(3) == 0 ? -int(numbers.below(900)) : 0);
      z[i] = corner.z / w[i];
      p.push_back(corner);
      colors.push_back({any_float(numbers), any_float(numbers), any_float(numbers), 1.0f});
    }
    SmallScene scene(kSize, ColorFormat::rgba32f);
    scene.clip(family.topology, p).colors = scene.keep(colors);
    scene.render();
    std::array<std::size_t, 3> order = {0, 1, 2};  // canonical: by x, then y
    if (!line) {
      std::sort(order.begin(), order.end(), [&](std::size_t i, std::size_t j) {
        return std::pair(c.p_fx8[i].x, c.p_fx8[i].y) < std::pair(c.p_fx8[j].x, c.p_fx8[j].y);
      });
    }
    const std::size_t stride = 1 + numbers.below(7);  // not all samples of one triangle
    for (std::size_t k = 0; k < scene.image.ids.size(); k += stride) {
      if (scene.image.ids[k].draw == kNoId) continue;
      ++m.samples;
      const EdgeValues e = edges_at(c, family.topology, 256 * glm::ivec2(int(k) % kSize.x, int(k) / kSize.x) + 128);
      const mpq_class depth = exact_mean(e, {1, 1, 1}, {z[0], z[1], line ? 0.0 : z[2]});
      m.depth_ulp = std::max(m.depth_ulp, error_in(scene.image.depth[k], depth, ulp_exponent(depth)));
      std::array<float, 3> b{};
      for (std::size_t i = 0; i < n; ++i) {
        std::array<double, 3> one{};
        one[order[i]] = 1.0;
        b[i] = nearest_float(exact_mean(e, same_w ? std::array{1.0, 1.0, 1.0} : w, one));
      }
      for (int channel = 0; channel < 3; ++channel) {
        std::array<float, 3> a{};
        for (std::size_t i = 0; i < n; ++i) a[i] = colors[order[i]][channel];
        const float got = scene.image.rgba32f[k][channel];
        if (got != written_sum(b, a, n)) ++m.other_bits;
        const float last = a[n - 1], low = std::min({a[0], a[1], last}), high = std::max({a[0], a[1], last});
        if (got < low || got > high) ++m.outside_hull;
        const std::array<double, 3> original = {colors[0][channel], colors[1][channel],
                                                line ? 0.0f : colors[2][channel]};
        m.attribute_ulp = std::max(
            m.attribute_ulp, error_in(got, exact_mean(e, w, original), ulp_exponent(double(std::max(-low, high)))));
      }
      if (scene.image.rgba32f[k].a != 1.0f) ++m.constant_moved;
    }
  }
  return m;
}

// ---- Texture coordinates and derivatives --------------------------------------------------------------------------

/// In units of u = 2^-53 · max|uᵢ|, derivatives of u · Σ|∂qᵢ|/Σqᵢ. A coordinate takes at most 6 roundings on its way:
/// the quotients, their sum (2), the weights, products, sums (2). In a derivative each of uᵢ − u carries those, one
/// more, and is at most 2 max|uᵢ|; ∂qᵢ, product, sums, Σqᵢ and quotient add 7 roundings of it.
struct FootprintMeasured {
  static constexpr double kMostCoordinate = 8.0, kMostDerivative = 24.0;
  std::uint64_t samples = 0;
  double coordinate = 0.0, derivative = 0.0;
  std::uint64_t outside_hull = 0;
};
inline void print(const FootprintMeasured& m) {
  std::printf("[ MEASURED ] footprints: %llu samples, coordinates %.3f u, derivatives %.3f u\n",
              static_cast<unsigned long long>(m.samples), m.coordinate, m.derivative);
}
inline void expect_contract(const FootprintMeasured& m) {
  EXPECT_LE(m.coordinate, FootprintMeasured::kMostCoordinate);
  EXPECT_LE(m.derivative, FootprintMeasured::kMostDerivative);
  EXPECT_EQ(m.outside_hull, 0u);
}

inline FootprintMeasured check_footprints(std::uint64_t n_samples, std::uint64_t seed) {
  FootprintMeasured m;
  HashedNumbers numbers(seed);
  while (m.samples < n_samples) {
    const CornerData c =
        random_corners(numbers, {.topology = Topology::triangles, .perspective = numbers.below(2) == 0});
    std::array<reference::WindowVertex, 3> corners;
    std::array<glm::vec2, 3> uv_of_corner;
    const float largest = std::ldexp(1.0f, int(numbers.below(30)) - 10);
    for (std::size_t i = 0; i < 3; ++i) {
      corners[i] = {c.p_fx8[i], 0.5, double(c.w[i])};
      uv_of_corner[i] = largest * glm::vec2{2.0 * numbers.unit() - 1.0, 2.0 * numbers.unit() - 1.0};
    }
    std::array<int, 3> order;
    const std::optional<reference::Triangle> triangle = reference::make_triangle(corners, order);
    if (!triangle) continue;
    reference::VertexUvs uvs;
    uvs.emplace();
    for (std::size_t i = 0; i < 3; ++i) (*uvs)[i] = uv_of_corner[std::size_t(order[i])];

    // A point of the triangle, its outline or near it.
    double t[2] = {numbers.unit(), numbers.unit()};
    if (t[0] + t[1] > 1.0) t[0] = 1.0 - t[0], t[1] = 1.0 - t[1];
    const glm::dvec2 a = c.p_fx8[0], ab = glm::dvec2(c.p_fx8[1]) - a, ac = glm::dvec2(c.p_fx8[2]) - a;
    const glm::ivec2 p =
        numbers.below(8) == 0 ? c.p_fx8[numbers.below(3)] : glm::ivec2(glm::floor(a + t[0] * ab + t[1] * ac));
    const EdgeValues e = triangle_edges(c.p_fx8, p);
    if (std::min({e[0], e[1], e[2]}) < 0) continue;
    ++m.samples;

    const Footprint f = reference::footprint_at(*triangle, uvs, p);
    const EdgeValues right = triangle_edges(c.p_fx8, p + glm::ivec2(256, 0)),
                     down = triangle_edges(c.p_fx8, p + glm::ivec2(0, 256));
    for (int axis = 0; axis < 2; ++axis) {
      mpq_class q_sum = 0, qu_sum = 0;
      mpq_class slope[2] = {0, 0}, size[2] = {0, 0};
      double max_u = 0.0;
      for (std::size_t i = 0; i < 3; ++i) {
        const mpq_class q = rational(e[i]) / rational(c.w[i]);
        q_sum += q;
        qu_sum += q * mpq_class(double(uv_of_corner[i][axis]));
        max_u = std::max(max_u, std::abs(double(uv_of_corner[i][axis])));
      }
      const mpq_class u = qu_sum / q_sum;
      for (std::size_t i = 0; i < 3; ++i) {
        const mpq_class dq[2] = {rational(right[i] - e[i]) / rational(c.w[i]),
                                 rational(down[i] - e[i]) / rational(c.w[i])};
        for (int d = 0; d < 2; ++d) {
          slope[d] += dq[d] * (mpq_class(double(uv_of_corner[i][axis])) - u) / q_sum;
          size[d] += abs(dq[d]) / q_sum;
        }
      }
      const double unit = max_u * 0x1p-53;
      m.coordinate = std::max(m.coordinate, error_in(f.uv[axis], u, 0) / unit);
      const double got[2] = {f.duv_dx[axis], f.duv_dy[axis]};
      for (int d = 0; d < 2; ++d) {
        if (size[d] != 0)
          m.derivative = std::max(m.derivative, error_in(got[d], slope[d], 0) / (unit * size[d].get_d()));
      }
      const auto [low, high] = std::minmax({uv_of_corner[0][axis], uv_of_corner[1][axis], uv_of_corner[2][axis]});
      if (f.uv[axis] < low || f.uv[axis] > high) ++m.outside_hull;
    }
  }
  return m;
}

// ---- Clipped triangles --------------------------------------------------------------------------------------------

struct ExactVertex {
  std::array<mpq_class, 4> p;
  std::array<mpq_class, 3> weights;
};

/// C4's planes, on a viewport of `size` at the origin.
inline mpq_class exact_distance(int k, glm::ivec2 size, const std::array<mpq_class, 4>& p) {
  const mpq_class half_x = 128 * size.x, half_y = 128 * size.y, guard = 1 << 23;
  const mpq_class x = half_x * p[0] + half_x * p[3], y = half_y * p[3] - half_y * p[1];
  switch (k) {
    case 0:
      return p[3] - p[2];
    case 1:
      return p[3] - mpq_class(0x1p-149);
    case 2:
      return p[2];
    case 3:
      return x + guard * p[3];
    case 4:
      return guard * p[3] - x;
    case 5:
      return y + guard * p[3];
    default:
      return guard * p[3] - y;
  }
}

/// Sutherland & Hodgman without a rounding, from the canonically first corner on.
inline std::vector<ExactVertex> exact_clip(std::array<glm::dvec4, 3> corners, const std::array<std::size_t, 3>& order,
                                           glm::ivec2 size) {
  std::vector<ExactVertex> polygon;
  for (const std::size_t i : order) {
    ExactVertex& v = polygon.emplace_back();
    for (int k = 0; k < 4; ++k) v.p[std::size_t(k)] = corners[i][k];
    v.weights[i] = 1;
  }
  for (int k = 0; k < 7; ++k) {
    std::vector<ExactVertex> kept;
    for (std::size_t i = 0; i < polygon.size(); ++i) {
      const ExactVertex &a = polygon[i], &b = polygon[(i + 1) % polygon.size()];
      const mpq_class d_a = exact_distance(k, size, a.p), d_b = exact_distance(k, size, b.p);
      if (d_a >= 0) kept.push_back(a);
      if ((d_a >= 0) == (d_b >= 0)) continue;
      const mpq_class t = d_a / (d_a - d_b);
      ExactVertex& cut = kept.emplace_back();
      for (std::size_t c = 0; c < 4; ++c) cut.p[c] = a.p[c] + t * (b.p[c] - a.p[c]);
      for (std::size_t c = 0; c < 3; ++c) cut.weights[c] = a.weights[c] + t * (b.weights[c] - a.weights[c]);
    }
    polygon = std::move(kept);
  }
  return polygon;
}

/// Depth against the clipped corners as the rasterizer has them, attributes against corners clipped without a rounding.
struct ClippedMeasured : Measured {
  double snap_fx8 = 0.0;  ///< snapped corner − exact corner, in sub-pixels; C1: ½ + 2^-12
  std::uint64_t triangles = 0;
  std::uint64_t left_out = 0;  ///< the polygons have other numbers of corners: one lies on a plane but for rounding
};
inline void print(const ClippedMeasured& m) {
  print("clipped triangles", static_cast<const Measured&>(m));
  std::printf("[ MEASURED ] clipped triangles: %llu, %llu left out, corners within %.9f sub-pixels\n",
              static_cast<unsigned long long>(m.triangles), static_cast<unsigned long long>(m.left_out), m.snap_fx8);
}
inline void expect_contract(const ClippedMeasured& m) {
  expect_contract(static_cast<const Measured&>(m));
  EXPECT_LE(m.snap_fx8, 0.5 + 0x1p-12);
  EXPECT_LE(m.left_out * 1000, m.triangles);
}

inline ClippedMeasured check_clipped(std::uint64_t n_samples, std::uint64_t seed) {
  ClippedMeasured m;
  HashedNumbers numbers(seed);
  constexpr glm::ivec2 kSize{24, 24};
  while (m.samples < n_samples) {
    std::array<glm::dvec4, 3> corners;
    std::vector<glm::vec4> colors;
    for (glm::dvec4& p : corners) {  // near plane at w = 1, distances from 2^-20 behind the eye to 2^20
      const double mantissa = numbers.below(3) == 0 ? -1.0 - numbers.unit() : 1.0 + numbers.unit();
      const double w = std::ldexp(mantissa, int(numbers.below(20)));
      const auto across = [&] { return (6.0 * numbers.unit() - 3.0) * std::abs(w); };
      p = {across(), across(), numbers.below(4) == 0 ? w * (2.0 * numbers.unit() - 0.5) : 1.0, w};
      colors.push_back({whole_attribute(numbers), whole_attribute(numbers), whole_attribute(numbers), 77.7f});
    }
    SmallScene scene(kSize, ColorFormat::rgba32f);
    scene.clip(Topology::triangles, {corners[0], corners[1], corners[2]}).colors = scene.keep(colors);
    const FrameStats stats = scene.render();
    if (stats.primitives_clipped == 0 || stats.fragments_covered == 0) continue;
    ++m.triangles;

    std::array<std::size_t, 3> order = {0, 1, 2};
    std::sort(order.begin(), order.end(),
              [&](std::size_t i, std::size_t j) { return reference::canonically_before(corners[i], corners[j]); });
    const std::vector<ExactVertex> exact = exact_clip(corners, order, kSize);
    const reference::Assembly assembly = reference::assemble(scene.frame, kSize, 1);
    const auto& polygon = *std::get<reference::Triangle>(assembly.pieces.at(0).shape).polygon;
    if (polygon.vertices.size() != exact.size()) {
      ++m.left_out;
      continue;
    }
    for (std::size_t i = 0; i < exact.size(); ++i) {
      const auto& p = exact[i].p;
      const mpq_class x = 128 * kSize.x * (1 + p[0] / p[3]), y = 128 * kSize.y * (1 - p[1] / p[3]);
      m.snap_fx8 = std::max(
          {m.snap_fx8, error_in(polygon.vertices[i].p_fx8.x, x, 0), error_in(polygon.vertices[i].p_fx8.y, y, 0)});
    }

    for (std::size_t k = 0; k < scene.image.ids.size(); k += 1 + numbers.below(40)) {
      if (scene.image.ids[k].draw == kNoId) continue;
      const glm::ivec2 sample = 256 * glm::ivec2(int(k) % kSize.x, int(k) / kSize.x) + 128;
      for (const reference::Piece& piece : assembly.pieces) {
        const auto& t = std::get<reference::Triangle>(piece.shape);
        const EdgeValues e = triangle_edges({t.v[0].p_fx8, t.v[1].p_fx8, t.v[2].p_fx8}, sample);
        if (std::min({e[0], e[1], e[2]}) <= 0) continue;  // on a diagonal it may be either piece's
        ++m.samples;
        const mpq_class depth = exact_mean(e, {1, 1, 1}, {t.v[0].z, t.v[1].z, t.v[2].z});
        m.depth_ulp = std::max(m.depth_ulp, error_in(scene.image.depth[k], depth, ulp_exponent(depth)));
        std::array<mpq_class, 3> weights;
        mpq_class sum = 0;
        for (std::size_t i = 0; i < 3; ++i) {
          const ExactVertex& v = exact[std::size_t(t.polygon_vertex[i])];
          const mpq_class q = rational(e[i]) / v.p[3];
          sum += q;
          for (std::size_t j = 0; j < 3; ++j) weights[j] += q * v.weights[j];
        }
        for (int channel = 0; channel < 3; ++channel) {
          mpq_class value = 0;
          double largest = 0.0;
          for (std::size_t j = 0; j < 3; ++j) {
            value += weights[j] * mpq_class(double(colors[j][channel])) / sum;
            largest = std::max(largest, std::abs(double(colors[j][channel])));
          }
          m.attribute_ulp =
              std::max(m.attribute_ulp, error_in(scene.image.rgba32f[k][channel], value, ulp_exponent(largest)));
          const auto [low, high] = std::minmax({colors[0][channel], colors[1][channel], colors[2][channel]});
          const float got = scene.image.rgba32f[k][channel];
          if (got < low || got > high) ++m.outside_hull;
        }
        if (scene.image.rgba32f[k].a != 77.7f) ++m.constant_moved;
      }
    }
  }
  return m;
}

}  // namespace lode::raster::test
