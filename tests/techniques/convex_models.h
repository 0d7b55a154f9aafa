#pragma once
/// Small models for the convex approximation, each known to the last area.

#include <cstdint>
#include <glm/vec3.hpp>
#include <vector>

#include "geometry/procedural.h"
#include "geometry/random.h"

namespace lode::techniques::test {

struct Soup {
  std::vector<glm::vec3> positions;
  std::vector<std::uint32_t> indices;

  void add(const geometry::Mesh& mesh) {
    const std::uint32_t first = std::uint32_t(positions.size());
    positions.insert(positions.end(), mesh.positions.begin(), mesh.positions.end());
    for (const std::uint32_t i : mesh.indices) indices.push_back(first + i);
  }
  void add_triangle(const glm::vec3& a, const glm::vec3& b, const glm::vec3& c) {
    for (const glm::vec3& p : {a, b, c}) {
      indices.push_back(std::uint32_t(positions.size()));
      positions.push_back(p);
    }
  }
};

inline Soup box_soup(const glm::dvec3& low, const glm::dvec3& high) {
  Soup soup;
  soup.add(geometry::box(low, high));
  return soup;
}

/// A table: a top 8 × 1 × 4 on four legs 1 × 3 × 1, five closed parts that touch.
inline Soup table_soup() {
  Soup soup = box_soup({0, 3, 0}, {8, 4, 4});
  for (const double x : {0.0, 7.0}) {
    for (const double z : {0.0, 3.0}) soup.add(geometry::box({x, 0, z}, {x + 1, 3, z + 1}));
  }
  return soup;
}

/// The same with legs that end 1/8 below the top: five parts that share no vertex.
inline Soup parted_table_soup() {
  Soup soup = box_soup({0, 3, 0}, {8, 4, 4});
  for (const double x : {0.0, 7.0}) {
    for (const double z : {0.0, 3.0}) soup.add(geometry::box({x, 0, z}, {x + 1, 2.875, z + 1}));
  }
  return soup;
}

/// n random triangles that share no vertex.
inline Soup random_soup(std::uint64_t seed, int n) {
  geometry::Random random(seed, 90);
  Soup soup;
  for (int i = 0; i < n; ++i) {
    const glm::vec3 at(float(random.uniform(0, 10)), float(random.uniform(0, 10)), float(random.uniform(0, 10)));
    glm::vec3 p[3];
    for (glm::vec3& q : p) {
      q = at + glm::vec3(float(random.uniform()), float(random.uniform()), float(random.uniform()));
    }
    soup.add_triangle(p[0], p[1], p[2]);
  }
  return soup;
}

}  // namespace lode::techniques::test
