#include "experiments/truth/prepared_triangle.h"

#include <algorithm>
#include <cmath>
#include <optional>

namespace lode::experiments::truth {
namespace {

constexpr double kGuard_px = 32768.0;  // C1
constexpr double kMinW = 0x1p-149;     // smallest w kept (C4)

struct Side {
  bool all_inside = true;        ///< every corner, for certain, of every plane
  bool near_or_far_cut = false;  ///< some corner is not certainly inside the near or the far plane
  bool all_outside_one = false;  ///< every corner, for certain, outside one of the planes
};

/// Where the corners lie: distances to the planes as the polygon has them, scaled to pixels for the guard band.
Side side_of_planes(const std::array<ClipCorner, 3>& corners, glm::dvec2 half_px) {
  Side side;
  for (int plane = 0; plane < 7; ++plane) {
    int n_outside = 0;
    for (const ClipCorner& c : corners) {
      double d = 0.0, error = 0.0;
      if (plane == 0) {
        d = c.p.w - c.p.z;
        error = c.error.w + c.error.z + 2.0 * kRoundoff * (std::abs(c.p.w) + std::abs(c.p.z));
      } else if (plane == 1) {
        d = c.p.w - kMinW;
        error = c.error.w + 2.0 * kRoundoff * std::abs(c.p.w);
      } else if (plane == 2) {
        d = c.p.z;
        error = c.error.z;
      } else {
        const int axis = (plane - 3) / 2;
        const double sign = plane % 2 == 1 ? 1.0 : -1.0, half = half_px[axis];
        const double y_down = axis == 0 ? 1.0 : -1.0;
        d = sign * y_down * half * c.p[axis] + (kGuard_px + sign * half) * c.p.w;
        const double size = half * std::abs(c.p[axis]) + 2.0 * kGuard_px * std::abs(c.p.w);
        error = half * c.error[axis] + 2.0 * kGuard_px * c.error.w + 4.0 * kRoundoff * size;
      }
      const bool inside = error == 0.0 ? d >= 0.0 : d > error;
      side.all_inside = side.all_inside && inside;
      side.near_or_far_cut = side.near_or_far_cut || (plane < 3 && !inside);
      n_outside += d < -error;
    }
    side.all_outside_one = side.all_outside_one || n_outside == 3;
  }
  return side;
}

/// The projected triangle where nothing is cut. Errors: |x̃/w̃ − x/w| ≤ (eₓ + |x̃/w̃|·e_w) / (w̃ − e_w), and roundings.
Polygon projected(const std::array<ClipCorner, 3>& corners, glm::dvec2 half_px) {
  Polygon polygon;
  polygon.n = 3;
  for (std::size_t i = 0; i < 3; ++i) {
    const ClipCorner& c = corners[i];
    const double x = c.p.x / c.p.w, y = c.p.y / c.p.w, z = c.p.z / c.p.w, w_least = c.p.w - c.error.w;
    polygon.v[i] = {x * half_px.x + half_px.x, half_px.y - y * half_px.y, z, EdgeKind::outline};
    const auto error_of = [&](double quotient, double error) {
      return 1.001 * ((error + std::abs(quotient) * c.error.w) / w_least + 4.0 * kRoundoff * std::abs(quotient));
    };
    polygon.error_px =
        std::max({polygon.error_px, half_px.x * (error_of(x, c.error.x) + 4.0 * kRoundoff * (1.0 + std::abs(x))),
                  half_px.y * (error_of(y, c.error.y) + 4.0 * kRoundoff * (1.0 + std::abs(y)))});
    polygon.error_z = std::max(polygon.error_z, 2.0 * error_of(z, c.error.z));  // this file's and the renderer's
  }
  return polygon;
}

/// How far the renderer's depths of a cut polygon's vertices may be off. It cuts in double, between corners that are
/// rounded themselves (source_triangle.h); what that adds to z and w counts relative to the cut's own w.
double cut_depth_error(const std::array<ClipCorner, 3>& corners, const ExactPolygon& polygon) {
  double size = 0.0, error = 0.0, largest = 0.0;
  for (const ClipCorner& c : corners) {
    size = std::max({size, std::abs(c.p.z), std::abs(c.p.w)});
    error = std::max({error, c.error.z, c.error.w});
  }
  for (const ExactVertex& v : polygon) largest = std::max(largest, 4.0 * (error + 16.0 * kRoundoff * size) / v.w);
  return largest;
}

/// How far apart the same vertices of two polygons are, in px and in depth; nothing if they have not the same vertices.
struct Spread {
  double px = 0.0, z = 0.0;
};
std::optional<Spread> spread(const Polygon& a, const Polygon& b) {
  if (a.n != b.n) return std::nullopt;
  Spread s;
  for (std::size_t i = 0; i < std::size_t(a.n); ++i) {
    if (a.v[i].edge != b.v[i].edge) return std::nullopt;
    s.px = std::max({s.px, std::abs(a.v[i].x_px - b.v[i].x_px), std::abs(a.v[i].y_px - b.v[i].y_px)});
    s.z = std::max(s.z, std::abs(a.v[i].z - b.v[i].z));
  }
  return s;
}

/// The polygons of a triangle that is cut, or may be.
void prepare_cut(PreparedTriangle& t, const std::array<ClipCorner, 3>& corners, bool near_or_far_cut) {
  const ExactPolygon outer = exact_polygon(t.source, t.size_px, Planes::outer);
  t.outer = rounded(outer);
  t.outer.error_z = cut_depth_error(corners, outer);
  if (!near_or_far_cut) return;
  t.two_polygons = true;
  t.inner = rounded(exact_polygon(t.source, t.size_px, Planes::inner));
  const std::optional<Spread> s = spread(t.outer, t.inner);
  t.whole_range = !s || s->px > 0x1p-20;  // far below the snap, so that adding it changes next to nothing
  if (t.whole_range) return;
  t.reach_px += s->px + 2.0 * (t.outer.error_px + t.inner.error_px);
  t.outer.error_z += s->z;
}

DepthInterval range_of(const Polygon& polygon) {
  DepthInterval range{1.0, 0.0};
  for (int i = 0; i < polygon.n; ++i) {
    const Vertex& v = polygon.v[std::size_t(i)];
    range.include(vertex_range(v, v, v, polygon.error_z));
  }
  return {std::clamp(range.low, 0.0, 1.0), std::clamp(range.high, 0.0, 1.0)};  // as the renderer clamps its vertices'
}

}  // namespace

PreparedTriangle prepare(const SourceTriangle& triangle, glm::ivec2 size_px) {
  PreparedTriangle t;
  t.source = triangle;
  t.size_px = size_px;
  std::array<ClipCorner, 3> corners;
  for (std::size_t i = 0; i < 3; ++i) corners[i] = clip_corner(*triangle.clip_from_object, triangle.p_object[i]);
  const Side side = side_of_planes(corners, 0.5 * glm::dvec2(size_px));
  if (side.all_outside_one) return t;
  const Facing seen = facing(triangle.cull, corners);
  if (seen == Facing::dropped) return t;
  t.facing_doubtful = seen == Facing::doubtful;
  if (side.all_inside) {
    t.outer = projected(corners, 0.5 * glm::dvec2(size_px));
  } else {
    prepare_cut(t, corners, side.near_or_far_cut);
  }
  t.range = range_of(t.outer);
  return t;
}

}  // namespace lode::experiments::truth
