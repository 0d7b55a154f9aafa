#include "techniques/convex_culling/extreme_vertices.h"

#include <algorithm>

#include "geometry/hull.h"

namespace lode::techniques::convex_culling {

const std::vector<std::uint32_t>& ExtremeVertices::of(std::uint32_t node) {
  std::vector<std::uint32_t>& known = known_[node];
  const std::vector<std::uint32_t>& support = tree_[node].support;
  if (!known.empty() || support.empty()) return known;
  if (params_.on_stage) params_.on_stage(ApproximationStage::hulls);
  std::vector<glm::dvec3> points;
  for (const std::uint32_t v : support) points.emplace_back(mesh_.vertices[v]);
  for (const std::uint32_t i : geometry::convex_hull(points).vertices) known.push_back(support[i]);
  std::ranges::sort(known);
  if (params_.on_stage) params_.on_stage(ApproximationStage::partition);
  return known;
}

}  // namespace lode::techniques::convex_culling
