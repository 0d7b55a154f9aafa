#include "experiments/truth/coverage.h"

#include <algorithm>
#include <cmath>
#include <optional>

namespace lode::experiments::truth {
namespace {

enum class Sure : std::uint8_t { no, unknown, yes };

/// An edge as the sample sees it.
struct EdgeView {
  double cross = 0.0;  ///< (b − a) × (s − a), within `error`
  double reach = 0.0;  ///< what it is at most where the edge can pass over the sample
  double error = 0.0;
  Sure passes = Sure::no;
};

EdgeView view(const Vertex& a, const Vertex& b, glm::dvec2 s, double error_px) {
  const double dx = b.x_px - a.x_px, dy = b.y_px - a.y_px, sx = s.x - a.x_px, sy = s.y - a.y_px;
  EdgeView edge;
  edge.cross = dx * sy - dy * sx;
  edge.reach = kSnap_px * (std::abs(dx) + std::abs(dy));
  // Each difference is within m of the exact one: two vertices' errors and a rounding.
  const double size = std::max({std::abs(dx), std::abs(dy), std::abs(sx), std::abs(sy)});
  const double m = 2.0 * error_px + 2.0 * kRoundoff * size;
  edge.error = m * (4.0 * size + 2.0 * m) + 8.0 * kRoundoff * size * size + 4.0 * m * kSnap_px;

  // Beyond the ends by more than the reach, in x, in y, and across: the largest of the three decides.
  const double beyond_x = std::max(std::min(0.0, dx) - sx, sx - std::max(0.0, dx)) - kSnap_px;
  const double beyond_y = std::max(std::min(0.0, dy) - sy, sy - std::max(0.0, dy)) - kSnap_px;
  const double across = std::abs(edge.cross) - edge.reach;
  if (beyond_x > m || beyond_y > m || across > edge.error) {
    edge.passes = Sure::no;
  } else if (beyond_x < -m && beyond_y < -m && across < -edge.error) {
    edge.passes = Sure::yes;
  } else {
    edge.passes = Sure::unknown;
  }
  return edge;
}

/// Beyond the polygon's box by more than the reach: the quick way out of most questions.
bool clear_of_box(const Polygon& polygon, glm::dvec2 s) {
  double low_x = polygon.v[0].x_px, high_x = low_x, low_y = polygon.v[0].y_px, high_y = low_y;
  for (int i = 1; i < polygon.n; ++i) {
    const Vertex& v = polygon.v[std::size_t(i)];
    low_x = std::min(low_x, v.x_px);
    high_x = std::max(high_x, v.x_px);
    low_y = std::min(low_y, v.y_px);
    high_y = std::max(high_y, v.y_px);
  }
  const double reach = kSnap_px + 2.0 * polygon.error_px + 0x1p-36;  // the last: roundings here, |coordinates| ≤ 2^16
  return s.x < low_x - reach || s.x > high_x + reach || s.y < low_y - reach || s.y > high_y + reach;
}

/// Nothing where double cannot tell.
std::optional<PlacedCoverage> filtered_coverage(const Polygon& polygon, glm::dvec2 s) {
  bool certain = true, short_edge = false, all_left = true, all_right = true;
  PlacedCoverage uncertain{Coverage::uncertain, EdgeKind::guard};
  for (int i = 0; i < polygon.n; ++i) {
    const EdgeView edge = view(polygon.v[std::size_t(i)], polygon.next(i), s, polygon.error_px);
    if (edge.passes == Sure::unknown) return std::nullopt;
    if (edge.passes == Sure::yes) {
      certain = false;
      uncertain.doubt = std::min(uncertain.doubt, polygon.v[std::size_t(i)].edge);
    }
    short_edge = short_edge || edge.reach <= 4.0 * edge.error;
    all_left = all_left && edge.cross > edge.error;
    all_right = all_right && edge.cross < -edge.error;
  }
  if (!certain) return uncertain;
  if (polygon.n < 3) return PlacedCoverage{};
  // Inside, and passed over by no edge: then the square around the sample lies inside, too, and every cross product is
  // above its reach, hence above its error. So a sign in doubt means outside, unless the reach itself is that small.
  if (short_edge) return std::nullopt;
  return PlacedCoverage{all_left || all_right ? Coverage::in : Coverage::out, EdgeKind::outline};
}

}  // namespace

PlacedCoverage exact_coverage(const ExactPolygon& polygon, glm::dvec2 sample_px) {
  const Rational sx(sample_px.x), sy(sample_px.y), h(kSnap_px);
  bool certain = true, all_left = true, all_right = true;
  PlacedCoverage uncertain{Coverage::uncertain, EdgeKind::guard};
  for (std::size_t i = 0; i < polygon.size(); ++i) {
    const ExactVertex &a = polygon[i], &b = polygon[(i + 1) % polygon.size()];
    const Rational dx = b.x_px - a.x_px, dy = b.y_px - a.y_px;
    const Rational cross = dx * (sy - a.y_px) - dy * (sx - a.x_px);
    all_left = all_left && cross > 0;
    all_right = all_right && cross < 0;
    const bool x_meets = std::min(a.x_px, b.x_px) - h <= sx && sx <= std::max(a.x_px, b.x_px) + h;
    const bool y_meets = std::min(a.y_px, b.y_px) - h <= sy && sy <= std::max(a.y_px, b.y_px) + h;
    if (x_meets && y_meets && abs(cross) <= h * (abs(dx) + abs(dy))) {
      certain = false;
      uncertain.doubt = std::min(uncertain.doubt, a.edge);
    }
  }
  if (!certain) return uncertain;
  return {polygon.size() >= 3 && (all_left || all_right) ? Coverage::in : Coverage::out, EdgeKind::outline};
}

PlacedCoverage coverage(const Polygon& polygon, glm::dvec2 sample_px, const std::function<ExactPolygon()>& exact) {
  if (polygon.n == 0 || clear_of_box(polygon, sample_px)) return {};
  if (const std::optional<PlacedCoverage> filtered = filtered_coverage(polygon, sample_px)) return *filtered;
  return exact_coverage(exact(), sample_px);
}

bool may_cover(const Vertex& a, const Vertex& b, const Vertex& c, glm::dvec2 s, double reach_px) {
  const auto beyond = [&](double va, double vb, double vc, double at) {
    return at < std::min({va, vb, vc}) - reach_px || at > std::max({va, vb, vc}) + reach_px;
  };
  if (beyond(a.x_px, b.x_px, c.x_px, s.x) || beyond(a.y_px, b.y_px, c.y_px, s.y)) return false;
  // Outside by an edge, for certain: on the far side of its line, by more than its reach.
  const double area = (b.x_px - a.x_px) * (c.y_px - a.y_px) - (b.y_px - a.y_px) * (c.x_px - a.x_px);
  const double side = area >= 0.0 ? 1.0 : -1.0;
  const auto outside = [&](const Vertex& from, const Vertex& to) {
    const double dx = to.x_px - from.x_px, dy = to.y_px - from.y_px;
    const double cross = side * (dx * (s.y - from.y_px) - dy * (s.x - from.x_px));
    return cross < -2.0 * reach_px * (std::abs(dx) + std::abs(dy)) - 0x1p-20;
  };
  return !(outside(a, b) || outside(b, c) || outside(c, a));
}

}  // namespace lode::experiments::truth
