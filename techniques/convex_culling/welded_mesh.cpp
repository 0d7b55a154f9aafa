#include "techniques/convex_culling/welded_mesh.h"

#include <algorithm>
#include <cmath>
#include <glm/common.hpp>
#include <glm/geometric.hpp>
#include <string>
#include <tuple>
#include <utility>

#include "geometry/disjoint_sets.h"
#include "geometry/error.h"

namespace lode::techniques::convex_culling {
namespace {

[[noreturn]] void refuse(const std::string& what) {
  throw geometry::Error(geometry::ErrorKind::bad_input, "convex approximation: " + what);
}

void check(std::span<const glm::vec3> positions, std::span<const std::uint32_t> indices, double tolerance) {
  if (!(tolerance >= 0.0 && tolerance <= 0.1))
    refuse("weld tolerance: expected 0 to 0.1, found " + std::to_string(tolerance));
  if (indices.size() % 3 != 0) refuse("expected a multiple of 3 indices, found " + std::to_string(indices.size()));
  if (positions.size() > 0x7FFFFFFFu || indices.size() / 3 > 0x7FFFFFFFu)
    refuse("expected fewer than 2^31 vertices and triangles");
  for (std::size_t i = 0; i < indices.size(); ++i) {
    const std::uint32_t v = indices[i];
    if (v >= positions.size()) {
      refuse("index " + std::to_string(i) + ": expected less than " + std::to_string(positions.size()) + ", found " +
             std::to_string(v));
    }
    const glm::vec3& p = positions[v];
    if (!std::isfinite(p.x) || !std::isfinite(p.y) || !std::isfinite(p.z)) {
      refuse("position " + std::to_string(v) + ": expected finite numbers, found " + std::to_string(p.x) + ", " +
             std::to_string(p.y) + ", " + std::to_string(p.z));
    }
  }
}

/// Vertices sorted by their cell of a grid; with cells of size 0, equal positions share one.
class Cells {
 public:
  using Cell = std::tuple<double, double, double>;

  Cells(std::span<const glm::vec3> positions, std::vector<std::uint32_t> used, const glm::dvec3& low, double size)
      : low_(low), size_(size) {
    for (const std::uint32_t i : used) entries_.push_back({cell(glm::dvec3(positions[i]), {0, 0, 0}), i});
    std::ranges::sort(entries_);
  }

  [[nodiscard]] Cell cell(const glm::dvec3& p, const glm::dvec3& step) const {
    const glm::dvec3 q = size_ > 0.0 ? glm::floor((p - low_) / size_) + step : p;
    return {q.x, q.y, q.z};
  }

  /// The entries in one cell, lowest index first.
  [[nodiscard]] std::span<const std::pair<Cell, std::uint32_t>> in(const Cell& cell) const {
    const auto cell_of = [](const auto& entry) { return entry.first; };
    const auto begin = std::ranges::lower_bound(entries_, cell, {}, cell_of);
    const auto end = std::ranges::upper_bound(entries_, cell, {}, cell_of);
    return {begin, end};
  }

 private:
  glm::dvec3 low_;
  double size_;
  std::vector<std::pair<Cell, std::uint32_t>> entries_;
};

/// What shares a cell of half the distance is nearer than it. In the cells around, a few vertices are looked at: were
/// it all, a heap of vertices in one cell would meet itself vertex by vertex.
void join_near(std::span<const glm::vec3> positions, const std::vector<std::uint32_t>& used, const glm::dvec3& low,
               double distance, geometry::DisjointSets& groups) {
  constexpr std::size_t kLookedAt = 8;
  const Cells cells(positions, used, low, 0.5 * distance);
  for (const std::uint32_t i : used) {
    const glm::dvec3 p(positions[i]);
    const auto own = cells.in(cells.cell(p, {0, 0, 0}));
    groups.join(own.front().second, i);
    for (int k = 0; distance > 0.0 && k < 27; ++k) {
      const auto near = cells.in(cells.cell(p, {k % 3 - 1, k / 3 % 3 - 1, k / 9 - 1}));
      for (const auto& [cell, j] : near.first(std::min(near.size(), kLookedAt))) {
        if (glm::length(glm::dvec3(positions[j]) - p) <= distance) groups.join(i, j);
      }
    }
  }
}

}  // namespace

WeldedMesh weld(std::span<const glm::vec3> positions, std::span<const std::uint32_t> indices, double tolerance) {
  check(positions, indices, tolerance);
  WeldedMesh mesh;
  std::vector<std::uint32_t> used(indices.begin(), indices.end());
  std::ranges::sort(used);
  used.erase(std::unique(used.begin(), used.end()), used.end());
  for (const std::uint32_t i : used) mesh.bounds.add(glm::dvec3(positions[i]));

  geometry::DisjointSets groups(positions.size());
  join_near(positions, used, mesh.bounds.low, tolerance * mesh.bounds.diagonal(), groups);
  constexpr std::uint32_t kNone = 0xFFFFFFFFu;
  std::vector<std::uint32_t> made(positions.size(), kNone);
  for (std::size_t i = 0; i < indices.size(); i += 3) {
    const std::array<std::uint32_t, 3> old = {groups.lowest(indices[i]), groups.lowest(indices[i + 1]),
                                              groups.lowest(indices[i + 2])};
    if (old[0] == old[1] || old[1] == old[2] || old[2] == old[0]) {
      ++mesh.n_dropped;
      continue;
    }
    std::array<std::uint32_t, 3> triangle{};
    for (std::size_t k = 0; k < 3; ++k) {
      if (made[old[k]] == kNone) {
        made[old[k]] = std::uint32_t(mesh.vertices.size());
        mesh.vertices.push_back(positions[old[k]]);
      }
      triangle[k] = made[old[k]];
    }
    mesh.triangles.push_back(triangle);
  }
  mesh.bounds = {};
  for (const glm::vec3& p : mesh.vertices) mesh.bounds.add(glm::dvec3(p));
  return mesh;
}

}  // namespace lode::techniques::convex_culling
