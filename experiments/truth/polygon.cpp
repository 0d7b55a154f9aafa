#include "experiments/truth/polygon.h"

#include <algorithm>
#include <cmath>

namespace lode::experiments::truth {
namespace {

struct HomogeneousVertex {
  ExactCorner p;
  EdgeKind edge = EdgeKind::outline;
};
using HomogeneousPolygon = std::vector<HomogeneousVertex>;

/// Distances a corner may be from a plane without the renderer being sure of its side: twice, for w − z and for the
/// rounding of that difference.
double plane_error(const SourceTriangle& triangle, int plane) {
  double error = 0.0;
  for (const glm::vec3& p_object : triangle.p_object) {
    const ClipCorner c = clip_corner(*triangle.clip_from_object, p_object);
    const double size = plane == 0 ? std::abs(c.p.w) + std::abs(c.p.z) : 0.0;
    const double here = (plane == 0 ? c.error.w + c.error.z : c.error.z) + 2.0 * kRoundoff * size;
    error = std::max(error, here);
  }
  return error;
}

/// x·a + y·b + z·c + w·d + e ≥ 0 is kept.
struct Plane {
  std::array<Rational, 4> factor;
  Rational offset;
  EdgeKind kind = EdgeKind::guard;

  [[nodiscard]] Rational distance(const ExactCorner& p) const {
    Rational sum = offset;
    for (std::size_t i = 0; i < 4; ++i) {
      if (factor[i] != 0) sum += factor[i] * p[i];
    }
    return sum;
  }
};

/// In the renderer's order.
std::vector<Plane> clip_planes(const SourceTriangle& triangle, glm::ivec2 size_px, Planes planes) {
  const double outwards = planes == Planes::exact ? 0.0 : (planes == Planes::outer ? 1.0 : -1.0);
  std::vector<Plane> all = {
      {{0, 0, -1, 1}, Rational(outwards * plane_error(triangle, 0)), EdgeKind::near_or_far},
      {{0, 0, 0, 1}, Rational(-0x1p-149), EdgeKind::near_or_far},
      {{0, 0, 1, 0}, Rational(outwards * plane_error(triangle, 2)), EdgeKind::near_or_far},
  };
  // Window coordinates in 1/256 px, x·half/w + centre with half = centre = 128·size, stay within ±2^23.
  const Rational half_x = 128 * size_px.x, half_y = 128 * size_px.y, guard = 1 << 23;
  all.push_back({{half_x, 0, 0, half_x + guard}, 0, EdgeKind::guard});
  all.push_back({{-half_x, 0, 0, guard - half_x}, 0, EdgeKind::guard});
  all.push_back({{0, -half_y, 0, half_y + guard}, 0, EdgeKind::guard});
  all.push_back({{0, half_y, 0, guard - half_y}, 0, EdgeKind::guard});
  return all;
}

/// The point of the edge from a to b on the plane; da and db differ in sign.
ExactCorner cut(const ExactCorner& a, const ExactCorner& b, const Rational& da, const Rational& db) {
  const Rational t = da / (da - db);
  ExactCorner p;
  for (std::size_t i = 0; i < 4; ++i) p[i] = a[i] + t * (b[i] - a[i]);
  return p;
}

HomogeneousPolygon clip(const HomogeneousPolygon& in, const Plane& plane) {
  std::vector<Rational> distance;
  bool any_outside = false;
  for (const HomogeneousVertex& v : in) {
    distance.push_back(plane.distance(v.p));
    any_outside |= distance.back() < 0;
  }
  if (!any_outside) return in;
  HomogeneousPolygon out;
  for (std::size_t i = 0; i < in.size(); ++i) {
    const std::size_t j = (i + 1) % in.size();
    const bool inside = distance[i] >= 0, next_inside = distance[j] >= 0;
    if (inside) out.push_back(in[i]);
    if (inside == next_inside) continue;
    // Leaving, the cut runs on from the new point; coming back, the rest of the edge does.
    out.push_back({cut(in[i].p, in[j].p, distance[i], distance[j]), inside ? plane.kind : in[i].edge});
  }
  return out;
}

ExactVertex on_screen(const HomogeneousVertex& v, glm::ivec2 size_px) {
  const Rational half_x = Rational(size_px.x) / 2, half_y = Rational(size_px.y) / 2;
  return {v.p[0] / v.p[3] * half_x + half_x, half_y - v.p[1] / v.p[3] * half_y, v.p[2] / v.p[3], v.p[3].get_d(),
          v.edge};
}

bool same_place(const ExactVertex& a, const ExactVertex& b) {
  return a.x_px == b.x_px && a.y_px == b.y_px && a.z == b.z;
}

}  // namespace

ExactPolygon exact_polygon(const SourceTriangle& triangle, glm::ivec2 size_px, Planes planes) {
  HomogeneousPolygon clipped;
  for (const glm::vec3& p_object : triangle.p_object) {
    clipped.push_back({exact_clip_corner(*triangle.clip_from_object, p_object)});
  }
  for (const Plane& plane : clip_planes(triangle, size_px, planes)) clipped = clip(clipped, plane);
  ExactPolygon polygon;
  for (const HomogeneousVertex& v : clipped) {
    const ExactVertex vertex = on_screen(v, size_px);
    if (!polygon.empty() && same_place(polygon.back(), vertex)) {
      polygon.back().edge = vertex.edge;  // an edge of no length goes
    } else {
      polygon.push_back(vertex);
    }
  }
  if (polygon.size() > 1 && same_place(polygon.back(), polygon.front())) polygon.pop_back();
  return polygon;
}

Polygon rounded(const ExactPolygon& exact) {
  Polygon polygon;
  polygon.n = int(exact.size());
  double largest = 0.0;
  for (std::size_t i = 0; i < exact.size(); ++i) {
    polygon.v[i] = {exact[i].x_px.get_d(), exact[i].y_px.get_d(), exact[i].z.get_d(), exact[i].edge};
    largest = std::max({largest, std::abs(polygon.v[i].x_px), std::abs(polygon.v[i].y_px)});
  }
  polygon.error_px = 2.0 * kRoundoff * largest + 0x1p-1000;  // get_d cuts off: within one place
  return polygon;
}

}  // namespace lode::experiments::truth
