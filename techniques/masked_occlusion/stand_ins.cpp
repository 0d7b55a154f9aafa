#include "techniques/masked_occlusion/stand_ins.h"

#include <algorithm>
#include <cmath>
#include <limits>

#include "geometry/camera.h"
#include "geometry/hull.h"

namespace lode::techniques {
namespace {

constexpr double kInset_px = 2.5 / 256.0;

/// The nearest float in the direction given.
float rounded_up(double v) {
  const auto f = float(v);
  return double{f} < v ? std::nextafter(f, std::numeric_limits<float>::infinity()) : f;
}
float rounded_down(double v) { return -rounded_up(-v); }

/// Corner k of a box: bits 0, 1, 2 choose high x, y, z. Two triangles a side, counter-clockwise from outside.
constexpr std::uint32_t kBoxCorners[36] = {0, 4, 6, 0, 6, 2, 1, 3, 7, 1, 7, 5, 0, 1, 5, 0, 5, 4,
                                           2, 6, 7, 2, 7, 3, 0, 2, 3, 0, 3, 1, 4, 5, 7, 4, 7, 6};

}  // namespace

StandIn hull_of(const Shape& shape) {
  const std::vector<glm::dvec3> points(shape.positions.begin(), shape.positions.end());
  const auto finite = [](const glm::dvec3& p) {
    return std::isfinite(p.x) && std::isfinite(p.y) && std::isfinite(p.z);
  };
  if (!std::all_of(points.begin(), points.end(), finite)) return {};
  const geometry::Hull hull = geometry::convex_hull(points);
  StandIn result;
  for (const std::uint32_t v : hull.vertices) result.positions.push_back(shape.positions[v]);
  for (const auto& triangle : hull.triangles) {
    for (const std::uint32_t v : triangle) {
      const auto at = std::lower_bound(hull.vertices.begin(), hull.vertices.end(), v);
      result.indices.push_back(std::uint32_t(at - hull.vertices.begin()));
    }
  }
  return result;
}

void add_box(const geometry::Bounds& box, const glm::dvec3& inset, StandIn& stand_in) {
  glm::vec3 low, high;
  for (int axis = 0; axis < 3; ++axis) {
    low[axis] = rounded_up(box.low[axis] + inset[axis]);
    high[axis] = rounded_down(box.high[axis] - inset[axis]);
    if (!(low[axis] < high[axis])) return;
  }
  const auto first = std::uint32_t(stand_in.positions.size());
  for (int k = 0; k < 8; ++k) {
    stand_in.positions.emplace_back(k & 1 ? high.x : low.x, k & 2 ? high.y : low.y, k & 4 ? high.z : low.z);
  }
  for (const std::uint32_t corner : kBoxCorners) stand_in.indices.push_back(first + corner);
}

glm::dvec3 inset_of(const View& view, const geometry::Bounds& world_box, const glm::dmat4& world_from_shape) {
  // World units a pixel, at the farthest point of the box in a perspective view.
  double per_px = 2.0 * geometry::half_extent(view.camera, view.size_px).y / double(std::max(view.size_px.y, 1));
  if (view.camera.projection == geometry::Projection::perspective) {
    double distance = 0.0;
    for (int k = 0; k < 8; ++k) {
      const glm::dvec3 corner(k & 1 ? world_box.high.x : world_box.low.x, k & 2 ? world_box.high.y : world_box.low.y,
                              k & 4 ? world_box.high.z : world_box.low.z);
      distance = std::max(distance, glm::dot(view.camera.back, view.camera.eye - corner));
    }
    per_px *= distance;
  }
  // The ball in the world is an ellipsoid in the shape's space, and this is its box: the lengths of the rows.
  const glm::dmat3 shape_from_world = glm::inverse(glm::dmat3(world_from_shape));
  glm::dvec3 inset;
  for (int axis = 0; axis < 3; ++axis) {
    const glm::dvec3 row(shape_from_world[0][axis], shape_from_world[1][axis], shape_from_world[2][axis]);
    inset[axis] = kInset_px * per_px * glm::length(row);
  }
  return inset;
}

raster::Draw stand_in_draw(const StandIn& stand_in, const glm::dmat4& clip_from_world,
                           const glm::dmat4& world_from_shape) {
  raster::Draw draw;
  draw.vertices = raster::ObjectVertices{stand_in.positions, clip_from_world * world_from_shape};
  draw.indices = stand_in.indices;
  draw.cull = geometry::mirrors(world_from_shape) ? raster::Cull::front : raster::Cull::back;
  return draw;
}

}  // namespace lode::techniques
