#include "geometry/predicates.h"

#include <algorithm>
#include <array>
#include <boost/multiprecision/cpp_int.hpp>
#include <cmath>
#include <cstdint>
#include <limits>
#include <optional>
#include <stdexcept>
#include <string>

namespace lode::geometry {
namespace {

using Integer = boost::multiprecision::cpp_int;

/// Below this a product may have lost bits to underflow, and a bound relative to it proves nothing.
constexpr double kSmallestSafe = 0x1p-900;

void check_finite(const double* begin, const double* end) {
  for (const double* x = begin; x != end; ++x) {
    if (!std::isfinite(*x))
      throw std::logic_error("orientation: expected finite coordinates, found " + std::to_string(*x));
  }
}

/// All values times one power of two that makes each an integer.
template <std::size_t n>
std::array<Integer, n> as_integers(const std::array<double, n>& values) {
  int lowest = std::numeric_limits<int>::max();
  std::array<std::int64_t, n> mantissas{};
  std::array<int, n> exponents{};
  for (std::size_t i = 0; i < n; ++i) {
    mantissas[i] = std::int64_t(std::ldexp(std::frexp(values[i], &exponents[i]), 53));
    if (mantissas[i] != 0) lowest = std::min(lowest, exponents[i]);
  }
  std::array<Integer, n> result;
  for (std::size_t i = 0; i < n; ++i) {
    result[i] = mantissas[i];
    if (mantissas[i] != 0) result[i] <<= unsigned(exponents[i] - lowest);
  }
  return result;
}

int sign(double x) { return (x > 0.0) - (x < 0.0); }

int exact_orientation(const glm::dvec2& a, const glm::dvec2& b, const glm::dvec2& c) {
  const auto [ax, ay, bx, by, cx, cy] = as_integers<6>({a.x, a.y, b.x, b.y, c.x, c.y});
  const Integer det = (bx - ax) * (cy - ay) - (by - ay) * (cx - ax);
  return det.sign();
}

/// ((b − a) × (d − c)) · (p − a)
int exact_side(const glm::dvec3& a, const glm::dvec3& b, const glm::dvec3& c, const glm::dvec3& d,
               const glm::dvec3& p) {
  const std::array<Integer, 15> v =
      as_integers<15>({a.x, a.y, a.z, b.x, b.y, b.z, c.x, c.y, c.z, d.x, d.y, d.z, p.x, p.y, p.z});
  const auto difference = [&](std::size_t to, std::size_t from, std::size_t axis) {
    return Integer(v[3 * to + axis] - v[3 * from + axis]);
  };
  const Integer bx = difference(1, 0, 0), by = difference(1, 0, 1), bz = difference(1, 0, 2);
  const Integer dx = difference(3, 2, 0), dy = difference(3, 2, 1), dz = difference(3, 2, 2);
  const Integer det = (by * dz - bz * dy) * difference(4, 0, 0) + (bz * dx - bx * dz) * difference(4, 0, 1) +
                      (bx * dy - by * dx) * difference(4, 0, 2);
  return det.sign();
}

/// The sign of (p × q) · r, each of them one rounded difference; nothing where rounding could have changed it.
std::optional<int> sure_sign(const glm::dvec3& p, const glm::dvec3& q, const glm::dvec3& r) {
  const double yz = p.y * q.z, zy = p.z * q.y, zx = p.z * q.x, xz = p.x * q.z, xy = p.x * q.y, yx = p.y * q.x;
  const double det = ((yz - zy) * r.x + (zx - xz) * r.y) + (xy - yx) * r.z;
  // Seven roundings at most on the way from a coordinate difference to the sum, each (1 + u): 16u of the computed sum
  // of magnitudes covers them and its own. An underflow loses at most 2^-1074 in each product, times |r| ≤ 2^1024;
  // a magnitude that large against the smallest product is left to the exact path by the second condition.
  const double magnitude =
      ((std::fabs(yz) + std::fabs(zy)) * std::fabs(r.x) + (std::fabs(zx) + std::fabs(xz)) * std::fabs(r.y)) +
      (std::fabs(xy) + std::fabs(yx)) * std::fabs(r.z);
  const double largest_r = std::max({std::fabs(r.x), std::fabs(r.y), std::fabs(r.z)});
  const bool safe = std::isfinite(magnitude) && magnitude > kSmallestSafe && magnitude > 0x1p-1000 * largest_r;
  if (safe && std::fabs(det) > 0x1p-49 * magnitude) return sign(det);
  return std::nullopt;
}

}  // namespace

int orientation(const glm::dvec2& a, const glm::dvec2& b, const glm::dvec2& c) {
  const double left = (b.x - a.x) * (c.y - a.y), right = (b.y - a.y) * (c.x - a.x);
  const double det = left - right;
  // With u = 2^-53: each factor errs by (1 + u), each product by (1 + u)³, the difference by (1 + u) once more:
  // |error| < (4u + 7u²…)(|left| + |right|), and 8u of the computed sum covers its own rounding. A coordinate that is
  // not finite makes the sum so.
  const double magnitude = std::fabs(left) + std::fabs(right);
  if (std::fabs(det) > 0x1p-50 * magnitude && magnitude > kSmallestSafe && std::isfinite(magnitude)) return sign(det);
  const std::array<double, 6> all = {a.x, a.y, b.x, b.y, c.x, c.y};
  check_finite(all.data(), all.data() + all.size());
  if ((b.x == a.x || c.y == a.y) && (b.y == a.y || c.x == a.x)) return 0;  // both products are
  return exact_orientation(a, b, c);
}

int orientation(const glm::dvec3& a, const glm::dvec3& b, const glm::dvec3& c, const glm::dvec3& d) {
  const std::array<double, 12> all = {a.x, a.y, a.z, b.x, b.y, b.z, c.x, c.y, c.z, d.x, d.y, d.z};
  check_finite(all.data(), all.data() + all.size());
  const std::optional<int> sure = sure_sign(b - a, c - a, d - a);
  return sure ? *sure : exact_side(a, b, a, c, d);
}

int side_of_directions(const glm::dvec3& a, const glm::dvec3& b, const glm::dvec3& c, const glm::dvec3& d,
                       const glm::dvec3& p) {
  const std::array<double, 15> all = {a.x, a.y, a.z, b.x, b.y, b.z, c.x, c.y, c.z, d.x, d.y, d.z, p.x, p.y, p.z};
  check_finite(all.data(), all.data() + all.size());
  const std::optional<int> sure = sure_sign(b - a, d - c, p - a);
  return sure ? *sure : exact_side(a, b, c, d, p);
}

}  // namespace lode::geometry
