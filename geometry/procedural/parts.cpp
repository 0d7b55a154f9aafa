#include "geometry/procedural/parts.h"

#include <cmath>
#include <cstdint>
#include <glm/geometric.hpp>
#include <queue>
#include <utility>

#include "geometry/trigonometry.h"

namespace lode::geometry {
namespace {

std::uint32_t add_vertex(Mesh& mesh, const glm::dvec3& p) {
  mesh.positions.emplace_back(p);
  return std::uint32_t(mesh.positions.size() - 1);
}

void add_triangle(Mesh& mesh, std::uint32_t a, std::uint32_t b, std::uint32_t c) {
  mesh.indices.insert(mesh.indices.end(), {a, b, c});
}

glm::dvec3 moved(const glm::dmat4& place, const glm::dvec3& p) { return glm::dvec3(place * glm::dvec4(p, 1.0)); }

/// A power in quarters of a number in [-1, 1], with its sign: square roots alone.
double signed_power(double x, int quarters) {
  const double half = std::sqrt(std::abs(x)), quarter = std::sqrt(half);
  const double powers[] = {1.0, quarter, half, half * quarter, std::abs(x)};
  return std::copysign(powers[quarters], x);
}

/// Point i of ring j of a ball between its poles. No coordinate is 0, since half a step lies before the first.
struct BallPoint {
  SinCos longitude, latitude;
};
BallPoint ball_point(int i, int j, int segments, int rings) {
  return {sin_cos(2.0 * kPi * (i + 0.5) / segments), sin_cos(kPi * ((j + 0.5) / rings - 0.5))};
}

double double_area(const Mesh& mesh, std::size_t triangle) {
  const auto p = [&](std::size_t k) { return glm::dvec3(mesh.positions[mesh.indices[3 * triangle + k]]); };
  return glm::length(glm::cross(p(1) - p(0), p(2) - p(0)));
}

}  // namespace

void add_loft(Mesh& mesh, std::span<const std::vector<glm::dvec3>> rings, const glm::dvec3& low_pole,
              const glm::dvec3& high_pole) {
  const auto first = std::uint32_t(mesh.positions.size());
  const auto n = std::uint32_t(rings[0].size());
  for (const std::vector<glm::dvec3>& ring : rings) {
    for (const glm::dvec3& p : ring) add_vertex(mesh, p);
  }
  const std::uint32_t low = add_vertex(mesh, low_pole), high = add_vertex(mesh, high_pole);
  for (std::uint32_t i = 0; i < n; ++i) {
    const std::uint32_t next = (i + 1) % n;
    add_triangle(mesh, low, first + next, first + i);
    for (std::uint32_t j = 0; j + 1 < rings.size(); ++j) {
      const std::uint32_t below = first + j * n, above = below + n;
      add_triangle(mesh, below + i, below + next, above + next);
      add_triangle(mesh, below + i, above + next, above + i);
    }
    const std::uint32_t last = first + (std::uint32_t(rings.size()) - 1) * n;
    add_triangle(mesh, high, last + i, last + next);
  }
}

void add_turned(Mesh& mesh, std::span<const glm::dvec2> profile, int segments, const glm::dmat4& place) {
  std::vector<std::vector<glm::dvec3>> rings;
  for (const glm::dvec2& p : profile) {
    std::vector<glm::dvec3>& ring = rings.emplace_back();
    for (int i = 0; i < segments; ++i) {
      const SinCos a = sin_cos(2.0 * kPi * (i + 0.5) / segments);
      ring.push_back(moved(place, {p.x * a.sin, p.y, p.x * a.cos}));
    }
  }
  add_loft(mesh, rings, moved(place, {0, profile.front().y, 0}), moved(place, {0, profile.back().y, 0}));
}

void add_block(Mesh& mesh, const glm::dvec3& low, const glm::dvec3& high, const glm::dmat4& place) {
  const auto first = std::uint32_t(mesh.positions.size());
  for (int k = 0; k < 8; ++k) {
    add_vertex(mesh, moved(place, {k & 1 ? high.x : low.x, k & 2 ? high.y : low.y, k & 4 ? high.z : low.z}));
  }
  constexpr std::uint32_t kFaces[6][4] = {{0, 4, 6, 2}, {1, 3, 7, 5}, {0, 1, 5, 4},
                                          {2, 6, 7, 3}, {0, 2, 3, 1}, {4, 5, 7, 6}};
  for (const auto& f : kFaces) {
    add_triangle(mesh, first + f[0], first + f[1], first + f[2]);
    add_triangle(mesh, first + f[0], first + f[2], first + f[3]);
  }
}

void add_rounded_box(Mesh& mesh, const glm::dvec3& low, const glm::dvec3& high, double radius, int segments, int rings,
                     const glm::dmat4& place) {
  const glm::dvec3 centre = 0.5 * (low + high), core = 0.5 * (high - low) - radius;
  std::vector<std::vector<glm::dvec3>> loops;
  for (int j = 0; j < rings; ++j) {
    std::vector<glm::dvec3>& loop = loops.emplace_back();
    for (int i = 0; i < segments; ++i) {
      const BallPoint b = ball_point(i, j, segments, rings);
      const glm::dvec3 n(b.latitude.cos * b.longitude.sin, b.latitude.sin, b.latitude.cos * b.longitude.cos);
      loop.push_back(moved(place, centre + core * glm::sign(n) + radius * n));
    }
  }
  const glm::dvec3 pole(0.0, core.y + radius, 0.0);
  add_loft(mesh, loops, moved(place, centre - pole), moved(place, centre + pole));
}

void add_superellipsoid(Mesh& mesh, const glm::dvec3& centre, const glm::dvec3& half, const Squareness& squareness,
                        int segments, int rings) {
  std::vector<std::vector<glm::dvec3>> loops;
  for (int j = 0; j < rings; ++j) {
    std::vector<glm::dvec3>& loop = loops.emplace_back();
    for (int i = 0; i < segments; ++i) {
      const BallPoint b = ball_point(i, j, segments, rings);
      const double out = signed_power(b.latitude.cos, squareness.section_quarters);
      loop.push_back(centre + half * glm::dvec3(out * signed_power(b.longitude.sin, squareness.plan_quarters),
                                                signed_power(b.latitude.sin, squareness.section_quarters),
                                                out * signed_power(b.longitude.cos, squareness.plan_quarters)));
    }
  }
  add_loft(mesh, loops, centre - glm::dvec3(0, half.y, 0), centre + glm::dvec3(0, half.y, 0));
}

void add_quad(Mesh& mesh, const glm::dvec3& a, const glm::dvec3& b, const glm::dvec3& c, const glm::dvec3& d) {
  const auto first = std::uint32_t(mesh.positions.size());
  for (const glm::dvec3& p : {a, b, c, d}) add_vertex(mesh, p);
  add_triangle(mesh, first, first + 1, first + 2);
  add_triangle(mesh, first, first + 2, first + 3);
}

void add_triangles_by_splitting(Mesh& mesh, std::size_t extra) {
  using Entry = std::pair<double, std::int64_t>;  // the largest area first, then the lowest index
  std::priority_queue<Entry> largest;
  const auto put = [&](std::size_t t) { largest.emplace(double_area(mesh, t), -std::int64_t(t)); };
  for (std::size_t t = 0; t < mesh.n_primitives(); ++t) put(t);
  for (std::size_t done = 0; done < extra; done += 2) {
    const auto t = std::size_t(-largest.top().second);
    largest.pop();
    const std::uint32_t a = mesh.indices[3 * t], b = mesh.indices[3 * t + 1], c = mesh.indices[3 * t + 2];
    const glm::dvec3 sum =
        glm::dvec3(mesh.positions[a]) + glm::dvec3(mesh.positions[b]) + glm::dvec3(mesh.positions[c]);
    const std::uint32_t centre = add_vertex(mesh, sum / 3.0);
    mesh.indices[3 * t + 2] = centre;
    add_triangle(mesh, b, c, centre);
    add_triangle(mesh, c, a, centre);
    for (const std::size_t changed : {t, mesh.n_primitives() - 2, mesh.n_primitives() - 1}) put(changed);
  }
}

glm::dmat4 frame_along(const glm::dvec3& from, const glm::dvec3& to) {
  const glm::dvec3 y = glm::normalize(to - from);
  const glm::dvec3 level = y.x * y.x + y.z * y.z > 1e-12 ? glm::dvec3(y.z, 0.0, -y.x) : glm::dvec3(1.0, 0.0, 0.0);
  const glm::dvec3 x = glm::normalize(level);
  return {glm::dvec4(x, 0.0), glm::dvec4(y, 0.0), glm::dvec4(glm::cross(x, y), 0.0), glm::dvec4(from, 1.0)};
}

glm::dmat4 turned_frame(const glm::dvec3& origin, double yaw_rad) {
  const SinCos a = sin_cos(yaw_rad);
  return {glm::dvec4(a.cos, 0.0, -a.sin, 0.0), glm::dvec4(0.0, 1.0, 0.0, 0.0), glm::dvec4(a.sin, 0.0, a.cos, 0.0),
          glm::dvec4(origin, 1.0)};
}

}  // namespace lode::geometry
