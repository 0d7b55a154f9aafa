#pragma once
/// The ray-disc test over the rationals, apart from raster/reference/surfel.cpp: the hit is the meeting point of
/// three planes of object space, as the 3×3 minors of their coefficients (homogeneous, so no fraction has to be
/// reduced), and every condition is tested on it as it is written down in surfel.h.

#include <gmpxx.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <glm/mat4x4.hpp>
#include <glm/vec2.hpp>
#include <glm/vec3.hpp>
#include <limits>
#include <optional>

namespace lode::tests {

struct SurfelCase {
  glm::vec3 centre{0.0f};
  glm::vec3 normal{0.0f, 0.0f, 1.0f};
  float radius = 1.0f;
  glm::dmat4 clip_from_object{1.0};
  glm::ivec2 viewport_origin_px{0, 0};
  glm::ivec2 viewport_size_px{16, 16};
};

/// Lowest power of two that a number's bits reach down to.
inline int low_exponent(double x) { return x == 0.0 ? std::numeric_limits<int>::max() : std::ilogb(x) - 52; }

/// x / 2^unit, exact for unit ≤ low_exponent(x).
inline mpz_class integer_of(double x, int unit) {
  if (x == 0.0) return 0;
  mpz_class n(std::ldexp(x, -low_exponent(x)));  // 53 bits
  return n << (low_exponent(x) - unit);
}

class SurfelOracle {
 public:
  explicit SurfelOracle(const SurfelCase& s) : size_(s.viewport_size_px), origin_(s.viewport_origin_px) {
    const auto read = [](float x) { return std::clamp(double(x), -0x1p128, 0x1p128); };
    int row_unit = 1 << 20, normal_unit = 1 << 20;
    for (int i = 0; i < 16; ++i) row_unit = std::min(row_unit, low_exponent(s.clip_from_object[i / 4][i % 4]));
    point_unit_ = std::min(0, low_exponent(read(s.radius)));
    for (int i = 0; i < 3; ++i) {
      point_unit_ = std::min(point_unit_, low_exponent(read(s.centre[i])));
      normal_unit = std::min(normal_unit, low_exponent(read(s.normal[i])));
    }
    row_unit_ = row_unit == 1 << 20 ? 0 : row_unit;
    one_ = mpz_class(1) << -point_unit_;
    // Rows act on points in units of 2^point_unit, so their last element takes the factor `one`.
    for (int i = 0; i < 4; ++i) {
      for (int j = 0; j < 4; ++j) rows_[i][j] = integer_of(s.clip_from_object[j][i], row_unit_);
      rows_[i][3] *= one_;
    }
    for (int i = 0; i < 3; ++i) {
      centre_[i] = integer_of(read(s.centre[i]), point_unit_);
      plane_[i] = integer_of(read(s.normal[i]), normal_unit == 1 << 20 ? 0 : normal_unit);
      plane_[3] -= plane_[i] * centre_[i];
    }
    radius_ = integer_of(read(s.radius), point_unit_);
    is_disc_ = s.radius > 0.0f && (plane_[0] != 0 || plane_[1] != 0 || plane_[2] != 0);
  }

  [[nodiscard]] bool covers(glm::ivec2 p_fx8) const { return hit(p_fx8).has_value(); }
  /// z/w at a covered sample.
  [[nodiscard]] mpq_class depth(glm::ivec2 p_fx8) const { return *hit(p_fx8); }

 private:
  using Plane = std::array<mpz_class, 4>;

  /// Window coordinate − sample = 0, times 256 w: (128·(2v + size) − p)·w ± 128·size·(x or y).
  [[nodiscard]] Plane sample_plane(const Plane& row, int v, int size, int p_fx8, int sign) const {
    const mpz_class half = 128 * mpz_class(size), offset = 256 * mpz_class(v) + half - p_fx8;
    Plane plane;
    for (std::size_t j = 0; j < 4; ++j) plane[j] = offset * rows_[3][j] + sign * half * row[j];
    return plane;
  }
  [[nodiscard]] static mpz_class minor_without(const Plane& a, const Plane& b, const Plane& c, std::size_t skip) {
    std::array<std::size_t, 3> k{};
    for (std::size_t j = 0, n = 0; j < 4; ++j) {
      if (j != skip) k[n++] = j;
    }
    return a[k[0]] * (b[k[1]] * c[k[2]] - b[k[2]] * c[k[1]]) - a[k[1]] * (b[k[0]] * c[k[2]] - b[k[2]] * c[k[0]]) +
           a[k[2]] * (b[k[0]] * c[k[1]] - b[k[1]] * c[k[0]]);
  }
  /// z/w of the hit, if the sample is covered.
  [[nodiscard]] std::optional<mpq_class> hit(glm::ivec2 p_fx8) const {
    if (!is_disc_) return std::nullopt;
    const Plane a = sample_plane(rows_[0], origin_.x, size_.x, p_fx8.x, 1);
    const Plane b = sample_plane(rows_[1], origin_.y, size_.y, p_fx8.y, -1);
    // p·h = the first three, signs alternating.
    Plane p;
    for (std::size_t j = 0; j < 4; ++j) p[j] = (j % 2 == 0 ? 1 : -1) * minor_without(a, b, plane_, j);
    if (p[3] == 0) return std::nullopt;
    mpz_class distance2 = 0, z = 0, w = 0;
    for (std::size_t j = 0; j < 4; ++j) {
      z += rows_[2][j] * p[j];
      w += rows_[3][j] * p[j];
      if (j == 3) continue;
      const mpz_class d = p[j] - p[3] * centre_[j];
      distance2 += d * d;
    }
    if (distance2 > radius_ * radius_ * p[3] * p[3]) return std::nullopt;
    if (p[3] < 0) {
      z = -z;
      w = -w;
    }
    // w/|h| in units of 2^(row_unit + point_unit) against 2^-149.
    const int shift = row_unit_ + point_unit_ + 149;
    const mpz_class h = abs(p[3]);
    const mpz_class scaled_w = shift > 0 ? mpz_class(w << shift) : w, scaled_h = shift < 0 ? mpz_class(h << -shift) : h;
    if (scaled_w < scaled_h || z < 0 || z > w) return std::nullopt;
    mpq_class depth(z, w);
    depth.canonicalize();
    return depth;
  }

  glm::ivec2 size_, origin_;
  int row_unit_ = 0, point_unit_ = 0;
  std::array<Plane, 4> rows_;
  Plane plane_{0, 0, 0, 0};
  std::array<mpz_class, 3> centre_;
  mpz_class radius_, one_;
  bool is_disc_ = false;
};

}  // namespace lode::tests
