#include "techniques/convex_culling/support_vertices.h"

#include <algorithm>
#include <cmath>
#include <glm/geometric.hpp>
#include <limits>
#include <stdexcept>
#include <string>

#include "geometry/bounds.h"
#include "geometry/trigonometry.h"

namespace lode::techniques::convex_culling {

std::vector<glm::dvec3> sphere_directions(double step_deg) {
  const double steps = 180.0 / step_deg;
  if (!(step_deg >= 5.0 && step_deg <= 90.0) || steps != std::floor(steps)) {
    throw std::logic_error("sphere_directions: expected 180/step to be whole and the step 5 to 90 degrees, found " +
                           std::to_string(step_deg));
  }
  const int n = int(steps);
  std::vector<glm::dvec3> directions = {{0, -1, 0}};
  for (int i = 1; i < n; ++i) {
    const auto latitude = geometry::sin_cos((double(i) / double(n) - 0.5) * geometry::kPi);
    for (int k = 0; k < 2 * n; ++k) {
      const auto longitude = geometry::sin_cos(double(k) / double(n) * geometry::kPi);
      directions.emplace_back(latitude.cos * longitude.cos, latitude.sin, latitude.cos * longitude.sin);
    }
  }
  directions.emplace_back(0, 1, 0);
  return directions;
}

std::vector<std::uint32_t> support_vertices(std::span<const glm::vec3> positions,
                                            std::span<const std::uint32_t> vertices,
                                            std::span<const glm::dvec3> directions, SupportRule rule) {
  geometry::Bounds box;
  for (const std::uint32_t v : vertices) box.add(glm::dvec3(positions[v]));
  const glm::dvec3 centre = box.centre();
  // |p − r·d|² = |p|² − 2·r·(p·d) + r², for p from the centre: the nearest has the least of |p|² − 2·r·(p·d).
  double radius_2 = 0.0;
  for (const std::uint32_t v : vertices) {
    const glm::dvec3 p = glm::dvec3(positions[v]) - centre;
    radius_2 = std::max(radius_2, glm::dot(p, p));
  }
  const double radius = std::sqrt(radius_2), of_square = rule == SupportRule::nearest_to_sphere ? 1.0 : 0.0;
  const double of_dot = rule == SupportRule::nearest_to_sphere ? 2.0 * radius : 1.0;
  std::vector<double> least(directions.size(), std::numeric_limits<double>::infinity());
  std::vector<std::uint32_t> chosen(directions.size(), vertices.front());
  for (const std::uint32_t v : vertices) {
    const glm::dvec3 p = glm::dvec3(positions[v]) - centre;
    const double square = of_square * glm::dot(p, p);
    for (std::size_t k = 0; k < directions.size(); ++k) {
      const double measure = square - of_dot * glm::dot(p, directions[k]);
      if (measure > least[k] || (measure == least[k] && v >= chosen[k])) continue;
      least[k] = measure;
      chosen[k] = v;
    }
  }
  std::ranges::sort(chosen);
  chosen.erase(std::unique(chosen.begin(), chosen.end()), chosen.end());
  return chosen;
}

}  // namespace lode::techniques::convex_culling
