#include "techniques/convex_culling/coverage_error.h"

#include <algorithm>
#include <cmath>
#include <glm/common.hpp>
#include <glm/geometric.hpp>
#include <limits>
#include <stdexcept>

#include "geometry/random.h"
#include "techniques/convex_culling/line_union.h"

namespace lode::techniques::convex_culling {
namespace {

/// Two axes across a direction; for x, y and z the other two.
struct Plane {
  glm::dvec3 u, v;

  [[nodiscard]] glm::dvec2 flat(const glm::vec3& p) const {
    return {glm::dot(u, glm::dvec3(p)), glm::dot(v, glm::dvec3(p))};
  }
};

Plane plane_across(const glm::dvec3& direction) {
  const glm::dvec3 size = glm::abs(direction);
  if (!(size.x + size.y + size.z > 0.0) || !std::isfinite(size.x + size.y + size.z)) {
    throw std::logic_error("coverage_error: expected a direction that is finite and not 0");
  }
  const double largest = std::max({size.x, size.y, size.z});
  const glm::dvec3 d = glm::normalize(direction / largest);
  const int axis = size.x == largest ? 0 : size.y == largest ? 1 : 2;
  glm::dvec3 next(0.0);
  next[(axis + 1) % 3] = 1.0;
  const glm::dvec3 u = glm::normalize(next - glm::dot(next, d) * d);
  return {u, glm::cross(d, u)};
}

/// A model's silhouette along a direction, on lines that reach over it and over all hulls.
class Silhouette {
 public:
  Silhouette(std::span<const glm::vec3> positions, std::span<const std::uint32_t> indices,
             std::span<const std::vector<glm::vec3>> hulls, const glm::dvec3& direction, int n_lines)
      : plane_(plane_across(direction)) {
    if (n_lines < 1 || n_lines > 4096) throw std::logic_error("coverage_error: expected 1 to 4096 lines");
    double left = std::numeric_limits<double>::infinity(), right = -left;
    const auto widen = [&](const glm::vec3& p) {
      const double x = plane_.flat(p).x;
      left = std::min(left, x), right = std::max(right, x);
    };
    for (const std::uint32_t i : indices) widen(positions[i]);
    for (const std::vector<glm::vec3>& hull : hulls) std::ranges::for_each(hull, widen);
    if (left <= right) lines_ = {left, right, n_lines};
    model_.clear(lines_);
    for (std::size_t i = 0; i + 2 < indices.size(); i += 3) {
      model_.add_triangle(plane_.flat(positions[indices[i]]), plane_.flat(positions[indices[i + 1]]),
                          plane_.flat(positions[indices[i + 2]]));
    }
  }

  [[nodiscard]] CoverageError error_of(std::span<const std::vector<glm::vec3>> hulls, const glm::dvec3& direction) {
    hulls_.clear(lines_);
    for (const std::vector<glm::vec3>& hull : hulls) {
      flat_.clear();
      for (const glm::vec3& p : hull) flat_.push_back(plane_.flat(p));
      hulls_.add_hull(flat_);
    }
    return {direction, model_.area(), hulls_.area(), hulls_.area_without(model_), model_.area_without(hulls_)};
  }

 private:
  Plane plane_;
  Lines lines_;
  LineUnion model_, hulls_;
  std::vector<glm::dvec2> flat_;
};

}  // namespace

CoverageError coverage_error(std::span<const glm::vec3> positions, std::span<const std::uint32_t> indices,
                             std::span<const std::vector<glm::vec3>> hulls, const glm::dvec3& direction, int n_lines) {
  Silhouette silhouette(positions, indices, hulls, direction, n_lines);
  return silhouette.error_of(hulls, direction);
}

EachCoverage each_coverage(std::span<const glm::vec3> positions, std::span<const std::uint32_t> indices,
                           std::span<const std::vector<glm::vec3>> hulls, const glm::dvec3& direction, int n_lines) {
  Silhouette silhouette(positions, indices, hulls, direction, n_lines);
  EachCoverage result{silhouette.error_of(hulls, direction), {}};
  for (const std::vector<glm::vec3>& hull : hulls) {
    const CoverageError alone = silhouette.error_of({&hull, 1}, direction);
    result.hulls.push_back({alone.hull_area, alone.over});
  }
  return result;
}

std::vector<glm::dvec3> measured_directions(int n_random, std::uint64_t seed) {
  constexpr std::uint32_t kPurpose = 0x44495245;  // "DIRE"
  std::vector<glm::dvec3> directions = {{1, 0, 0}, {0, 1, 0}, {0, 0, 1}};
  for (int i = 0; i < n_random; ++i) {
    geometry::Random random(seed, kPurpose, std::uint64_t(i));
    for (;;) {  // in the ball, by rejection from the cube around it; not too near to its middle
      const double x = random.uniform(-1, 1), y = random.uniform(-1, 1), z = random.uniform(-1, 1);
      const glm::dvec3 d(x, y, z);
      const double square = glm::dot(d, d);
      if (square > 1.0 || square < 1e-4) continue;
      directions.push_back(d / std::sqrt(square));
      break;
    }
  }
  return directions;
}

}  // namespace lode::techniques::convex_culling
