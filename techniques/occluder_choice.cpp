#include "techniques/occluder_choice.h"

#include <algorithm>
#include <cmath>

namespace lode::techniques {
namespace {

double orthographic_area(const geometry::Bounds& box) {
  if (box.empty()) return 0.0;
  const glm::dvec3 side = box.high - box.low;
  const double area = (side.y * side.z + side.z * side.x) + side.x * side.y;
  return std::isfinite(area) ? area : 0.0;
}

/// 0 inside.
double distance_to(const geometry::Bounds& box, const glm::dvec3& p) {
  return glm::length(glm::clamp(p, box.low, box.high) - p);
}

double diagonal_with(geometry::Bounds box, const glm::dvec3& eye) {
  box.add(eye);
  return box.diagonal();
}

struct Candidate {
  double degree;
  ObjectId id;
};

}  // namespace

std::vector<double> occluder_areas(const World& world) {
  std::vector<char> hides;
  for (std::uint32_t shape = 0; shape < world.n_shapes(); ++shape) hides.push_back(world.shape(shape).hides);
  std::vector<double> areas;
  for (const WorldObject& object : world.objects()) {
    areas.push_back(hides[object.shape] ? orthographic_area(object.bounds) : 0.0);
  }
  return areas;
}

double occluder_degree(double distance, double far, double area, double largest_area) {
  return std::max(1.0 - distance / far, 0.0) * (area / largest_area);
}

std::vector<ObjectId> choose_occluders(const World& world, const View& view, std::span<const ObjectId> candidates,
                                       std::span<const double> areas, const OccluderRule& rule) {
  double largest_area = 0.0;
  for (const ObjectId id : candidates) largest_area = std::max(largest_area, areas[id]);
  const double far = rule.far > 0.0 ? rule.far : diagonal_with(world.bounds(), view.camera.eye);
  if (!(largest_area > 0.0) || !(far > 0.0)) return {};

  std::vector<Candidate> chosen;
  for (const ObjectId id : candidates) {
    if (!(areas[id] > 0.0)) continue;
    const double distance = distance_to(world.objects()[id].bounds, view.camera.eye);
    const double degree = occluder_degree(distance, far, areas[id], largest_area);
    if (degree > 0.0 && degree >= rule.least_degree) chosen.push_back({degree, id});
  }
  std::sort(chosen.begin(), chosen.end(), [](const Candidate& a, const Candidate& b) {
    return a.degree != b.degree ? a.degree > b.degree : a.id < b.id;
  });
  chosen.resize(std::min(chosen.size(), std::size_t(std::max(rule.most, 0))));
  std::vector<ObjectId> ids;
  for (const Candidate& candidate : chosen) ids.push_back(candidate.id);
  return ids;
}

}  // namespace lode::techniques
