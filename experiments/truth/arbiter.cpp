#include "experiments/truth/arbiter.h"

#include <algorithm>
#include <cmath>

namespace lode::experiments::truth {
namespace {

ExactPolygon exact_outer(const PreparedTriangle& t) {
  return exact_polygon(t.source, t.size_px, t.two_polygons ? Planes::outer : Planes::exact);
}

/// Of the piece (root, i, i + 1) of the polygon: a fan from any root, as the renderer may have chosen any.
DepthInterval piece_depth(const PreparedTriangle& t, std::array<int, 3> corner, glm::dvec2 sample_px) {
  std::array<Vertex, 3> piece;
  for (std::size_t k = 0; k < 3; ++k) piece[k] = t.outer.v[std::size_t(corner[k])];
  const std::optional<DepthInterval> depth =
      depth_interval(piece, sample_px, t.reach_px, t.outer.error_px, t.outer.error_z);
  if (depth) return *depth;
  const ExactPolygon exact = exact_outer(t);
  std::array<ExactVertex, 3> exact_piece;
  for (std::size_t k = 0; k < 3; ++k) exact_piece[k] = exact[std::size_t(corner[k])];
  return exact_depth_interval(exact_piece, sample_px, t.reach_px, t.outer.error_z);
}

}  // namespace

Judgement judge_coverage(const PreparedTriangle& t, glm::dvec2 sample_px) {
  if (t.outer.n == 0) return {};
  const PlacedCoverage outer = coverage(t.outer, sample_px, [&] { return exact_outer(t); });
  PlacedCoverage inner = outer;
  if (t.two_polygons) {
    inner = coverage(t.inner, sample_px, [&] { return exact_polygon(t.source, t.size_px, Planes::inner); });
  }
  Judgement judgement;
  if (outer.coverage != Coverage::uncertain && outer.coverage == inner.coverage) {
    judgement.coverage = outer.coverage;
    if (outer.coverage == Coverage::in && t.facing_doubtful) {
      judgement.coverage = Coverage::uncertain;
      judgement.doubt = Doubt::outline;  // its outline is all there is of a triangle seen edge-on
    }
    return judgement;
  }
  // No sample between the two polygons' cuts is certain; elsewhere an outline is what is in doubt.
  judgement.coverage = Coverage::uncertain;
  const bool by_outline = outer.coverage == Coverage::uncertain && outer.doubt != EdgeKind::near_or_far;
  judgement.doubt = by_outline ? Doubt::outline : Doubt::cut;
  return judgement;
}

DepthInterval judge_depth(const PreparedTriangle& t, glm::dvec2 sample_px) {
  if (t.whole_range) return t.range;
  const Polygon& polygon = t.outer;
  if (polygon.n < 3) return t.range;
  if (polygon.n == 3) return piece_depth(t, {0, 1, 2}, sample_px);
  std::optional<DepthInterval> depth;
  for (int root = 0; root < polygon.n; ++root) {
    for (int i = 0; i < polygon.n; ++i) {
      const int j = i + 1 == polygon.n ? 0 : i + 1;
      if (i == root || j == root) continue;
      const auto at = [&](int k) -> const Vertex& { return polygon.v[std::size_t(k)]; };
      if (!may_cover(at(root), at(i), at(j), sample_px, t.reach_px)) continue;
      const DepthInterval piece = piece_depth(t, {root, i, j}, sample_px);
      depth ? depth->include(piece) : void(depth = piece);
    }
  }
  return depth.value_or(t.range);
}

Judgement judge(const PreparedTriangle& t, glm::dvec2 sample_px) {
  Judgement judgement = judge_coverage(t, sample_px);
  if (judgement.coverage != Coverage::out) judgement.depth = judge_depth(t, sample_px);
  return judgement;
}

bool surely_has_depth(const PreparedTriangle& t, glm::dvec2 s, float z) {
  if (t.outer.n != 3 || t.two_polygons) return false;
  const Vertex &a = t.outer.v[0], &b = t.outer.v[1], &c = t.outer.v[2];
  const double bx = b.x_px - a.x_px, by = b.y_px - a.y_px, cx = c.x_px - a.x_px, cy = c.y_px - a.y_px;
  const double area = bx * cy - by * cx;
  const double size = std::max(
      {std::abs(bx), std::abs(by), std::abs(cx), std::abs(cy), std::abs(s.x - a.x_px), std::abs(s.y - a.y_px), 1.0});
  const double error_area = 16.0 * (t.outer.error_px + kRoundoff * size) * size;
  if (!(std::abs(area) > 1024.0 * error_area)) return false;
  const double dz_b = b.z - a.z, dz_c = c.z - a.z;
  const double z_x = (dz_b * cy - dz_c * by) / area, z_y = (dz_c * bx - dz_b * cx) / area;
  const double here = a.z + z_x * (s.x - a.x_px) + z_y * (s.y - a.y_px);
  // A slope is at most (|dz_b| + |dz_c|)·size / area, with the area's relative error, and is used over at most `size`.
  const double most = (std::abs(dz_b) + std::abs(dz_c)) * size * size / std::abs(area);
  const double error = 8.0 * most * error_area / std::abs(area) + 64.0 * kRoundoff * (std::abs(here) + std::abs(a.z));
  const double half = kSnap_px * (std::abs(z_x) + std::abs(z_y)) - error;
  const double z_low = std::min({a.z, b.z, c.z}), z_high = std::max({a.z, b.z, c.z});
  return here - half <= z && z <= here + half && z_low <= z && z <= z_high;
}

ExactSample exact_sample(const SourceTriangle& triangle, glm::ivec2 size_px, glm::dvec2 sample_px) {
  const ExactPolygon polygon = exact_polygon(triangle, size_px, Planes::exact);
  const Rational sx(sample_px.x), sy(sample_px.y);
  const std::size_t n = polygon.size();
  bool any_left = false, any_right = false, on_line = false;
  for (std::size_t i = 0; i < n; ++i) {
    const ExactVertex &a = polygon[i], &b = polygon[(i + 1) % n];
    const Rational cross = (b.x_px - a.x_px) * (sy - a.y_px) - (b.y_px - a.y_px) * (sx - a.x_px);
    any_left |= cross > 0;
    any_right |= cross < 0;
    on_line |= cross == 0 && a.edge == EdgeKind::outline;
  }
  ExactSample sample;
  sample.inside = n >= 3 && any_left != any_right;  // all on one side, or on lines; no area has neither
  sample.on_outline = sample.inside && on_line;
  if (!sample.inside) return sample;
  // The depth of the plane through three vertices with area.
  const ExactVertex &a = polygon[0], &b = polygon[1];
  for (std::size_t k = 2; k < n; ++k) {
    const ExactVertex& c = polygon[k];
    const auto twice_area = [](const Rational& px, const Rational& py, const Rational& qx, const Rational& qy) {
      return Rational(px * qy - py * qx);
    };
    const Rational area = twice_area(b.x_px - a.x_px, b.y_px - a.y_px, c.x_px - a.x_px, c.y_px - a.y_px);
    if (area == 0) continue;
    const Rational along_b = twice_area(sx - a.x_px, sy - a.y_px, c.x_px - a.x_px, c.y_px - a.y_px) / area;
    const Rational along_c = twice_area(b.x_px - a.x_px, b.y_px - a.y_px, sx - a.x_px, sy - a.y_px) / area;
    sample.depth = a.z + along_b * (b.z - a.z) + along_c * (c.z - a.z);
    break;
  }
  return sample;
}

}  // namespace lode::experiments::truth
