#include "geometry/mesh.h"

#include <algorithm>
#include <bit>
#include <cmath>
#include <glm/geometric.hpp>
#include <span>
#include <tuple>
#include <utility>

namespace lode::geometry {
namespace {

/// Twice the triangle's area along its normal: counter-clockwise as seen from where it points.
glm::dvec3 area_normal(const Mesh& mesh, std::size_t triangle) {
  const glm::dvec3 a(mesh.positions[mesh.indices[3 * triangle]]);
  const glm::dvec3 b(mesh.positions[mesh.indices[3 * triangle + 1]]);
  const glm::dvec3 c(mesh.positions[mesh.indices[3 * triangle + 2]]);
  return glm::cross(b - a, c - a);
}

constexpr double kCreaseCosine = 0.5;              // 60°
constexpr std::size_t kMostCornersSmoothed = 256;  // the work at a position is the square of its corners

/// (0,0,0) stays. Float differences squared twice stay within double's range, so that no scaling is needed.
glm::dvec3 unit_or_zero(const glm::dvec3& n) {
  const double squared = glm::dot(n, n);
  return squared > 0.0 && std::isfinite(squared) ? n / std::sqrt(squared) : glm::dvec3(0.0);
}

/// For each vertex, the lowest one at the same position; −0 counts as +0.
std::vector<std::uint32_t> groups_by_position(const Mesh& mesh) {
  const std::size_t n = mesh.positions.size();
  const auto key = [&](std::uint32_t i) {
    const glm::vec3 p = mesh.positions[i] + 0.0f;
    return std::make_tuple(std::bit_cast<std::uint32_t>(p.x), std::bit_cast<std::uint32_t>(p.y),
                           std::bit_cast<std::uint32_t>(p.z));
  };
  std::vector<std::uint32_t> order(n), group(n);  // equal positions are made neighbours by sorting
  for (std::size_t i = 0; i < n; ++i) order[i] = std::uint32_t(i);
  std::sort(order.begin(), order.end(),
            [&](std::uint32_t i, std::uint32_t j) { return std::make_pair(key(i), i) < std::make_pair(key(j), j); });
  for (std::size_t k = 0; k < n; ++k) {
    group[order[k]] = k > 0 && key(order[k]) == key(order[k - 1]) ? group[order[k - 1]] : order[k];
  }
  return group;
}

/// A mesh whose corners get their normals one by one. A vertex takes the first of them; for each other one a copy of the
/// vertex is put at the end, which later corners with that normal share.
class CornerNormals {
 public:
  explicit CornerNormals(const Mesh& source)
      : mesh(source), newest_(source.positions.size(), kNone), older_(source.positions.size(), kNone) {
    mesh.normals.resize(mesh.positions.size(), glm::vec3(0.0f));
  }

  void set(std::size_t corner, const glm::vec3& normal, bool shared) {
    const std::uint32_t vertex = mesh.indices[corner];
    if (newest_[vertex] == kNone) {
      newest_[vertex] = vertex;
      mesh.normals[vertex] = normal;
      return;
    }
    std::uint32_t made = shared ? newest_[vertex] : kNone;
    while (made != kNone && mesh.normals[made] != normal) made = older_[made];
    if (made == kNone) {
      made = std::uint32_t(mesh.positions.size());
      mesh.positions.push_back(glm::vec3(mesh.positions[vertex]));
      mesh.normals.push_back(normal);
      if (!mesh.uvs.empty()) mesh.uvs.push_back(glm::vec2(mesh.uvs[vertex]));
      if (!mesh.colors.empty()) mesh.colors.push_back(glm::vec4(mesh.colors[vertex]));
      older_.push_back(newest_[vertex]);
      newest_[vertex] = made;
    }
    mesh.indices[corner] = made;
  }

  Mesh mesh;

 private:
  static constexpr std::uint32_t kNone = 0xFFFFFFFFu;
  std::vector<std::uint32_t> newest_;  ///< of each of the source's vertices: its last copy, itself at first
  std::vector<std::uint32_t> older_;   ///< of each copy: the one made before it
};

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
    result.normals[i] = i % 3 == 0 ? glm::vec3(unit_or_zero(area_normal(mesh, i / 3))) : result.normals[i - 1];
  }
  return result;
}

Mesh with_smooth_normals(const Mesh& mesh) {
  const std::size_t n_corners = mesh.indices.size();
  const std::vector<std::uint32_t> group = groups_by_position(mesh);
  std::vector<glm::dvec3> area(n_corners / 3), unit(n_corners / 3);
  for (std::size_t t = 0; t < n_corners / 3; ++t) {
    area[t] = area_normal(mesh, t);
    unit[t] = unit_or_zero(area[t]);
  }
  // Corners by group, in index order.
  std::vector<std::uint32_t> first(mesh.positions.size() + 1), corners(n_corners);
  for (const std::uint32_t index : mesh.indices) ++first[group[index] + 1];
  for (std::size_t g = 0; g < mesh.positions.size(); ++g) first[g + 1] += first[g];
  std::vector<std::uint32_t> next(first.begin(), first.end() - 1);
  for (std::size_t c = 0; c < n_corners; ++c) corners[next[group[mesh.indices[c]]]++] = std::uint32_t(c);

  CornerNormals result(mesh);
  for (std::size_t c = 0; c < n_corners; ++c) {
    const std::uint32_t g = group[mesh.indices[c]];
    if (!mesh.normals.empty() && mesh.normals[mesh.indices[c]] != glm::vec3(0.0f)) {
      result.set(c, mesh.normals[mesh.indices[c]], true);
      continue;
    }
    const std::span<const std::uint32_t> around(corners.data() + first[g], first[g + 1] - first[g]);
    if (around.size() > kMostCornersSmoothed) {
      result.set(c, glm::vec3(unit[c / 3]), false);
      continue;
    }
    glm::dvec3 sum(0.0);
    for (const std::uint32_t other : around) {
      if (glm::dot(unit[c / 3], unit[other / 3]) >= kCreaseCosine) sum += area[other / 3];
    }
    result.set(c, glm::vec3(unit_or_zero(sum)), true);
  }
  return std::move(result.mesh);
}

}  // namespace lode::geometry
