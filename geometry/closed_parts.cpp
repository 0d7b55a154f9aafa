#include "geometry/closed_parts.h"

#include <algorithm>
#include <cmath>
#include <glm/geometric.hpp>
#include <string>
#include <tuple>

#include "geometry/disjoint_sets.h"
#include "geometry/error.h"

namespace lode::geometry {
namespace {

using Corners = std::array<std::uint32_t, 3>;

[[noreturn]] void fail(const std::string& expected, const std::string& found) {
  throw Error(ErrorKind::bad_input, "solid: expected " + expected + ", found " + found);
}

void check(std::span<const glm::vec3> positions, std::span<const std::uint32_t> indices) {
  if (positions.size() > 0xFFFFFFFFu || indices.size() / 3 >= 0x7FFFFFFFu) {
    fail("fewer than 2^31 triangles", std::to_string(indices.size() / 3));
  }
  if (indices.size() % 3 != 0) fail("three indices a triangle", std::to_string(indices.size()) + " indices");
  for (std::size_t i = 0; i < indices.size(); ++i) {
    if (indices[i] >= positions.size()) {
      fail("index " + std::to_string(i) + " below " + std::to_string(positions.size()), std::to_string(indices[i]));
    }
    const glm::vec3& p = positions[indices[i]];
    if (!std::isfinite(p.x) || !std::isfinite(p.y) || !std::isfinite(p.z)) {
      fail("finite positions", "position " + std::to_string(indices[i]) + " not finite");
    }
  }
}

/// For each vertex that is used, the first one in order of positions at the same place.
std::vector<std::uint32_t> vertices_by_place(std::span<const glm::vec3> positions,
                                             std::span<const std::uint32_t> indices) {
  std::vector<std::uint32_t> order(indices.begin(), indices.end()), place(positions.size());
  const auto key = [&](std::uint32_t i) { return std::tuple(positions[i].x, positions[i].y, positions[i].z); };
  std::ranges::sort(order);
  order.erase(std::unique(order.begin(), order.end()), order.end());
  std::ranges::stable_sort(order, {}, key);
  for (std::size_t k = 0; k < order.size(); ++k) {
    place[order[k]] = k > 0 && key(order[k]) == key(order[k - 1]) ? place[order[k - 1]] : order[k];
  }
  return place;
}

struct EdgeUse {
  std::uint32_t low, high;  ///< vertices
  std::uint32_t triangle;
  bool upwards;  ///< from low to high
};

/// Joins the triangles along each edge; returns those at edges that do not balance.
std::vector<std::uint32_t> join_along_edges(std::span<const Corners> triangles, DisjointSets& groups) {
  std::vector<EdgeUse> uses;
  uses.reserve(3 * triangles.size());
  for (std::uint32_t t = 0; t < triangles.size(); ++t) {
    for (std::size_t k = 0; k < 3; ++k) {
      const std::uint32_t a = triangles[t][k], b = triangles[t][(k + 1) % 3];
      uses.push_back({std::min(a, b), std::max(a, b), t, a < b});
    }
  }
  std::ranges::sort(uses, {}, [](const EdgeUse& u) { return std::tuple(u.low, u.high, u.triangle, u.upwards); });
  std::vector<std::uint32_t> open;
  for (std::size_t first = 0, last; first < uses.size(); first = last) {
    std::int64_t balance = 0;
    for (last = first; last < uses.size() && uses[last].low == uses[first].low && uses[last].high == uses[first].high;
         ++last) {
      balance += uses[last].upwards ? 1 : -1;
      groups.join(uses[first].triangle, uses[last].triangle);
    }
    if (balance != 0) open.push_back(uses[first].triangle);
  }
  return open;
}

/// Six times the volume is a sum of n determinants of differences, each within 8 roundings of 2^-53 of its terms'
/// magnitudes, added up with n roundings of at most the sum of these. 0 unless it is positive beyond twice that.
double sure_volume(std::span<const SpaceTriangle> triangles) {
  const glm::dvec3 origin = triangles.front()[0];
  double sum = 0.0, magnitude = 0.0;
  for (const SpaceTriangle& t : triangles) {
    const glm::dvec3 a = t[0] - origin, b = t[1] - origin, c = t[2] - origin;
    const glm::dvec3 A = glm::abs(a), B = glm::abs(b), C = glm::abs(c);
    sum += glm::dot(a, glm::cross(b, c));
    magnitude += glm::dot(A, glm::dvec3(B.y * C.z + B.z * C.y, B.z * C.x + B.x * C.z, B.x * C.y + B.y * C.x));
  }
  return sum > magnitude * 0x1p-52 * (double(triangles.size()) + 16.0) ? sum / 6.0 : 0.0;
}

}  // namespace

ClosedParts closed_parts(std::span<const glm::vec3> positions, std::span<const std::uint32_t> indices) {
  check(positions, indices);
  const std::vector<std::uint32_t> place = vertices_by_place(positions, indices);
  ClosedParts parts;
  std::vector<Corners> triangles;
  for (std::size_t i = 0; i < indices.size(); i += 3) {
    const Corners t = {place[indices[i]], place[indices[i + 1]], place[indices[i + 2]]};
    if (t[0] == t[1] || t[1] == t[2] || t[2] == t[0]) {
      ++parts.n_dropped;
    } else {
      triangles.push_back(t);
    }
  }
  DisjointSets groups(triangles.size());
  std::vector<bool> open(triangles.size());  // of the first triangle of each part
  for (const std::uint32_t t : join_along_edges(triangles, groups)) open[groups.lowest(t)] = true;

  std::vector<std::vector<SpaceTriangle>> closed(triangles.size());
  for (std::uint32_t t = 0; t < triangles.size(); ++t) {
    const std::uint32_t first = groups.lowest(t);
    if (first == t && open[first]) ++parts.n_open;
    if (open[first]) continue;
    const auto& [a, b, c] = triangles[t];
    closed[first].push_back({glm::dvec3(positions[a]), glm::dvec3(positions[b]), glm::dvec3(positions[c])});
  }
  for (std::vector<SpaceTriangle>& part : closed) {
    if (part.empty()) continue;
    const double volume = sure_volume(part);
    if (volume > 0.0) {
      parts.outward.push_back({std::move(part), volume});
    } else {
      ++parts.n_inward;
    }
  }
  return parts;
}

}  // namespace lode::geometry
