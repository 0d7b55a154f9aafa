#pragma once
/// Whom to trust as an occluder. E (eq. 2) lets what is covered too much and too little cancel, so that a hull over a
/// doorway passes where another one falls short by as much. What hulls cover beside the model is known before anything
/// is drawn, and only that can hide what is seen.

#include <cstdint>
#include <glm/vec3.hpp>
#include <span>
#include <vector>

namespace lode::techniques::convex_culling {

/// How much too much a model's hulls hide, over x, y, z and a few fixed directions: each the worst of them.
struct Excess {
  double model = 0.0;         ///< of all hulls together, over the model's silhouette
  std::vector<double> hulls;  ///< [hulls] of each alone, over its own largest silhouette
  std::vector<double> sizes;  ///< [hulls] the largest silhouette of each, over the model's
};

/// On 96 lines for each direction.
///   positions, indices, hulls   as coverage_error() takes them
///   cost                        13 times each_coverage()
[[nodiscard]] Excess excess(std::span<const glm::vec3> positions, std::span<const std::uint32_t> indices,
                            std::span<const std::vector<glm::vec3>> hulls);

}  // namespace lode::techniques::convex_culling
