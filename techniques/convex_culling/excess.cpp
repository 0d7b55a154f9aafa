#include "techniques/convex_culling/excess.h"

#include <algorithm>

#include "techniques/convex_culling/coverage_error.h"

namespace lode::techniques::convex_culling {
namespace {

constexpr int kRandomDirections = 10, kLines = 96;

}  // namespace

Excess excess(std::span<const glm::vec3> positions, std::span<const std::uint32_t> indices,
              std::span<const std::vector<glm::vec3>> hulls) {
  Excess result{0.0, std::vector<double>(hulls.size(), 0.0), {}};
  std::vector<double> largest(hulls.size(), 0.0);
  double largest_model = 0.0;
  for (const glm::dvec3& direction : measured_directions(kRandomDirections)) {
    const EachCoverage found = each_coverage(positions, indices, hulls, direction, kLines);
    largest_model = std::max(largest_model, found.all.model_area);
    if (found.all.model_area > 0.0) result.model = std::max(result.model, found.all.over / found.all.model_area);
    for (std::size_t i = 0; i < hulls.size(); ++i) {
      largest[i] = std::max(largest[i], found.hulls[i].area);
      result.hulls[i] = std::max(result.hulls[i], found.hulls[i].over);
    }
  }
  for (std::size_t i = 0; i < hulls.size(); ++i) {
    if (largest[i] > 0.0) result.hulls[i] /= largest[i];
    result.sizes.push_back(largest_model > 0.0 ? largest[i] / largest_model : 0.0);
  }
  return result;
}

}  // namespace lode::techniques::convex_culling
