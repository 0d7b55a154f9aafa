#pragma once
/// Parts of a model: what hangs together after welding equal positions, and whether each is closed and which way it
/// faces.

#include <array>
#include <cstdint>
#include <glm/geometric.hpp>
#include <map>
#include <numeric>
#include <vector>

#include "geometry/scene.h"

namespace lode::geometry {

struct PartCounts {
  int closed_outwards = 0;
  int closed_inwards = 0;
  int open = 0;
};

/// The object's triangles in the world, [3 · triangles] numbers of welded positions, and those positions.
struct Welded {
  std::vector<std::uint32_t> corners;
  std::vector<glm::dvec3> positions;
};

inline Welded welded(const Scene& scene, const SceneObject& object) {
  Welded result;
  std::map<std::array<float, 3>, std::uint32_t> numbers;
  for (std::uint32_t i = object.first_instance; i < object.first_instance + object.n_instances; ++i) {
    const Mesh& mesh = scene.meshes[scene.instances[i].mesh];
    for (const std::uint32_t index : mesh.indices) {
      const glm::vec3 p = mesh.positions[index] + 0.0f;
      const auto [at, is_new] = numbers.emplace(std::array{p.x, p.y, p.z}, std::uint32_t(numbers.size()));
      if (is_new) result.positions.emplace_back(p);
      result.corners.push_back(at->second);
    }
  }
  return result;
}

/// Parts hang together by shared positions. A closed one has every edge as often in one direction as in the other; it
/// faces outwards if its volume is positive.
inline PartCounts count_parts(const Welded& mesh) {
  std::vector<std::uint32_t> part(mesh.positions.size());
  std::iota(part.begin(), part.end(), 0u);
  const auto root = [&](std::uint32_t i) {
    while (part[i] != i) i = part[i] = part[part[i]];
    return i;
  };
  for (std::size_t c = 0; c < mesh.corners.size(); c += 3) {
    part[root(mesh.corners[c + 1])] = root(mesh.corners[c]);
    part[root(mesh.corners[c + 2])] = root(mesh.corners[c]);
  }
  std::map<std::pair<std::uint32_t, std::uint32_t>, int> balance;
  std::map<std::uint32_t, double> volume;
  for (std::size_t c = 0; c < mesh.corners.size(); c += 3) {
    const std::uint32_t v[] = {mesh.corners[c], mesh.corners[c + 1], mesh.corners[c + 2]};
    for (int k = 0; k < 3; ++k) {
      const std::uint32_t a = v[k], b = v[(k + 1) % 3];
      balance[{std::min(a, b), std::max(a, b)}] += a < b ? 1 : (a > b ? -1 : 0);
    }
    const auto& p = mesh.positions;
    volume[root(v[0])] += glm::dot(p[v[0]], glm::cross(p[v[1]], p[v[2]])) / 6.0;
  }
  std::map<std::uint32_t, bool> open;
  for (const auto& [edge, n] : balance) open[root(edge.first)] |= n != 0;
  PartCounts counts;
  for (const auto& [r, v] : volume) {
    if (open[r]) {
      ++counts.open;
    } else {
      ++(v > 0.0 ? counts.closed_outwards : counts.closed_inwards);
    }
  }
  return counts;
}

}  // namespace lode::geometry
