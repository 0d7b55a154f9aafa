#include "techniques/convex_culling/coverage_grid.h"

#include <algorithm>
#include <cmath>

#include "techniques/convex_culling/line_union.h"
#include "techniques/convex_culling/silhouette_area.h"

namespace lode::techniques::convex_culling {

CoverageGrid::CoverageGrid(const geometry::Bounds& bounds, int n) : n_(n), bounds_(bounds) {
  for (auto& counts : counts_) counts.assign(std::size_t(n) * std::size_t(n), 0u);
}

GridFootprint CoverageGrid::footprint(std::span<const glm::vec3> positions, std::span<const std::uint32_t> hull) const {
  GridFootprint result;
  std::vector<glm::dvec2> flat;
  for (int axis = 0; axis < 3 && !hull.empty(); ++axis) {
    GridFootprint::Plane& plane = result.planes[std::size_t(axis)];
    const int u = (axis + 1) % 3, v = (axis + 2) % 3;
    const Lines lines = {bounds_.low[u], bounds_.high[u], n_}, samples = {bounds_.low[v], bounds_.high[v], n_};
    flat.clear();
    for (const std::uint32_t i : hull) flat.push_back(along_axis(positions[i], axis));
    const auto [lower, upper] = rounded_chains(flat);
    std::size_t at_lower = 0, at_upper = 0;
    plane.first = lines.first_from(lower.front().x);
    for (int i = plane.first; i < n_ && lines.x(i) <= lower.back().x; ++i) {
      const double x = lines.x(i);
      const int low = samples.first_from(height(lower, x, at_lower));
      const int high = samples.first_from(height(upper, x, at_upper));
      plane.runs.push_back({std::uint16_t(low), std::uint16_t(std::max(low, high))});
    }
  }
  return result;
}

void CoverageGrid::add(const GridFootprint& hull) {
  for (std::size_t axis = 0; axis < 3; ++axis) {
    const GridFootprint::Plane& plane = hull.planes[axis];
    for (std::size_t i = 0; i < plane.runs.size(); ++i) {
      std::uint32_t* line = counts_[axis].data() + (std::size_t(plane.first) + i) * std::size_t(n_);
      for (std::size_t k = plane.runs[i].low; k < plane.runs[i].high; ++k) covered_[axis] += line[k]++ == 0;
    }
  }
}

void CoverageGrid::remove(const GridFootprint& hull) {
  for (std::size_t axis = 0; axis < 3; ++axis) {
    const GridFootprint::Plane& plane = hull.planes[axis];
    for (std::size_t i = 0; i < plane.runs.size(); ++i) {
      std::uint32_t* line = counts_[axis].data() + (std::size_t(plane.first) + i) * std::size_t(n_);
      for (std::size_t k = plane.runs[i].low; k < plane.runs[i].high; ++k) covered_[axis] -= --line[k] == 0;
    }
  }
}

double CoverageGrid::area() const { return area_of(covered_); }

double CoverageGrid::area_of(const std::array<std::int64_t, 3>& n_samples) const {
  double area = 0.0;
  for (int axis = 0; axis < 3; ++axis) {
    const glm::dvec3 size = bounds_.high - bounds_.low;
    const double cell = size[(axis + 1) % 3] / double(n_) * (size[(axis + 2) % 3] / double(n_));
    area += double(n_samples[std::size_t(axis)]) * cell;
  }
  return area;
}

}  // namespace lode::techniques::convex_culling
