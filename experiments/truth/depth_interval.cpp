#include "experiments/truth/depth_interval.h"

#include <algorithm>
#include <cmath>

namespace lode::experiments::truth {
namespace {

/// Widened by the vertices' error and by the renderer's roundings on the way from their depths to the sample's: seven
/// operations in double, all terms of one sign.
DepthInterval widened(double low, double high, double error_z) {
  const double slack = error_z + 16.0 * kRoundoff * std::max(std::abs(low), std::abs(high));
  return {low - slack, high + slack};
}

/// The four places a vertex has at the corners of its square.
template <class Number>
struct Corners {
  std::array<std::array<Number, 2>, 4> at;
};

/// Twice the area of (s, p, q), both relative to s.
template <class Number>
Number cross(const std::array<Number, 2>& p, const std::array<Number, 2>& q) {
  return Number(p[0] * q[1]) - Number(p[1] * q[0]);
}

/// visit(E₀, E₁, E₂) for all 64 corners.
template <class Number, class Visit>
void for_each_corner(const std::array<Corners<Number>, 3>& v, Visit visit) {
  std::array<std::array<Number, 16>, 3> e;  // Eᵢ depends on the other two vertices alone
  for (std::size_t i = 0; i < 3; ++i) {
    for (std::size_t k = 0; k < 16; ++k) e[i][k] = cross(v[(i + 1) % 3].at[k / 4], v[(i + 2) % 3].at[k % 4]);
  }
  for (std::size_t c0 = 0; c0 < 4; ++c0) {
    for (std::size_t c1 = 0; c1 < 4; ++c1) {
      for (std::size_t c2 = 0; c2 < 4; ++c2) visit(e[0][4 * c1 + c2], e[1][4 * c2 + c0], e[2][4 * c0 + c1]);
    }
  }
}

template <class Number>
Corners<Number> corners_of(const Number& x, const Number& y, const Number& reach) {
  const std::array<Number, 2> xs = {x - reach, x + reach}, ys = {y - reach, y + reach};
  Corners<Number> c;
  for (std::size_t k = 0; k < 4; ++k) c.at[k] = {xs[k / 2], ys[k % 2]};
  return c;
}

}  // namespace

DepthInterval vertex_range(const Vertex& a, const Vertex& b, const Vertex& c, double error_z) {
  return widened(std::min({a.z, b.z, c.z}), std::max({a.z, b.z, c.z}), error_z);
}

std::optional<DepthInterval> depth_interval(const std::array<Vertex, 3>& v, glm::dvec2 s, double reach_px,
                                            double error_px, double error_z) {
  std::array<Corners<double>, 3> corners;
  double size = 0.0;  // of a vertex's coordinates relative to the sample
  for (std::size_t i = 0; i < 3; ++i) {
    const double x = v[i].x_px - s.x, y = v[i].y_px - s.y;
    size = std::max({size, std::abs(x) + reach_px, std::abs(y) + reach_px});
    corners[i] = corners_of(x, y, reach_px);
  }
  // Roundings: each coordinate is within m; each E is a difference of two products; the area is a sum of three.
  const double m = error_px + 3.0 * kRoundoff * size;
  const double error_e = 4.0 * m * size + 2.0 * m * m + 6.0 * kRoundoff * size * size;
  const double error_area = 3.0 * error_e + 12.0 * kRoundoff * size * size;

  const double z0 = v[0].z, dz1 = v[1].z - z0, dz2 = v[2].z - z0;
  const double z_low = std::min({v[0].z, v[1].z, v[2].z}), z_high = std::max({v[0].z, v[1].z, v[2].z});
  double least = HUGE_VAL, most = -HUGE_VAL, low = HUGE_VAL, high = -HUGE_VAL;
  for_each_corner(corners, [&](double e0, double e1, double e2) {
    const double area = (e0 + e1) + e2, z = z0 + (e1 * dz1 + e2 * dz2) / area;
    least = std::min(least, area);
    most = std::max(most, area);
    low = std::min(low, z);
    high = std::max(high, z);
  });
  if (least < -error_area && most > error_area) return widened(z_low, z_high, error_z);
  const double smallest = least > 0.0 ? least : -most;
  if (!(smallest > 8.0 * error_area)) return std::nullopt;

  // The quotient counts only as far as it stays within the vertices' range: its size there is at most `spread`.
  const double spread = std::abs(dz1) + std::abs(dz2);
  const double error_sum = spread * (error_e + 8.0 * kRoundoff * size * size);
  const double error = (error_sum + 2.0 * spread * error_area) / (smallest - error_area) + 8.0 * kRoundoff * z_high;
  if (!(error <= 0x1p-28 * z_high)) return std::nullopt;
  const DepthInterval inside = {std::clamp(low - error, z_low, z_high), std::clamp(high + error, z_low, z_high)};
  return widened(inside.low, inside.high, error_z);
}

DepthInterval exact_depth_interval(const std::array<ExactVertex, 3>& v, glm::dvec2 s, double reach_px, double error_z) {
  const Rational sx(s.x), sy(s.y), reach(reach_px);
  std::array<Corners<Rational>, 3> corners;
  for (std::size_t i = 0; i < 3; ++i) corners[i] = corners_of<Rational>(v[i].x_px - sx, v[i].y_px - sy, reach);
  const Rational z_low = std::min({v[0].z, v[1].z, v[2].z}), z_high = std::max({v[0].z, v[1].z, v[2].z});
  Rational low = z_high, high = z_low;
  bool any_positive = false, any_negative = false, any_zero = false;
  for_each_corner(corners, [&](const Rational& e0, const Rational& e1, const Rational& e2) {
    const Rational area = e0 + e1 + e2;
    any_positive |= area > 0;
    any_negative |= area < 0;
    any_zero |= area == 0;
    if (area == 0) return;
    const Rational z = (e0 * v[0].z + e1 * v[1].z + e2 * v[2].z) / area;
    low = std::min(low, z);
    high = std::max(high, z);
  });
  if (any_zero || (any_positive && any_negative)) {
    low = z_low;
    high = z_high;
  }
  return widened(rounded_down(std::clamp(low, z_low, z_high)), rounded_up(std::clamp(high, z_low, z_high)), error_z);
}

}  // namespace lode::experiments::truth
