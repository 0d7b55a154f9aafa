#include "geometry/inner_grid.h"

#include <algorithm>
#include <cmath>
#include <glm/geometric.hpp>
#include <map>
#include <utility>

namespace lode::geometry {
namespace {

constexpr std::size_t kMostFacePlanes = 16;

/// About the area of the part's faces across the axis at each place, in order of places.
std::map<float, double> face_areas(const TriangleTree& tree, int axis) {
  std::vector<std::pair<float, double>> faces;
  for (const SpaceTriangle& t : tree.triangles()) {
    if (t[0][axis] != t[1][axis] || t[1][axis] != t[2][axis]) continue;
    faces.emplace_back(float(t[0][axis]), std::fabs(glm::cross(t[1] - t[0], t[2] - t[0])[axis]));
  }
  std::ranges::sort(faces);  // so that sums do not depend on the tree's order
  std::map<float, double> areas;
  for (const auto& [at, area] : faces) areas[at] += area;
  return areas;
}

/// The box's ends, the largest faces across the axis, and n − 1 even cuts but those close to one of these.
std::vector<float> planes_along(const Solid::Part& part, int axis, int n) {
  std::vector<std::pair<double, float>> faces;
  for (const auto& [at, area] : face_areas(part.tree, axis)) faces.emplace_back(-area, at);
  std::ranges::sort(faces);
  if (faces.size() > kMostFacePlanes) faces.resize(kMostFacePlanes);
  const double low = part.bounds.low[axis], side = (part.bounds.high[axis] - low) / n;
  std::vector<float> planes = {float(low), float(part.bounds.high[axis])};
  for (const auto& [area, at] : faces) planes.push_back(at);
  std::ranges::sort(planes);
  const std::vector<float> fixed = planes;
  for (int i = 1; i < n; ++i) {
    const double at = low + i * side;
    const auto next = std::ranges::lower_bound(fixed, at, {}, [](float f) { return double(f); });
    const bool close =
        (next != fixed.end() && *next - at < 0.25 * side) || (next != fixed.begin() && at - *(next - 1) < 0.25 * side);
    if (!close) planes.push_back(float(at));
  }
  std::ranges::sort(planes);
  planes.erase(std::unique(planes.begin(), planes.end()), planes.end());
  return planes;
}

/// Whether the triangle enters the open box, shrunk by a millionth so that touching is none: the box's axes apart,
/// which its caller has tried. Akenine-Möller, "Fast 3D triangle-box overlap testing" (2001).
bool enters(const SpaceTriangle& t, const glm::dvec3& low, const glm::dvec3& high) {
  const glm::dvec3 centre = 0.5 * (low + high), half = (0.5 - 1e-6) * (high - low);
  const glm::dvec3 p[] = {t[0] - centre, t[1] - centre, t[2] - centre};
  const auto apart = [&](const glm::dvec3& axis) {
    const double d[] = {glm::dot(axis, p[0]), glm::dot(axis, p[1]), glm::dot(axis, p[2])};
    const double reach = glm::dot(glm::abs(axis), half);
    return std::min({d[0], d[1], d[2]}) >= reach || std::max({d[0], d[1], d[2]}) <= -reach;
  };
  const glm::dvec3 edges[] = {p[1] - p[0], p[2] - p[1], p[0] - p[2]};
  const glm::dvec3 normal = glm::cross(edges[0], edges[1]);
  if (normal != glm::dvec3(0.0) && apart(normal)) return false;
  for (const glm::dvec3& e : edges) {
    for (const glm::dvec3& axis : {glm::dvec3(0, -e.z, e.y), glm::dvec3(e.z, 0, -e.x), glm::dvec3(-e.y, e.x, 0)}) {
      if (axis != glm::dvec3(0.0) && apart(axis)) return false;
    }
  }
  return true;
}

template <class Function>
void for_each_cell(const CellBox& box, const Function& function) {
  for (int z = box.low.z; z < box.high.z; ++z) {
    for (int y = box.low.y; y < box.high.y; ++y) {
      for (int x = box.low.x; x < box.high.x; ++x) function(glm::ivec3(x, y, z));
    }
  }
}

/// What is in a box, from sums over all that is before a corner. `sums` holds (size.x + 1) · (size.y + 1) · …
template <class T>
T box_sum(const std::vector<T>& sums, const glm::ivec3& size, const CellBox& box) {
  const auto at = [&](int x, int y, int z) {
    return sums[(std::size_t(z) * std::size_t(size.y + 1) + std::size_t(y)) * std::size_t(size.x + 1) + std::size_t(x)];
  };
  const auto plane = [&](int z) {
    return at(box.high.x, box.high.y, z) - at(box.low.x, box.high.y, z) - at(box.high.x, box.low.y, z) +
           at(box.low.x, box.low.y, z);
  };
  return plane(box.high.z) - plane(box.low.z);
}

}  // namespace

InnerGrid::InnerGrid(const Solid& solid, std::size_t part, int resolution) {
  const Bounds& bounds = solid.parts()[part].bounds;
  const glm::dvec3 sides = bounds.high - bounds.low;
  const double longest = std::max({sides.x, sides.y, sides.z});
  for (int axis = 0; axis < 3; ++axis) {
    const int even = int(std::ceil(sides[axis] / longest * resolution));
    planes_[std::size_t(axis)] = planes_along(solid.parts()[part], axis, std::max(even, (resolution + 7) / 8));
    size_[axis] = int(planes_[std::size_t(axis)].size()) - 1;
  }
  find_cells_inside(solid, part);
  covered_.assign(inside_.size(), 0);
  sum_up();
}

/// Those with a common point inside with the triangle's box: none where it lies in a plane between cells.
CellBox InnerGrid::cells_of(const SpaceTriangle& t) const {
  CellBox box;
  for (int axis = 0; axis < 3; ++axis) {
    const std::vector<float>& planes = planes_[std::size_t(axis)];
    const auto [low, high] = std::minmax({t[0][axis], t[1][axis], t[2][axis]});
    const auto first = std::ranges::upper_bound(planes, low) - planes.begin();
    const auto last = std::ranges::lower_bound(planes, high) - planes.begin();
    box.low[axis] = std::max(int(first) - 1, 0);
    box.high[axis] = std::min(int(last), size_[axis]);
  }
  return box;
}

void InnerGrid::find_cells_inside(const Solid& solid, std::size_t part) {
  inside_.assign(std::size_t(size_.x) * std::size_t(size_.y) * std::size_t(size_.z), 1);
  for (const SpaceTriangle& t : solid.parts()[part].tree.triangles()) {
    for_each_cell(cells_of(t), [&](const glm::ivec3& i) {
      if (inside_[cell(i)] && enters(t, glm::dvec3(corner(i)), glm::dvec3(corner(i + 1)))) inside_[cell(i)] = 0;
    });
  }
  const auto middle = [](const std::vector<float>& planes, int i) {
    return 0.5 * double(planes[std::size_t(i)]) + 0.5 * double(planes[std::size_t(i) + 1]);
  };
  for_each_cell({glm::ivec3(0), {size_.x, size_.y, 1}}, [&](const glm::ivec3& column) {
    const auto crossings = solid.crossings(part, middle(planes_[0], column.x), middle(planes_[1], column.y));
    for (glm::ivec3 i = column; i.z < size_.z; ++i.z) {
      if (inside_[cell(i)] == 0) continue;
      int winding = 0;
      for (const Solid::Crossing& c : crossings) winding += c.z > middle(planes_[2], i.z) ? c.facing : 0;
      inside_[cell(i)] = winding >= 1 ? 1 : 0;
    }
  });
}

void InnerGrid::sum_up() {
  const glm::ivec3 n = size_ + 1;
  n_inside_.assign(std::size_t(n.x) * std::size_t(n.y) * std::size_t(n.z), 0);
  uncovered_.assign(n_inside_.size(), 0.0);
  const auto at = [&](int x, int y, int z) {
    return (std::size_t(z) * std::size_t(n.y) + std::size_t(y)) * std::size_t(n.x) + std::size_t(x);
  };
  for_each_cell({glm::ivec3(0), size_}, [&](const glm::ivec3& i) {
    const glm::dvec3 side = glm::dvec3(corner(i + 1)) - glm::dvec3(corner(i));
    const auto sum = [&](auto& sums, auto own) {
      const int x = i.x, y = i.y, z = i.z;
      sums[at(x + 1, y + 1, z + 1)] = own + sums[at(x, y + 1, z + 1)] + sums[at(x + 1, y, z + 1)] +
                                      sums[at(x + 1, y + 1, z)] - sums[at(x, y, z + 1)] - sums[at(x, y + 1, z)] -
                                      sums[at(x + 1, y, z)] + sums[at(x, y, z)];
    };
    sum(n_inside_, std::int32_t(inside_[cell(i)]));
    sum(uncovered_, inside_[cell(i)] && !covered_[cell(i)] ? side.x * side.y * side.z : 0.0);
  });
}

bool InnerGrid::all_inside(const CellBox& box) const {
  const glm::ivec3 side = box.high - box.low;
  return box_sum(n_inside_, size_, box) == side.x * side.y * side.z;
}

double InnerGrid::uncovered(const CellBox& box) const { return box_sum(uncovered_, size_, box); }

void InnerGrid::cover(const CellBox& box) {
  for_each_cell(box, [&](const glm::ivec3& i) { covered_[cell(i)] = 1; });
  sum_up();
}

}  // namespace lode::geometry
