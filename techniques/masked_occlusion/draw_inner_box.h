#pragma once
/// A box that lies inside an occluder into the masked depth buffer, in the occluder's place: it covers only samples
/// that the occluder's snapped triangles cover, and is nowhere nearer than these.
///
/// The renderer moves each vertex by 1/512 px at most in x and in y, so by less than a circle of 0.71/256 px. Where
/// that circle around a sample lies in the picture of a convex shape, the surface around the shape still covers the
/// sample after it has been moved, at a depth that it had somewhere in the circle: nearer than the shape there. So each
/// face is drawn smaller by 2/256 px (the circle, and as much for its own snap) and farther by as much as its plane
/// falls over twice that. What this leaves open along edges between faces is filled by the box's outline, smaller by
/// the same, at the depth of the farthest corner.

#include <glm/mat4x4.hpp>

#include "geometry/bounds.h"
#include "techniques/masked_occlusion/draw_occluder.h"

namespace lode::techniques {

/// Draws nothing for a box that reaches the near plane or lies beyond ±2^20 px.
///   box        inside the occluder for sure (geometry/solid.h), object space
///   mirrored   whether the matrix turns counter-clockwise into clockwise
///   work       counts the triangles into which faces and outline fall
void draw_inner_box(const geometry::Bounds& box, const glm::dmat4& clip_from_object, bool mirrored, glm::ivec2 size_px,
                    MaskedDepth& buffer, OccluderWork& work);

}  // namespace lode::techniques
