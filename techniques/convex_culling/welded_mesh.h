#pragma once
/// A model as the convex approximation sees it: triangles over vertices that are welded where they (nearly) coincide,
/// so that parts which touch share vertices. Any triangles will do: not closed, not manifold, doubled.

#include <array>
#include <cstdint>
#include <glm/vec3.hpp>
#include <span>
#include <vector>

#include "geometry/bounds.h"

namespace lode::techniques::convex_culling {

struct WeldedMesh {
  std::vector<glm::vec3> vertices;  ///< those that triangles use, each as one vertex of the input has it
  std::vector<std::array<std::uint32_t, 3>> triangles;  ///< three different vertices each
  geometry::Bounds bounds;                              ///< of the vertices
  std::uint64_t n_dropped = 0;                          ///< triangles of the input with two corners welded
};

/// Welds vertices that are at most half of `tolerance` · diagonal apart along each axis, and some of those up to the
/// whole of it, in chains, too: groups are the connected ones, and the lowest index stands for its group.
///
///   positions  [n] finite
///   indices    [3·m] each < n
///   tolerance  0…0.1; 0 welds equal positions only. In contrast to the paper, which does not weld: 1e-6
///   throws     geometry::Error (bad_input), naming the first index or position that is wrong
///   cost       O((n + m) log n)
[[nodiscard]] WeldedMesh weld(std::span<const glm::vec3> positions, std::span<const std::uint32_t> indices,
                              double tolerance);

}  // namespace lode::techniques::convex_culling
