#include "geometry/convex_body.h"

#include <algorithm>
#include <cmath>
#include <glm/geometric.hpp>
#include <map>
#include <utility>

#include "geometry/hull.h"
#include "geometry/predicates.h"

namespace lode::geometry {
namespace {

/// What rounding may have changed of a product of lengths, and more: where exact signs are worth asking for.
constexpr double kWorthTrying = 1e-9;

bool is_finite(const glm::vec3& p) { return std::isfinite(p.x) && std::isfinite(p.y) && std::isfinite(p.z); }

/// About how far p is beyond the plane through a, in units of |normal|, and a little more.
double beyond(const glm::dvec3& normal, const glm::dvec3& a, const glm::dvec3& p) {
  const glm::dvec3 d = p - a;
  return glm::dot(normal, d) + kWorthTrying * glm::dot(glm::abs(normal), glm::abs(d));
}

}  // namespace

std::optional<ConvexBody> ConvexBody::of_points(std::span<const glm::vec3> points) {
  if (!std::ranges::all_of(points, is_finite)) return std::nullopt;
  const std::vector<glm::dvec3> exact(points.begin(), points.end());
  const Hull hull = convex_hull(exact);
  if (hull.kind != HullKind::polyhedron) return std::nullopt;
  std::vector<glm::dvec3> vertices;
  std::vector<std::uint32_t> number(points.size());
  for (const std::uint32_t v : hull.vertices) {
    number[v] = std::uint32_t(vertices.size());
    vertices.push_back(exact[v]);
  }
  std::vector<std::array<std::uint32_t, 3>> triangles;
  for (const auto& t : hull.triangles) triangles.push_back({number[t[0]], number[t[1]], number[t[2]]});
  return ConvexBody(std::move(vertices), triangles);
}

std::optional<ConvexBody> ConvexBody::of_box(const glm::vec3& low, const glm::vec3& high) {
  if (!is_finite(low) || !is_finite(high)) return std::nullopt;
  if (!(low.x < high.x && low.y < high.y && low.z < high.z)) return std::nullopt;
  std::vector<glm::dvec3> vertices;
  for (int i = 0; i < 8; ++i) {
    vertices.emplace_back((i & 1 ? high : low).x, (i & 2 ? high : low).y, (i & 4 ? high : low).z);
  }
  static constexpr std::array<std::array<std::uint32_t, 3>, 12> kTriangles = {{{0, 4, 6},
                                                                               {0, 6, 2},
                                                                               {1, 3, 7},
                                                                               {1, 7, 5},
                                                                               {0, 1, 5},
                                                                               {0, 5, 4},
                                                                               {2, 6, 7},
                                                                               {2, 7, 3},
                                                                               {0, 2, 3},
                                                                               {0, 3, 1},
                                                                               {4, 5, 7},
                                                                               {4, 7, 6}}};
  return ConvexBody(std::move(vertices), kTriangles);
}

ConvexBody::ConvexBody(std::vector<glm::dvec3> vertices, std::span<const std::array<std::uint32_t, 3>> triangles)
    : vertices_(std::move(vertices)) {
  for (const glm::dvec3& v : vertices_) {
    bounds_.add(v);
    centre_ += v / double(vertices_.size());
  }
  for (const auto& t : triangles) {
    faces_.push_back({t, glm::cross(vertices_[t[1]] - vertices_[t[0]], vertices_[t[2]] - vertices_[t[0]])});
  }
  add_edges(std::vector<Face>(faces_));
}

/// Of triangles in one plane the first stays: the others of a fan each share a flat edge with one before them.
void ConvexBody::add_edges(std::span<const Face> triangles) {
  std::map<std::pair<std::uint32_t, std::uint32_t>, std::size_t> face_at;
  for (std::size_t f = 0; f < triangles.size(); ++f) {
    for (std::size_t k = 0; k < 3; ++k) face_at[{triangles[f].corners[k], triangles[f].corners[(k + 1) % 3]}] = f;
  }
  std::vector<bool> again(triangles.size());
  for (std::size_t f = 0; f < triangles.size(); ++f) {
    for (std::size_t e = 0; e < 3; ++e) {
      const std::uint32_t a = triangles[f].corners[e], b = triangles[f].corners[(e + 1) % 3];
      const std::uint32_t c = triangles[f].corners[(e + 2) % 3];
      const std::size_t g = face_at.at({b, a});
      if (g > f) continue;
      const auto& other = triangles[g].corners;
      const std::uint32_t opposite = *std::ranges::find_if(other, [&](std::uint32_t v) { return v != a && v != b; });
      if (orientation(vertices_[a], vertices_[b], vertices_[c], vertices_[opposite]) == 0) {
        again[f] = true;
      } else {
        edges_.push_back({a, b, {triangles[f].normal, triangles[g].normal}});
      }
    }
  }
  faces_.clear();
  for (std::size_t f = 0; f < triangles.size(); ++f) {
    if (!again[f]) faces_.push_back(triangles[f]);
  }
}

std::optional<glm::dvec3> ConvexBody::inner_point() const {
  const bool inside = std::ranges::all_of(faces_, [&](const Face& f) {
    return orientation(vertices_[f.corners[0]], vertices_[f.corners[1]], vertices_[f.corners[2]], centre_) < 0;
  });
  return inside ? std::optional(centre_) : std::nullopt;
}

bool ConvexBody::face_separates(const Face& face, std::span<const glm::dvec3> points) const {
  const glm::dvec3 &a = vertices_[face.corners[0]], &b = vertices_[face.corners[1]], &c = vertices_[face.corners[2]];
  return std::ranges::all_of(
      points, [&](const glm::dvec3& p) { return beyond(face.normal, a, p) >= 0.0 && orientation(a, b, c, p) >= 0; });
}

/// Exactly: no vertex of the body on one side, no corner of the triangle on the other. The plane is none, and proves
/// nothing, if all of the body lies in it.
template <class Side>
bool ConvexBody::plane_separates(const Side& side, const SpaceTriangle& triangle) const {
  int body = 0;
  for (const glm::dvec3& v : vertices_) {
    const int s = side(v);
    if (s * body < 0) return false;
    if (s != 0) body = s;
  }
  return body != 0 && std::ranges::all_of(triangle, [&](const glm::dvec3& p) { return side(p) * body <= 0; });
}

/// A plane along the edge touches the body only if its normal lies between those of the faces there, so that the other
/// direction in it points out of one of them and into the other.
bool ConvexBody::edge_separates(const Edge& edge, const SpaceTriangle& triangle) const {
  const glm::dvec3 &a = vertices_[edge.a], &b = vertices_[edge.b];
  for (std::size_t k = 0; k < 3; ++k) {
    const glm::dvec3 &c = triangle[k], &d = triangle[(k + 1) % 3];
    const double out0 = glm::dot(edge.normals[0], d - c), out1 = glm::dot(edge.normals[1], d - c);
    const double slack0 = kWorthTrying * glm::dot(glm::abs(edge.normals[0]), glm::abs(d - c));
    const double slack1 = kWorthTrying * glm::dot(glm::abs(edge.normals[1]), glm::abs(d - c));
    if ((out0 > slack0 && out1 > slack1) || (out0 < -slack0 && out1 < -slack1)) continue;
    glm::dvec3 normal = glm::cross(b - a, d - c);
    if (glm::dot(normal, centre_ - a) > 0.0) normal = -normal;
    if (!std::ranges::all_of(triangle, [&](const glm::dvec3& p) { return beyond(normal, a, p) >= 0.0; })) continue;
    if (plane_separates([&](const glm::dvec3& p) { return side_of_directions(a, b, c, d, p); }, triangle)) return true;
  }
  return false;
}

bool ConvexBody::misses(const SpaceTriangle& triangle) const {
  for (int k = 0; k < 3; ++k) {
    if (std::ranges::all_of(triangle, [&](const glm::dvec3& p) { return p[k] <= bounds_.low[k]; })) return true;
    if (std::ranges::all_of(triangle, [&](const glm::dvec3& p) { return p[k] >= bounds_.high[k]; })) return true;
  }
  std::array<bool, 3> inside = {true, true, true};  // each corner, as far as rounded numbers tell
  for (const Face& face : faces_) {
    const glm::dvec3& a = vertices_[face.corners[0]];
    bool beyond_face = true;
    for (std::size_t k = 0; k < 3; ++k) {
      const bool out = beyond(face.normal, a, triangle[k]) >= 0.0;
      beyond_face = beyond_face && out;
      inside[k] = inside[k] && !out;
    }
    if (beyond_face && face_separates(face, triangle)) return true;
  }
  if (inside[0] || inside[1] || inside[2]) return false;
  const glm::dvec3 &a = triangle[0], &b = triangle[1], &c = triangle[2];
  if (plane_separates([&](const glm::dvec3& p) { return orientation(a, b, c, p); }, triangle)) return true;
  return std::ranges::any_of(edges_, [&](const Edge& edge) { return edge_separates(edge, triangle); });
}

bool ConvexBody::misses(const Bounds& box) const {
  for (int k = 0; k < 3; ++k) {
    if (box.high[k] <= bounds_.low[k] || box.low[k] >= bounds_.high[k]) return true;
  }
  std::array<glm::dvec3, 8> corners;
  for (std::size_t i = 0; i < 8; ++i) {
    corners[i] = {(i & 1 ? box.high : box.low).x, (i & 2 ? box.high : box.low).y, (i & 4 ? box.high : box.low).z};
  }
  return std::ranges::any_of(faces_, [&](const Face& face) { return face_separates(face, corners); });
}

}  // namespace lode::geometry
