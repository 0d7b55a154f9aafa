#include "geometry/inner_hulls.h"

#include <algorithm>
#include <cmath>

#include "geometry/hull.h"

namespace lode::geometry {
namespace {

/// None if the points span no volume.
std::vector<glm::dvec3> extreme_points(std::span<const glm::vec3> points) {
  const std::vector<glm::dvec3> exact(points.begin(), points.end());
  if (!std::ranges::all_of(exact, [](const glm::dvec3& p) { return std::isfinite(p.x + p.y + p.z); })) return {};
  const Hull hull = convex_hull(exact);
  std::vector<glm::dvec3> extreme;
  if (hull.kind != HullKind::polyhedron) return extreme;
  for (const std::uint32_t v : hull.vertices) extreme.push_back(exact[v]);
  return extreme;
}

std::vector<glm::vec3> shrunk(std::span<const glm::dvec3> points, float factor) {
  if (factor == 1.0f) return {points.begin(), points.end()};
  glm::dvec3 centroid(0.0);
  for (const glm::dvec3& p : points) centroid += p / double(points.size());
  std::vector<glm::vec3> result;
  for (const glm::dvec3& p : points) result.emplace_back(centroid + (p - centroid) * double(factor));
  return result;
}

}  // namespace

std::vector<InnerHull> inner_hulls(const Solid& solid, std::span<const std::vector<glm::vec3>> hulls) {
  std::vector<InnerHull> result;
  for (std::size_t i = 0; i < hulls.size(); ++i) {
    const std::vector<glm::dvec3> points = extreme_points(hulls[i]);
    if (points.empty()) continue;
    for (const float factor : kInnerHullFactors) {
      std::vector<glm::vec3> inner = shrunk(points, factor);
      if (!solid.contains_hull(inner)) continue;
      result.push_back({std::move(inner), i, factor});
      break;
    }
  }
  return result;
}

}  // namespace lode::geometry
