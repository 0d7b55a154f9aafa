#pragma once
/// Directions of the upper hemisphere on a square, and a grid of them: Cigolle et al., "A survey of efficient
/// representations for independent unit vectors", 2014, hemi-oct. The hemisphere's octahedron is unfolded into the
/// diamond |x| + |z| ≤ 1 and turned by 45°, which makes it the square [−1, 1]²: straight up is its middle, the horizon
/// its border, each direction of the horizon there once.

#include <array>
#include <glm/vec2.hpp>
#include <glm/vec3.hpp>

namespace lode::techniques {

/// Of a vector of any length. What points below the horizon counts as the direction of the horizon above it, straight
/// down and the zero vector as straight up. Continuous everywhere else.
[[nodiscard]] glm::dvec2 octahedral_from_direction(const glm::dvec3& direction);

/// The unit vector of a point of the square; what is outside counts as the border's nearest point.
[[nodiscard]] glm::dvec3 direction_from_octahedral(const glm::dvec2& point);

/// The direction of a node of the grid of n × n, whose border nodes are on the horizon.
///   node   each 0…n − 1;   n ≥ 2
[[nodiscard]] glm::dvec3 grid_direction(const glm::ivec2& node, int n);

/// Nodes of the triangle of the grid that a direction lies in, and its barycentric weights there.
struct GridTriangle {
  std::array<glm::ivec2, 3> nodes;
  std::array<double, 3> weights;  ///< each 0…1; their sum is 1, exactly
};
/// The grid's cells are cut along the diagonal from their first node to their last. Positions are rounded to 2⁻²⁰ of a
/// cell, so that the weights of a node's own direction are 1, 0 and 0.
[[nodiscard]] GridTriangle grid_triangle(const glm::dvec3& direction, int n);

}  // namespace lode::techniques
