#include "geometry/mesh.h"

#include <algorithm>
#include <bit>
#include <cmath>
#include <glm/geometric.hpp>
#include <tuple>

namespace lode::geometry {
namespace {

/// Twice the triangle's area along its normal: counter-clockwise as seen from where it points.
glm::dvec3 area_normal(const Mesh& mesh, std::size_t triangle) {
  const glm::dvec3 a(mesh.positions[mesh.indices[3 * triangle]]);
  const glm::dvec3 b(mesh.positions[mesh.indices[3 * triangle + 1]]);
  const glm::dvec3 c(mesh.positions[mesh.indices[3 * triangle + 2]]);
  return glm::cross(b - a, c - a);
}

/// (0,0,0) stays. Float differences squared twice stay within double's range, so that no scaling is needed.
glm::vec3 unit_or_zero(const glm::dvec3& n) {
  const double squared = glm::dot(n, n);
  return squared > 0.0 && std::isfinite(squared) ? glm::vec3(n / std::sqrt(squared)) : glm::vec3(0.0f);
}

template <class T>
std::vector<T> one_a_corner(const std::vector<T>& values, const std::vector<std::uint32_t>& indices) {
  std::vector<T> result;
  if (values.empty()) return result;
  result.reserve(indices.size());
  for (const std::uint32_t index : indices) result.push_back(values[index]);
  return result;
}

}  // namespace

Mesh with_flat_normals(const Mesh& mesh) {
  Mesh result;
  result.kind = mesh.kind;
  result.material = mesh.material;
  result.positions = one_a_corner(mesh.positions, mesh.indices);
  result.uvs = one_a_corner(mesh.uvs, mesh.indices);
  result.colors = one_a_corner(mesh.colors, mesh.indices);
  result.indices.resize(mesh.indices.size());
  result.normals.resize(mesh.indices.size());
  for (std::size_t i = 0; i < mesh.indices.size(); ++i) {
    result.indices[i] = std::uint32_t(i);
    result.normals[i] = i % 3 == 0 ? unit_or_zero(area_normal(mesh, i / 3)) : result.normals[i - 1];
  }
  return result;
}

std::vector<glm::vec3> smooth_normals(const Mesh& mesh) {
  // Equal positions are made neighbours by sorting; −0 counts as +0.
  const std::size_t n = mesh.positions.size();
  const auto key = [&](std::uint32_t i) {
    const glm::vec3 p = mesh.positions[i] + 0.0f;
    return std::make_tuple(std::bit_cast<std::uint32_t>(p.x), std::bit_cast<std::uint32_t>(p.y),
                           std::bit_cast<std::uint32_t>(p.z));
  };
  std::vector<std::uint32_t> order(n);
  for (std::size_t i = 0; i < n; ++i) order[i] = std::uint32_t(i);
  std::sort(order.begin(), order.end(),
            [&](std::uint32_t i, std::uint32_t j) { return std::make_pair(key(i), i) < std::make_pair(key(j), j); });
  std::vector<std::uint32_t> first(n);  // the lowest vertex at the same position
  for (std::size_t k = 0; k < n; ++k) {
    first[order[k]] = k > 0 && key(order[k]) == key(order[k - 1]) ? first[order[k - 1]] : order[k];
  }

  std::vector<glm::dvec3> sums(n, glm::dvec3(0.0));
  for (std::size_t t = 0; t < mesh.indices.size() / 3; ++t) {
    const glm::dvec3 normal = area_normal(mesh, t);
    for (std::size_t k = 0; k < 3; ++k) sums[first[mesh.indices[3 * t + k]]] += normal;
  }
  std::vector<glm::vec3> normals(n);
  for (std::size_t i = 0; i < n; ++i) normals[i] = unit_or_zero(sums[first[i]]);
  return normals;
}

}  // namespace lode::geometry
