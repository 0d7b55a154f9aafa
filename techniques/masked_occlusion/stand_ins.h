#pragma once
/// What is drawn into the masked depth buffer in an occluder's place: fewer triangles than the model has.
///
/// A hull holds the model, and covers what the model does not: with hulls, culling is approximate. An inner box lies
/// inside a closed model and can only hide what the model hides, if it is kept clear of the model's outline by what the
/// snap to 1/256 px can move. A model's vertices and a box's corners move by √2/512 px each; so the boxes are shrunk by
/// the length that is 2.5/256 px where the object is farthest from the eye. Then every point of the picture within
/// √2/256 px of a sample that the shrunk box covers lies on the model's, which is nearer there: the ball of that length
/// around a point of the shrunk box lies in the box.

#include <glm/vec3.hpp>
#include <vector>

#include "geometry/bounds.h"
#include "raster/frame.h"
#include "techniques/technique.h"
#include "techniques/world.h"

namespace lode::techniques {

/// Triangles, closed and outward.
struct StandIn {
  std::vector<glm::vec3> positions;
  std::vector<std::uint32_t> indices;
};

/// The convex hull of all of a shape's vertices; no triangles for a shape that is flat or not finite.
[[nodiscard]] StandIn hull_of(const Shape& shape);

/// A box as twelve triangles, smaller by `inset` on either side of each axis, rounded inwards; no triangles if nothing
/// is left.
void add_box(const geometry::Bounds& box, const glm::dvec3& inset, StandIn& stand_in);

/// How far a shape's boxes have to be shrunk along its axes for an object that has this box in the world.
[[nodiscard]] glm::dvec3 inset_of(const View& view, const geometry::Bounds& world_box,
                                  const glm::dmat4& world_from_shape);

/// A draw of a stand-in, which it borrows: what faces away is not drawn.
[[nodiscard]] raster::Draw stand_in_draw(const StandIn& stand_in, const glm::dmat4& clip_from_world,
                                         const glm::dmat4& world_from_shape);

}  // namespace lode::techniques
