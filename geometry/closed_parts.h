#pragma once
/// The parts of a triangle soup: what hangs together by shared edges, and which of them close, so that every point off
/// a part's surface has a winding number in it.

#include <cstddef>
#include <cstdint>
#include <glm/vec3.hpp>
#include <span>
#include <vector>

#include "geometry/triangle_tree.h"

namespace lode::geometry {

struct ClosedPart {
  std::vector<SpaceTriangle> triangles;
  double volume = 0.0;  ///< rounded; > 0 for sure in exact numbers, too
};

struct ClosedParts {
  std::vector<ClosedPart> outward;  ///< by their first triangles
  std::size_t n_inward = 0;         ///< closed, but with no volume that is surely positive
  std::size_t n_open = 0;           ///< with an edge that is not met as often in one direction as in the other
  std::size_t n_dropped = 0;        ///< triangles with two equal corners: in no part
};

/// Vertices at equal positions are one (−0 is 0). Two triangles that share two vertices, in either order, are in one
/// part. A part has a boundary unless each of its edges is met by as many triangles in one direction as in the other.
///
///   positions   [n]
///   indices     [3·m] each < n, of finite positions
///   throws      Error (bad_input), one line, naming the first index or position that is wrong
///   cost        O((n + m) log(n + m)); deterministic
[[nodiscard]] ClosedParts closed_parts(std::span<const glm::vec3> positions, std::span<const std::uint32_t> indices);

}  // namespace lode::geometry
