#pragma once
/// Edges that cross the clip planes, and what must hold of the points where they do (C4).

#include <algorithm>
#include <vector>

#include "snap_oracle.h"

namespace lode::raster::test {

/// A clip-space point with each coordinate of its own size, w of either sign; now and then 0, tiny or huge (but no
/// weight underflows: those tell which edge a new vertex lies on).
[[nodiscard]] inline glm::dvec4 random_clip_point(HashedNumbers& random, int spread) {
  glm::dvec4 p;
  for (int c = 0; c < 4; ++c) {
    p[c] = random_number(random, -spread, spread);
    switch (random.below(64)) {
      case 0:
        p[c] = 0.0;
        break;
      case 1:
        p[c] = -0.0;
        break;
      case 2:
        p[c] = std::ldexp(p[c], -250);
        break;
      case 3:
        p[c] = std::ldexp(p[c], 250);
        break;
      case 4:
        p[c] = 1.0;
        break;
      default:
        break;
    }
  }
  if (random.below(2) == 0) p.w = std::abs(p.w);
  return p;
}

/// The cut polygon's vertices on the edge from corner i to corner j: those with no weight of the third, each once.
[[nodiscard]] inline std::vector<glm::dvec4> vertices_on_edge(const reference::ClipPolygon& polygon,
                                                              std::size_t third) {
  std::vector<glm::dvec4> on_edge;
  for (int i = 0; i < polygon.n; ++i) {
    const reference::ClipVertex& v = polygon.vertices[std::size_t(i)];
    if (v.weights[third] == 0.0) on_edge.push_back(v.position + 0.0);  // one zero
  }
  const auto before = [](const glm::dvec4& a, const glm::dvec4& b) { return reference::canonically_before(a, b); };
  std::sort(on_edge.begin(), on_edge.end(), before);
  on_edge.erase(std::unique(on_edge.begin(), on_edge.end()), on_edge.end());
  return on_edge;
}

/// Cuts a–b as an edge of (a, b, c) and, the other way round, of a neighbour with d, each rotated at random. True if
/// both have the same vertices on it, bit for bit.
[[nodiscard]] inline bool same_from_both_sides(HashedNumbers& random, const reference::Viewport& v, const glm::dvec4& a,
                                               const glm::dvec4& b, const glm::dvec4& c, const glm::dvec4& d) {
  const std::uint32_t r = random.below(3), s = random.below(3);
  const auto rotated = [](std::array<glm::dvec4, 3> t, std::uint32_t by) {
    std::rotate(t.begin(), t.begin() + by, t.end());
    return t;
  };
  const reference::ClipPolygon left = reference::clip_triangle(v, rotated({a, b, c}, r));
  const reference::ClipPolygon right = reference::clip_triangle(v, rotated({b, a, d}, s));
  // A corner at index k lands at (k − by) mod 3. A polygon with nothing left has no say.
  if (left.n == 0 || right.n == 0) return true;
  return vertices_on_edge(left, (2 + 3 - r) % 3) == vertices_on_edge(right, (2 + 3 - s) % 3);
}

/// Where the edge a–b meets plane k, exactly.
struct ExactPoint {
  mpq_class x, y, w;
};
[[nodiscard]] inline ExactPoint exact_cut(int k, const Rect& viewport, const glm::dvec4& a, const glm::dvec4& b) {
  const glm::ivec2 o = viewport.origin_px, s = viewport.size_px;
  const auto distance = [&](const glm::dvec4& p) -> mpq_class {
    const mpq_class x(p.x), y(p.y), z(p.z), w(p.w);
    const mpq_class window_x = 256 * o.x * w + 128 * s.x * (x + w),
                    window_y = 256 * o.y * w + 128 * s.y * (w - y);  // · w
    switch (k) {
      case 0:
        return w - z;
      case 1:
        return w - mpq_class(reference::kMinW);
      case 2:
        return z;
      case 3:
        return window_x + reference::kGuard_fx8 * w;
      case 4:
        return reference::kGuard_fx8 * w - window_x;
      case 5:
        return window_y + reference::kGuard_fx8 * w;
      default:
        return reference::kGuard_fx8 * w - window_y;
    }
  };
  const mpq_class d_a = distance(a), d_b = distance(b), t = d_a / (d_a - d_b);
  const auto mixed = [&](double p, double q) -> mpq_class { return mpq_class(p) + t * (mpq_class(q) - mpq_class(p)); };
  return {mixed(a.x, b.x), mixed(a.y, b.y), mixed(a.w, b.w)};
}

}  // namespace lode::raster::test
