#pragma once
/// A model as a few convex hulls that have about its silhouettes: approximations at several levels of accuracy, made
/// once before anything is drawn. They are not conservative: hulls stick out of the model where it is hollow, and fall
/// short of it where U(v) leaves vertices out. Onozawa & Kitazawa, sec. 2.

#include <cstdint>
#include <glm/vec3.hpp>
#include <span>
#include <vector>

#include "techniques/convex_culling/approximation_params.h"

namespace lode::techniques::convex_culling {

/// Γ(S, Π) for one limit M.
struct ApproximationLevel {
  std::size_t limit = 0;
  std::vector<std::vector<glm::vec3>> hulls;  ///< extreme vertices of each, in object space; flat ones have no volume
  std::size_t n_distinct = 0;                 ///< vertices of all hulls, each once
  std::size_t n_sum = 0;                      ///< vertices of each hull, added up
  double hull_area = 0.0;                     ///< A(Γ), object units squared
  double error = 0.0;                         ///< E(S, Γ) = |A(S) − A(Γ)|, eq. 2
};

struct ConvexApproximation {
  double area = 0.0;                       ///< A(S): the silhouettes on the planes of the axes, added up
  std::size_t n_vertices = 0;              ///< |V(S)| after welding
  std::size_t n_triangles = 0;             ///< after welding
  std::vector<ApproximationLevel> levels;  ///< one for each limit, as params have them

  /// E/A(S), 0 if the model has no area: the paper's Table 1 gives it in per cent.
  [[nodiscard]] double relative_error(std::size_t level) const { return area > 0.0 ? levels[level].error / area : 0.0; }
};

/// Alg. 1. Any triangles: none, one, flat, doubled, not closed. With a limit below what one hull needs (0, say) a level
/// has no hulls, and its error is A(S). With count = distinct and a limit of |V(S)| or more, a level is the single
/// polygons, and its error is 0.
///
///   positions   [n] finite, object space
///   indices     [3·m] each < n
///   throws      geometry::Error (bad_input), one line, naming what is wrong
///   cost        O(m log² m); deterministic
[[nodiscard]] ConvexApproximation approximate(std::span<const glm::vec3> positions,
                                              std::span<const std::uint32_t> indices,
                                              const ApproximationParams& params);

}  // namespace lode::techniques::convex_culling
