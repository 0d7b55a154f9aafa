#include "geometry/triangle_tree.h"

#include <algorithm>
#include <utility>

namespace lode::geometry {
namespace {

constexpr std::uint32_t kMostInLeaf = 4;

/// Thrice the centroid.
glm::dvec3 corner_sum(const SpaceTriangle& t) { return (t[0] + t[1]) + t[2]; }

}  // namespace

TriangleTree::TriangleTree(std::vector<SpaceTriangle> triangles) : triangles_(std::move(triangles)) {
  if (triangles_.empty()) return;
  nodes_.reserve(triangles_.size());
  nodes_.emplace_back();
  split(0, 0, std::uint32_t(triangles_.size()));
}

void TriangleTree::split(std::uint32_t node, std::uint32_t first, std::uint32_t n) {
  Bounds bounds, sums;
  for (std::uint32_t i = first; i < first + n; ++i) {
    for (const glm::dvec3& p : triangles_[i]) bounds.add(p);
    sums.add(corner_sum(triangles_[i]));
  }
  nodes_[node].bounds = bounds;
  if (n <= kMostInLeaf) {
    nodes_[node].first = first;
    nodes_[node].n_triangles = n;
    return;
  }
  const glm::dvec3 side = sums.high - sums.low;
  const int axis = side.x >= side.y && side.x >= side.z ? 0 : (side.y >= side.z ? 1 : 2);
  const auto begin = triangles_.begin() + first;
  std::nth_element(begin, begin + n / 2, begin + n, [axis](const SpaceTriangle& a, const SpaceTriangle& b) {
    return corner_sum(a)[axis] < corner_sum(b)[axis];
  });
  const std::uint32_t child = std::uint32_t(nodes_.size());
  nodes_[node].first = child;
  nodes_.resize(nodes_.size() + 2);
  split(child, first, n / 2);
  split(child + 1, first + n / 2, n - n / 2);
}

}  // namespace lode::geometry
