#pragma once
/// Convex hulls that lie in a model, from some that only about do: each shrinks about its centroid until it is proven
/// to be inside.

#include <glm/vec3.hpp>
#include <span>
#include <vector>

#include "geometry/solid.h"

namespace lode::geometry {

/// Sizes that are tried, largest first.
inline constexpr float kInnerHullFactors[] = {1.0f, 0.98f, 0.95f, 0.9f, 0.8f, 0.65f, 0.5f};

struct InnerHull {
  std::vector<glm::vec3> points;  ///< Solid::contains_hull
  std::size_t source = 0;         ///< which of the given hulls
  float factor = 1.0f;            ///< what is left of its size
};

/// One for each hull for which a factor is found, in their order; the others are dropped, as are hulls without volume.
/// The centroid is the mean of the extreme points.
///
///   hulls   [h] points each, finite or not, in the solid's space
///   cost    O(h · factors) questions to the solid; deterministic
[[nodiscard]] std::vector<InnerHull> inner_hulls(const Solid& solid, std::span<const std::vector<glm::vec3>> hulls);

}  // namespace lode::geometry
