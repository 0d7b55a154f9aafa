#pragma once
/// The diamond-exit rule from its definition, apart from raster/reference/line.cpp: the segment's parameter
/// interval is cut by the diamond's four open half-planes, with fractions whose numerators are polynomials in
/// the symbolic ε.

#include <array>
#include <cstdint>
#include <glm/vec2.hpp>

namespace lode::tests {

/// c[0] + c[1]·ε + c[2]·ε² for an ε smaller than any number.
using Infinitesimal = std::array<std::int64_t, 3>;

inline int sign_of(const Infinitesimal& a) {
  for (const std::int64_t c : a) {
    if (c != 0) return c > 0 ? 1 : -1;
  }
  return 0;
}

/// numerator / denominator, denominator > 0.
struct Bound {
  Infinitesimal numerator;
  std::int64_t denominator;
};
inline bool less(const Bound& a, const Bound& b) {
  Infinitesimal difference;
  for (std::size_t i = 0; i < 3; ++i) {
    difference[i] = b.numerator[i] * a.denominator - a.numerator[i] * b.denominator;
  }
  return sign_of(difference) > 0;
}

/// Whether the segment a → b has a fragment at sample p; all in 1/256 px, y down.
inline bool oracle_exits_diamond(glm::ivec2 a, glm::ivec2 b, glm::ivec2 p) {
  const Bound zero{{0, 0, 0}, 1}, one{{1, 0, 0}, 1};
  std::array<Bound, 5> lower{}, upper{};
  std::size_t n_lower = 0, n_upper = 0;
  bool b_inside = true, parallel_outside = false;
  for (const std::int64_t sx : {-1, 1}) {
    for (const std::int64_t sy : {-1, 1}) {
      // f(t) = 128 − sx·(x(t) − p.x) − sy·(y(t) − p.y) > 0 at (x, y)(t) = a − (ε, ε²) + t·(b − a).
      const Infinitesimal f0{128 - sx * (std::int64_t(a.x) - p.x) - sy * (std::int64_t(a.y) - p.y), sx, sy};
      const std::int64_t slope = -sx * (std::int64_t(b.x) - a.x) - sy * (std::int64_t(b.y) - a.y);
      b_inside = b_inside && sign_of({f0[0] + slope, f0[1], f0[2]}) > 0;
      if (slope > 0) lower[n_lower++] = {{-f0[0], -f0[1], -f0[2]}, slope};
      if (slope < 0) upper[n_upper++] = {f0, -slope};
      if (slope == 0 && sign_of(f0) <= 0) parallel_outside = true;
    }
  }
  if (b_inside || parallel_outside) return false;
  for (std::size_t i = 0; i < n_lower; ++i) {
    if (!less(lower[i], one)) return false;
    for (std::size_t j = 0; j < n_upper; ++j) {
      if (!less(lower[i], upper[j])) return false;
    }
  }
  for (std::size_t j = 0; j < n_upper; ++j) {
    if (!less(zero, upper[j])) return false;
  }
  return true;
}

}  // namespace lode::tests
