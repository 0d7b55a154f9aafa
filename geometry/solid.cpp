#include "geometry/solid.h"

#include <algorithm>
#include <cmath>
#include <glm/geometric.hpp>
#include <glm/vec2.hpp>
#include <utility>

#include "geometry/closed_parts.h"
#include "geometry/predicates.h"

namespace lode::geometry {
namespace {

int sign(double x) { return (x > 0.0) - (x < 0.0); }

/// The side of p beside the line from a to b, after p has moved by (ε, ε²), ε > 0 below every number: 0 only if a = b.
int perturbed_side(const glm::dvec2& a, const glm::dvec2& b, const glm::dvec2& p) {
  const int side = orientation(a, b, p);
  if (side != 0) return side;
  return a.y != b.y ? sign(a.y - b.y) : sign(b.x - a.x);
}

/// +1 if the line up along z through q, moved as above, leaves through the triangle, −1 if it enters, 0 if it misses.
/// No line meets a triangle that is seen edge-on, nor an edge.
int facing_of_crossing(const SpaceTriangle& t, const glm::dvec2& q) {
  const glm::dvec2 a(t[0]), b(t[1]), c(t[2]);
  const int facing = orientation(a, b, c);
  if (facing == 0) return 0;
  const bool met =
      perturbed_side(a, b, q) == facing && perturbed_side(b, c, q) == facing && perturbed_side(c, a, q) == facing;
  return met ? facing : 0;
}

/// Of the plane of the triangle at q.
double height_at(const SpaceTriangle& t, const glm::dvec2& q) {
  const glm::dvec3 normal = glm::cross(t[1] - t[0], t[2] - t[0]);
  return t[0].z - (normal.x * (q.x - t[0].x) + normal.y * (q.y - t[0].y)) / normal.z;
}

bool in_column(const Bounds& box, const glm::dvec2& q) {
  return box.low.x <= q.x && q.x <= box.high.x && box.low.y <= q.y && q.y <= box.high.y;
}

bool holds(const Bounds& outer, const Bounds& inner) {
  return outer.low.x <= inner.low.x && outer.low.y <= inner.low.y && outer.low.z <= inner.low.z &&
         inner.high.x <= outer.high.x && inner.high.y <= outer.high.y && inner.high.z <= outer.high.z;
}

}  // namespace

Solid::Solid(std::span<const glm::vec3> positions, std::span<const std::uint32_t> indices) {
  ClosedParts closed = closed_parts(positions, indices);
  n_inward_ = closed.n_inward;
  n_open_ = closed.n_open;
  n_dropped_ = closed.n_dropped;
  parts_.reserve(closed.outward.size());
  for (ClosedPart& part : closed.outward) {
    Bounds bounds;
    for (const SpaceTriangle& t : part.triangles) {
      for (const glm::dvec3& p : t) bounds.add(p);
    }
    parts_.push_back({bounds, part.volume, TriangleTree(std::move(part.triangles))});
  }
}

double Solid::volume() const {
  double sum = 0.0;
  for (const Part& part : parts_) sum += part.volume;
  return sum;
}

int Solid::winding(std::size_t part, const glm::dvec3& p) const {
  int n = 0;
  const glm::dvec2 q(p);
  (void)parts_[part].tree.all_of([&](const Bounds& box) { return in_column(box, q) && p.z <= box.high.z; },
                                 [&](const SpaceTriangle& t) {
                                   const int facing = facing_of_crossing(t, q);
                                   if (facing != 0 && orientation(t[0], t[1], t[2], p) == -facing) n += facing;
                                   return true;
                                 });
  return n;
}

std::vector<Solid::Crossing> Solid::crossings(std::size_t part, double x, double y) const {
  std::vector<Crossing> found;
  const glm::dvec2 q(x, y);
  (void)parts_[part].tree.all_of([&](const Bounds& box) { return in_column(box, q); },
                                 [&](const SpaceTriangle& t) {
                                   const int facing = facing_of_crossing(t, q);
                                   if (facing != 0) found.push_back({height_at(t, q), facing});
                                   return true;
                                 });
  return found;
}

bool Solid::contains(const glm::dvec3& p) const {
  for (std::size_t i = 0; i < parts_.size(); ++i) {
    if (winding(i, p) >= 1) return true;
  }
  return false;
}

/// The inside of a convex body hangs together: no surface in it, so one winding number.
bool Solid::contains_body(const ConvexBody& body) const {
  const std::optional<glm::dvec3> p = body.inner_point();
  if (!p) return false;
  for (std::size_t i = 0; i < parts_.size(); ++i) {
    if (!holds(parts_[i].bounds, body.bounds()) || winding(i, *p) < 1) continue;
    const bool no_surface_inside = parts_[i].tree.all_of([&](const Bounds& box) { return !body.misses(box); },
                                                         [&](const SpaceTriangle& t) { return body.misses(t); });
    if (no_surface_inside) return true;
  }
  return false;
}

bool Solid::contains_hull(std::span<const glm::vec3> points) const {
  const std::optional<ConvexBody> body = ConvexBody::of_points(points);
  return body && contains_body(*body);
}

bool Solid::contains_box(const glm::vec3& low, const glm::vec3& high) const {
  const std::optional<ConvexBody> body = ConvexBody::of_box(low, high);
  return body && contains_body(*body);
}

}  // namespace lode::geometry
