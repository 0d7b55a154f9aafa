#include "geometry/simplify.h"

#include <meshoptimizer.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <glm/geometric.hpp>
#include <span>
#include <tuple>
#include <utility>

#include "geometry/bounds.h"

namespace lode::geometry {
namespace {

constexpr double kSameNormal = 1e-3;         // of cosines: a crease differs by more
constexpr std::size_t kMostCandidates = 16;  // of a corner that are tried with each of the other corners'

bool is_whole(const Mesh& mesh) {
  const std::size_t n = mesh.positions.size();
  const auto fits = [&](std::size_t size) { return size == 0 || size == n; };
  return mesh.kind == MeshKind::triangles && mesh.indices.size() % 3 == 0 && fits(mesh.normals.size()) &&
         fits(mesh.uvs.size()) && fits(mesh.colors.size()) &&
         std::all_of(mesh.indices.begin(), mesh.indices.end(), [&](std::uint32_t i) {
           return i < n && std::isfinite(mesh.positions[i].x) && std::isfinite(mesh.positions[i].y) &&
                  std::isfinite(mesh.positions[i].z);
         });
}

/// The vertices in use, and which of them are at one position (−0 is +0).
struct WeldedVertices {
  std::vector<std::uint32_t> vertices;  ///< by position, then index
  std::vector<std::uint32_t> first;     ///< [points + 1] where in `vertices` each point's begin
  std::vector<std::uint32_t> point_of;  ///< [mesh vertices] of those in use
  [[nodiscard]] std::size_t n_points() const { return first.size() - 1; }
  [[nodiscard]] std::span<const std::uint32_t> at(std::uint32_t point) const {
    return {vertices.data() + first[point], first[point + 1] - first[point]};
  }
};

WeldedVertices weld(const Mesh& mesh) {
  WeldedVertices welded;
  welded.vertices = mesh.indices;
  const auto key = [&](std::uint32_t i) {
    const glm::vec3& p = mesh.positions[i];
    return std::make_tuple(p.x, p.y, p.z, i);
  };
  std::sort(welded.vertices.begin(), welded.vertices.end(),
            [&](std::uint32_t i, std::uint32_t j) { return key(i) < key(j); });
  welded.vertices.erase(std::unique(welded.vertices.begin(), welded.vertices.end()), welded.vertices.end());
  welded.point_of.resize(mesh.positions.size());
  for (std::size_t k = 0; k < welded.vertices.size(); ++k) {
    const std::uint32_t vertex = welded.vertices[k];
    if (k == 0 || mesh.positions[vertex] != mesh.positions[welded.vertices[k - 1]]) {
      welded.first.push_back(std::uint32_t(k));
    }
    welded.point_of[vertex] = std::uint32_t(welded.first.size() - 1);
  }
  welded.first.push_back(std::uint32_t(welded.vertices.size()));
  return welded;
}

/// As points, without the triangles that have two corners at one.
std::vector<std::uint32_t> triangles_of_points(const Mesh& mesh, const WeldedVertices& welded) {
  std::vector<std::uint32_t> corners;
  corners.reserve(mesh.indices.size());
  for (std::size_t c = 0; c < mesh.indices.size(); c += 3) {
    const std::uint32_t i = welded.point_of[mesh.indices[c]];
    const std::uint32_t j = welded.point_of[mesh.indices[c + 1]];
    const std::uint32_t k = welded.point_of[mesh.indices[c + 2]];
    if (i != j && j != k && k != i) corners.insert(corners.end(), {i, j, k});
  }
  return corners;
}

double longest_side(const Mesh& mesh, const WeldedVertices& welded) {
  Bounds box;
  for (const std::uint32_t vertex : welded.vertices) box.add(glm::dvec3(mesh.positions[vertex]));
  const glm::dvec3 size = box.high - box.low;
  return std::max({size.x, size.y, size.z});
}

/// In a box of side 1 at the origin, so that the library's floats neither overflow nor vanish.
std::vector<glm::vec3> scaled_points(const Mesh& mesh, const WeldedVertices& welded, double side) {
  const glm::dvec3 origin(mesh.positions[welded.vertices.front()]);
  std::vector<glm::vec3> points;
  points.reserve(welded.n_points());
  for (std::uint32_t k = 0; k < welded.n_points(); ++k) {
    points.emplace_back((glm::dvec3(mesh.positions[welded.at(k).front()]) - origin) / side);
  }
  return points;
}

glm::dvec3 unit_or_zero(const glm::dvec3& v) {
  const double length = glm::length(v);
  return length > 0.0 && std::isfinite(length) ? v / length : glm::dvec3(0.0);
}

/// Chooses, for the corners of a triangle, one of the vertices at each.
class CornerChoice {
 public:
  CornerChoice(const Mesh& mesh, const WeldedVertices& welded) : mesh_(mesh), welded_(welded) {}

  std::array<std::uint32_t, 3> operator()(const std::uint32_t* points) {
    glm::dvec3 p[3];
    for (int c = 0; c < 3; ++c) p[c] = glm::dvec3(mesh_.positions[welded_.at(points[c]).front()]);
    const glm::dvec3 facing = unit_or_zero(glm::cross(p[1] - p[0], p[2] - p[0]));
    for (std::size_t c = 0; c < 3; ++c) find_candidates(welded_.at(points[c]), facing, candidates_[c]);
    return least_span();
  }

 private:
  /// Those whose normals are nearest to the triangle's, at most kMostCandidates, in ascending order.
  void find_candidates(std::span<const std::uint32_t> vertices, const glm::dvec3& facing,
                       std::vector<std::uint32_t>& candidates) const {
    candidates.assign(vertices.begin(), vertices.end());
    if (candidates.size() > 1 && !mesh_.normals.empty()) {
      const auto agreement = [&](std::uint32_t v) {
        const double cosine = glm::dot(unit_or_zero(glm::dvec3(mesh_.normals[v])), facing);
        return cosine == cosine ? cosine : -2.0;
      };
      double best = -2.0;
      for (const std::uint32_t v : candidates) best = std::max(best, agreement(v));
      std::erase_if(candidates, [&](std::uint32_t v) { return agreement(v) < best - kSameNormal; });
    }
    if (candidates.size() > kMostCandidates) candidates.resize(kMostCandidates);
  }

  /// Of texture coordinates: the longest side of their triangle, squared. The first of equals.
  [[nodiscard]] std::array<std::uint32_t, 3> least_span() const {
    std::array<std::uint32_t, 3> best = {candidates_[0][0], candidates_[1][0], candidates_[2][0]};
    if (mesh_.uvs.empty()) return best;
    const auto side = [&](std::uint32_t i, std::uint32_t j) {
      const glm::dvec2 d = glm::dvec2(mesh_.uvs[i]) - glm::dvec2(mesh_.uvs[j]);
      return glm::dot(d, d);
    };
    double least = std::max({side(best[0], best[1]), side(best[1], best[2]), side(best[2], best[0])});
    for (const std::uint32_t i : candidates_[0]) {
      for (const std::uint32_t j : candidates_[1]) {
        for (const std::uint32_t k : candidates_[2]) {
          const double span = std::max({side(i, j), side(j, k), side(k, i)});
          if (span < least) least = span, best = {i, j, k};
        }
      }
    }
    return best;
  }

  const Mesh& mesh_;
  const WeldedVertices& welded_;
  std::vector<std::uint32_t> candidates_[3];
};

template <class T>
std::vector<T> those_of(const std::vector<T>& values, const std::vector<std::uint32_t>& vertices) {
  std::vector<T> result;
  if (values.empty()) return result;
  result.reserve(vertices.size());
  for (const std::uint32_t v : vertices) result.push_back(values[v]);
  return result;
}

/// The triangles' vertices and no others, in the input's order.
Mesh with_vertices_in_use(const Mesh& mesh, std::vector<std::uint32_t> indices) {
  std::vector<std::uint32_t> vertices = indices;
  std::sort(vertices.begin(), vertices.end());
  vertices.erase(std::unique(vertices.begin(), vertices.end()), vertices.end());
  for (std::uint32_t& i : indices) {
    i = std::uint32_t(std::lower_bound(vertices.begin(), vertices.end(), i) - vertices.begin());
  }
  Mesh result;
  result.kind = mesh.kind;
  result.positions = those_of(mesh.positions, vertices);
  result.indices = std::move(indices);
  result.normals = those_of(mesh.normals, vertices);
  result.uvs = those_of(mesh.uvs, vertices);
  result.colors = those_of(mesh.colors, vertices);
  result.material = mesh.material;
  return result;
}

}  // namespace

SimplifiedMesh simplify(const Mesh& mesh, double share) {
  if (!(share < 1.0) || mesh.indices.empty() || !is_whole(mesh)) return {.mesh = mesh};
  const WeldedVertices welded = weld(mesh);
  std::vector<std::uint32_t> corners = triangles_of_points(mesh, welded);
  const double side = longest_side(mesh, welded);
  if (corners.empty()) return {.mesh = mesh};

  const std::vector<glm::vec3> points = scaled_points(mesh, welded, side);
  const double wanted = std::max(1.0, std::round(std::max(share, 0.0) * double(mesh.n_primitives())));
  const std::size_t n_wanted = std::min(corners.size(), 3 * std::size_t(wanted));
  constexpr float kAnyError = 1.0f;  // of the mesh's extent
  float error = 0.0f;
  std::vector<std::uint32_t> kept(corners.size());
  kept.resize(meshopt_simplify(kept.data(), corners.data(), corners.size(), &points.front().x, points.size(),
                               sizeof(glm::vec3), n_wanted, kAnyError, 0, &error));
  if (kept.empty()) return {.mesh = mesh};

  CornerChoice choose(mesh, welded);
  for (std::size_t c = 0; c < kept.size(); c += 3) {
    const std::array<std::uint32_t, 3> vertices = choose(&kept[c]);
    std::copy(vertices.begin(), vertices.end(), kept.begin() + std::ptrdiff_t(c));
  }
  const double scale = double(meshopt_simplifyScale(&points.front().x, points.size(), sizeof(glm::vec3)));
  return {.mesh = with_vertices_in_use(mesh, std::move(kept)), .error = double(error) * scale * side};
}

}  // namespace lode::geometry
