#pragma once
/// A convex polyhedron that can prove that things do not reach into it. By the theorem of separating planes a triangle
/// has no point strictly inside if and only if a plane has all of the triangle on one side (or in it) and the
/// polyhedron on the other: one of the polyhedron's faces, the triangle's plane, or a plane along an edge of either
/// (Gottschalk, Lin & Manocha, "OBBTree", 1996, sec. 5, for boxes). Rounded numbers choose which planes are tried,
/// exact signs (predicates.h) decide.

#include <array>
#include <cstdint>
#include <glm/vec3.hpp>
#include <optional>
#include <span>
#include <vector>

#include "geometry/bounds.h"
#include "geometry/triangle_tree.h"

namespace lode::geometry {

class ConvexBody {
 public:
  /// The hull of the points; nothing if one is not finite or they lie in a plane.
  [[nodiscard]] static std::optional<ConvexBody> of_points(std::span<const glm::vec3> points);
  /// Nothing unless low < high along each axis, all finite.
  [[nodiscard]] static std::optional<ConvexBody> of_box(const glm::vec3& low, const glm::vec3& high);

  [[nodiscard]] const Bounds& bounds() const { return bounds_; }

  /// A point that is strictly inside for sure; nothing if rounding finds none (in very flat bodies).
  [[nodiscard]] std::optional<glm::dvec3> inner_point() const;

  /// Whether it is proven that no point of the triangle is strictly inside. Triangles without area are segments or
  /// points. False where rounding hides the plane that would prove it.
  [[nodiscard]] bool misses(const SpaceTriangle& triangle) const;
  /// The same of a box; false for some that do miss.
  [[nodiscard]] bool misses(const Bounds& box) const;

 private:
  /// Normals are rounded, of any length, outward.
  struct Face {
    std::array<std::uint32_t, 3> corners;  ///< counter-clockwise from outside
    glm::dvec3 normal;
  };
  struct Edge {
    std::uint32_t a, b;
    std::array<glm::dvec3, 2> normals;  ///< of the faces beside it
  };
  ConvexBody(std::vector<glm::dvec3> vertices, std::span<const std::array<std::uint32_t, 3>> triangles);
  void add_edges(std::span<const Face> triangles);
  [[nodiscard]] bool face_separates(const Face& face, std::span<const glm::dvec3> points) const;
  template <class Side>
  [[nodiscard]] bool plane_separates(const Side& side, const SpaceTriangle& triangle) const;
  [[nodiscard]] bool edge_separates(const Edge& edge, const SpaceTriangle& triangle) const;

  std::vector<glm::dvec3> vertices_;
  std::vector<Face> faces_;  ///< one for each plane
  std::vector<Edge> edges_;  ///< where two planes meet
  Bounds bounds_;
  glm::dvec3 centre_{0.0};  ///< about the middle
};

}  // namespace lode::geometry
