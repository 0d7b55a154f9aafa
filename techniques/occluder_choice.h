#pragma once
/// Which objects are drawn first, to hide others: the occluder degree of Onozawa and Kitazawa, "Occlusion culling with
/// a hierarchical convex approximation of models" (eq. 4). One rule for every culler here, so that cullers are compared
/// on the same occluders, whatever shape stands for them.

#include <span>
#include <vector>

#include "techniques/technique.h"
#include "techniques/world.h"

namespace lode::techniques {

/// How many occluders there are. The paper leaves the three open.
struct OccluderRule {
  double least_degree = 0.0;  ///< [0, 1]; those below are none
  int most = 32;              ///< ≥ 0; no more than these, the best
  /// World units: the degree is 0 from here on. 0: the diagonal of the box of the world and the eye, so that a scene
  /// seen from outside has occluders too.
  double far = 0.0;
};

/// A(S) of each object: the area of its box seen along x, y and z, added up (the paper allows the box in the model's
/// place). World units squared; 0 for what cannot hide others (Shape::hides) or has no finite box.
///   returns   [objects]
[[nodiscard]] std::vector<double> occluder_areas(const World& world);

/// alpha(S) = (1 − d / Far) · A(S) / max A, eq. 4. In contrast to the paper never below 0.
///   distance       ≥ 0, from the eye to the nearest point of the object's box: a long wall beside the eye is near
///   far            > 0
///   largest_area   > 0, ≥ area
[[nodiscard]] double occluder_degree(double distance, double far, double area, double largest_area);

/// The occluders of a view, in descending degree, ties in ascending id. Max A is taken over the candidates.
///   candidates   objects in view, in ascending order (objects_in_view)
///   areas        [objects] A(S) of each; those of area 0 are left out
///   cost         O(n log n), n candidates; deterministic
[[nodiscard]] std::vector<ObjectId> choose_occluders(const World& world, const View& view,
                                                     std::span<const ObjectId> candidates,
                                                     std::span<const double> areas, const OccluderRule& rule);

}  // namespace lode::techniques
