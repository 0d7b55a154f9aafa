#pragma once
/// Models whose inside is known, and the question whether a hull that is said to be inside is.

#include <algorithm>
#include <array>
#include <cstdint>
#include <glm/vec3.hpp>
#include <utility>
#include <vector>

#include "geometry/hull.h"
#include "geometry/predicates.h"
#include "geometry/procedural.h"
#include "geometry/procedural/model.h"
#include "geometry/random.h"
#include "geometry/solid.h"

namespace lode::geometry::test {

struct Soup {
  std::vector<glm::vec3> positions;
  std::vector<std::uint32_t> indices;

  void add(const Mesh& mesh) {
    const auto first = std::uint32_t(positions.size());
    positions.insert(positions.end(), mesh.positions.begin(), mesh.positions.end());
    for (const std::uint32_t i : mesh.indices) indices.push_back(first + i);
  }
  [[nodiscard]] Solid solid() const { return {positions, indices}; }
};

inline Soup soup_of(const Mesh& mesh) {
  Soup soup;
  soup.add(mesh);
  return soup;
}

inline Soup soup_of(const Model& model) {
  Soup soup;
  for (const ModelSurface& surface : model.surfaces) soup.add(surface.mesh);
  return soup;
}

/// The same surface, seen from the other side.
inline Mesh inside_out(Mesh mesh) {
  for (std::size_t i = 0; i < mesh.indices.size(); i += 3) std::swap(mesh.indices[i + 1], mesh.indices[i + 2]);
  return mesh;
}

/// An L of two arms [0, 3] × [0, 1] and [0, 1] × [0, 3] in x and y, from z = 0 to 1: one part, 28 triangles.
inline Soup l_shape() {
  Soup soup;
  for (const float z : {0.0f, 1.0f}) {
    for (const auto& [x, y] : {std::pair{0, 0}, {1, 0}, {3, 0}, {3, 1}, {1, 1}, {1, 3}, {0, 3}, {0, 1}}) {
      soup.positions.emplace_back(float(x), float(y), z);
    }
  }
  const auto quad = [&](std::uint32_t a, std::uint32_t b, std::uint32_t c, std::uint32_t d) {
    soup.indices.insert(soup.indices.end(), {a, b, c, a, c, d});
  };
  // Three squares and a side each, counter-clockwise from outside; the cap of corners 0, 1, 4, 7 shares whole edges.
  for (const auto& [a, b, c, d] : {std::array{0u, 1u, 4u, 7u}, {1u, 2u, 3u, 4u}, {7u, 4u, 5u, 6u}}) {
    quad(a + 8, b + 8, c + 8, d + 8);
    quad(d, c, b, a);
  }
  for (std::uint32_t i = 0; i < 8; ++i) quad(i, (i + 1) % 8, (i + 1) % 8 + 8, i + 8);
  return soup;
}

inline std::vector<glm::vec3> box_corners(const glm::vec3& low, const glm::vec3& high) {
  std::vector<glm::vec3> points;
  for (int i = 0; i < 8; ++i) {
    points.emplace_back((i & 1 ? high : low).x, (i & 2 ? high : low).y, (i & 4 ? high : low).z);
  }
  return points;
}

/// Points strictly inside of the points' hull that are inside of no part: of n random means of the points.
inline int n_outside(const Solid& solid, const std::vector<glm::vec3>& points, int n, std::uint64_t seed) {
  const std::vector<glm::dvec3> exact(points.begin(), points.end());
  const Hull hull = convex_hull(exact);
  Random random(seed, 83);
  int n_found = 0;
  for (int k = 0; k < n; ++k) {
    glm::dvec3 p = exact[random.below(std::uint32_t(exact.size()))];
    for (const glm::dvec3& q : exact) p += (q - p) * (random.below(2) ? 0.0 : random.uniform());
    const bool strictly = std::ranges::all_of(
        hull.triangles, [&](const auto& t) { return orientation(exact[t[0]], exact[t[1]], exact[t[2]], p) < 0; });
    if (!strictly) continue;  // on the surface, maybe, or outside by its rounding
    n_found += !solid.contains(p);
  }
  return n_found;
}

/// A closed model of case i: a box, a ball, a ring or an L, stretched and turned, with its vertices rounded to floats.
inline Soup random_closed_model(std::uint64_t i) {
  Random random(5, 84, i);
  const int n = 3 + int(random.below(8));
  Soup soup;
  switch (i % 4) {
    case 0:
      soup = soup_of(box({0, 0, 0}, {1, 2, 3}));
      break;
    case 1:
      soup = soup_of(sphere({1, 1, 1}, 1.0, n, n));
      break;
    case 2:
      soup = soup_of(torus({1, 1, 1}, 1.0, random.uniform(0.1, 0.6), n, 3 + int(random.below(6))));
      break;
    default:
      soup = l_shape();
  }
  if (random.below(2)) return soup;
  const glm::vec3 x(float(random.uniform(0.5, 2)), float(random.uniform(-1, 1)), float(random.uniform(-1, 1)));
  const glm::vec3 y(0.0f, float(random.uniform(0.5, 2)), float(random.uniform(-1, 1)));
  const glm::vec3 z(0.0f, 0.0f, float(random.uniform(0.05, 1)));
  for (glm::vec3& p : soup.positions) p = x * p.x + y * p.y + z * p.z;
  return soup;
}

/// Case i asks about the hull of a few points of a random model: vertices, points on its edges and faces, points about
/// it, or what is left of them after they moved towards one of them. Returns whether it is contained; adds to
/// n_false the points of a contained one that are outside.
inline bool hull_case(std::uint64_t i, int n_points, int& n_false) {
  const Soup soup = random_closed_model(i);
  const Solid solid = soup.solid();
  Random random(6, 85, i);
  std::vector<glm::vec3> points;
  for (std::uint32_t n = 4 + random.below(6); n > 0; --n) {
    const std::size_t t = 3 * random.below(std::uint32_t(soup.indices.size() / 3));
    const glm::vec3 &a = soup.positions[soup.indices[t]], &b = soup.positions[soup.indices[t + 1]],
                    &c = soup.positions[soup.indices[t + 2]];
    switch (random.below(3)) {
      case 0:
        points.push_back(a);
        break;
      case 1:
        points.push_back(0.5f * a + 0.5f * b);
        break;
      default:
        points.push_back(0.25f * a + 0.25f * b + 0.5f * c);
    }
  }
  const float left = random.below(2) ? 1.0f : float(random.uniform(0.1, 1.0));
  for (glm::vec3& p : points) p = points[0] + (p - points[0]) * left;
  if (!solid.contains_hull(points)) return false;
  n_false += n_outside(solid, points, n_points, i);
  return true;
}

}  // namespace lode::geometry::test
