#pragma once
/// Orientation against GMP's rationals, on inputs made to be hard.

#include <gmpxx.h>

#include <cmath>
#include <cstdint>
#include <glm/vec2.hpp>
#include <glm/vec3.hpp>

#include "geometry/predicates.h"
#include "geometry/random.h"

namespace lode::geometry::test {

inline int exact(const glm::dvec2& a, const glm::dvec2& b, const glm::dvec2& c) {
  const mpq_class ax(a.x), ay(a.y);
  const mpq_class det = (mpq_class(b.x) - ax) * (mpq_class(c.y) - ay) - (mpq_class(b.y) - ay) * (mpq_class(c.x) - ax);
  return sgn(det);
}

inline int exact(const glm::dvec3& a, const glm::dvec3& b, const glm::dvec3& c, const glm::dvec3& d) {
  mpq_class p[3], q[3], r[3];
  for (int i = 0; i < 3; ++i) {
    p[i] = mpq_class(b[i]) - mpq_class(a[i]);
    q[i] = mpq_class(c[i]) - mpq_class(a[i]);
    r[i] = mpq_class(d[i]) - mpq_class(a[i]);
  }
  const mpq_class det =
      (p[1] * q[2] - p[2] * q[1]) * r[0] + (p[2] * q[0] - p[0] * q[2]) * r[1] + (p[0] * q[1] - p[1] * q[0]) * r[2];
  return sgn(det);
}

/// ((b − a) × (d − c)) · (p − a)
inline int exact_side(const glm::dvec3& a, const glm::dvec3& b, const glm::dvec3& c, const glm::dvec3& d,
                      const glm::dvec3& p) {
  mpq_class u[3], v[3], w[3];
  for (int i = 0; i < 3; ++i) {
    u[i] = mpq_class(b[i]) - mpq_class(a[i]);
    v[i] = mpq_class(d[i]) - mpq_class(c[i]);
    w[i] = mpq_class(p[i]) - mpq_class(a[i]);
  }
  const mpq_class det =
      (u[1] * v[2] - u[2] * v[1]) * w[0] + (u[2] * v[0] - u[0] * v[2]) * w[1] + (u[0] * v[1] - u[1] * v[0]) * w[2];
  return sgn(det);
}

/// One coordinate. kind 0: any finite bits; 1: a denormal; 2: a small whole number; 3: in [0, 1); 4: a float far out;
/// 5: near the largest double.
inline double coordinate(Random& random, int kind) {
  const double sign = random.below(2) ? 1.0 : -1.0;
  switch (kind) {
    case 0:
      return sign * std::ldexp(random.uniform(1.0, 2.0), int(random.below(2046)) - 1022);
    case 1:
      return sign * std::ldexp(double(random.below(1u << 20)), -1074);
    case 2:
      return sign * double(random.below(5));
    case 3:
      return random.uniform();
    case 4:
      return sign * double(float(random.uniform(1e5, 2e5)));
    default:
      return sign * std::ldexp(random.uniform(1.0, 2.0), 1023);
  }
}

/// Moves x by up to two units in the last place.
inline double nudged(Random& random, double x) {
  const double towards = random.below(2) ? HUGE_VAL : -HUGE_VAL;
  for (std::uint32_t n = random.below(3); n > 0; --n) {
    const double next = std::nextafter(x, towards);
    if (std::isfinite(next)) x = next;
  }
  return x;
}

template <int n>
using Point = glm::vec<n, double>;

template <int n>
Point<n> point(Random& random, int kind) {
  Point<n> p;
  for (int i = 0; i < n; ++i) p[i] = coordinate(random, kind == 6 ? int(random.below(6)) : kind);
  return p;
}

/// The last corner of an almost degenerate case: on the line or plane of the others up to rounding, then nudged.
template <int n>
Point<n> nearly_on(Random& random, const Point<n>* others) {
  const double s = random.uniform(-1.0, 2.0), t = n == 3 ? random.uniform(-1.0, 2.0) : 0.0;
  Point<n> p;
  for (int i = 0; i < n; ++i) {
    const double x = others[0][i] + s * (others[1][i] - others[0][i]) + t * (others[n - 1][i] - others[0][i]);
    p[i] = std::isfinite(x) ? nudged(random, x) : others[1][i];
  }
  return p;
}

/// Case i: the wrong signs among orientation's in 2 and 3 dimensions (0, 1 or 2).
template <class Check2, class Check3>
void predicate_case(std::uint64_t i, Check2 check2, Check3 check3) {
  Random random(1, 77, i);
  const int kind = int(i % 7);
  const bool near = i / 7 % 2 == 0;
  glm::dvec2 p2[3];
  for (auto& p : p2) p = point<2>(random, kind);
  if (near) p2[2] = nearly_on<2>(random, p2);
  check2(p2[0], p2[1], p2[2]);
  glm::dvec3 p3[4];
  for (auto& p : p3) p = point<3>(random, kind);
  if (near) p3[3] = nearly_on<3>(random, p3);
  check3(p3[0], p3[1], p3[2], p3[3]);
}

/// Case i of a plane through two directions: whether its sign is wrong. Every other point is nearly in the plane.
inline bool wrong_side(std::uint64_t i) {
  Random random(2, 77, i);
  glm::dvec3 p[5];
  for (auto& q : p) q = point<3>(random, int(i % 7));
  const double s = random.uniform(-1.0, 2.0), t = random.uniform(-1.0, 2.0);
  for (int k = 0; k < 3 && i / 7 % 2 == 0; ++k) {
    const double x = p[0][k] + s * (p[1][k] - p[0][k]) + t * (p[3][k] - p[2][k]);
    if (std::isfinite(x)) p[4][k] = nudged(random, x);
  }
  return side_of_directions(p[0], p[1], p[2], p[3], p[4]) != exact_side(p[0], p[1], p[2], p[3], p[4]);
}

/// The number of wrong signs in cases [first, last).
inline std::uint64_t wrong_signs(std::uint64_t first, std::uint64_t last,
                                 int (*o2)(const glm::dvec2&, const glm::dvec2&, const glm::dvec2&),
                                 int (*o3)(const glm::dvec3&, const glm::dvec3&, const glm::dvec3&,
                                           const glm::dvec3&)) {
  std::uint64_t wrong = 0;
  for (std::uint64_t i = first; i < last; ++i) {
    predicate_case(
        i, [&](auto& a, auto& b, auto& c) { wrong += o2(a, b, c) != exact(a, b, c); },
        [&](auto& a, auto& b, auto& c, auto& d) { wrong += o3(a, b, c, d) != exact(a, b, c, d); });
  }
  return wrong;
}

}  // namespace lode::geometry::test
