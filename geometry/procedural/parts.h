#pragma once
/// Solids by rule, of which models are built: closed, facing outwards, of no hole (2 vertices − triangles = 4), each
/// appended to a mesh without normals. Vertices are shared, seams and poles included, so that welding changes nothing.
/// Angles come from geometry/trigonometry.h and powers from square roots: the same bits everywhere.

#include <cstddef>
#include <glm/mat4x4.hpp>
#include <glm/vec2.hpp>
#include <glm/vec3.hpp>
#include <span>
#include <vector>

#include "geometry/mesh.h"

namespace lode::geometry {

/// Rings of equally many points, each counter-clockwise as seen from the side to which the rings go on, closed by a fan
/// to a pole at either end: 2·points·rings triangles, points·rings + 2 vertices. points ≥ 3, rings ≥ 1.
void add_loft(Mesh& mesh, std::span<const std::vector<glm::dvec3>> rings, const glm::dvec3& low_pole,
              const glm::dvec3& high_pole);

/// Turned on a lathe around the y axis of `place`: profile (radius > 0, height) from the bottom up, flat at both ends.
/// 2·segments·profile triangles.
void add_turned(Mesh& mesh, std::span<const glm::dvec2> profile, int segments, const glm::dmat4& place);

/// Twelve triangles.
void add_block(Mesh& mesh, const glm::dvec3& low, const glm::dvec3& high, const glm::dmat4& place = glm::dmat4(1.0));

/// A box with rounded edges: 2·segments·rings triangles. segments a multiple of 4, rings even, 0 < radius ≤ half of the
/// smallest side.
void add_rounded_box(Mesh& mesh, const glm::dvec3& low, const glm::dvec3& high, double radius, int segments, int rings,
                     const glm::dmat4& place = glm::dmat4(1.0));

/// A superellipsoid with exponents in quarters, 1 (nearly a box) to 4 (an ellipsoid): of its section through the y axis
/// and of its plan. Barr, "Superquadrics and angle-preserving transformations" (1981). As many triangles as above.
struct Squareness {
  int section_quarters = 2;
  int plan_quarters = 1;
};
void add_superellipsoid(Mesh& mesh, const glm::dvec3& centre, const glm::dvec3& half, const Squareness& squareness,
                        int segments, int rings);

/// Two triangles, counter-clockwise a, b, c, d as seen from the front.
void add_quad(Mesh& mesh, const glm::dvec3& a, const glm::dvec3& b, const glm::dvec3& c, const glm::dvec3& d);

/// Splits the largest triangle at its centroid, over and over, until there are `extra` more. extra even; the mesh has a
/// triangle. Ties go to the lower index.
void add_triangles_by_splitting(Mesh& mesh, std::size_t extra);

/// The frame at `from` whose y axis points at `to`, of unit scale; its x axis is level. from ≠ to.
[[nodiscard]] glm::dmat4 frame_along(const glm::dvec3& from, const glm::dvec3& to);

/// Turned about the y axis (counter-clockwise from above), then moved.
[[nodiscard]] glm::dmat4 turned_frame(const glm::dvec3& origin, double yaw_rad);

}  // namespace lode::geometry
