#pragma once
/// How an approximation's silhouettes differ from a model's, in both senses: what hulls cover beside the model (an
/// occluder then hides too much) and what they leave out of it (it hides too little). In contrast to eq. 2 of Onozawa &
/// Kitazawa, where the two cancel: E = 0 does not mean equal silhouettes.

#include <cstdint>
#include <glm/vec3.hpp>
#include <span>
#include <vector>

namespace lode::techniques::convex_culling {

/// In orthographic projection along one direction; areas in units squared.
struct CoverageError {
  glm::dvec3 direction{0.0};
  double model_area = 0.0;  ///< of the union of the model's triangles
  double hull_area = 0.0;   ///< of the union of the hulls
  double over = 0.0;        ///< of what the hulls cover and the model does not
  double under = 0.0;       ///< of what the model covers and the hulls do not
};

/// On n_lines equally spaced lines of the plane across the direction. Exactly, over − under = hull_area − model_area;
/// the error of each is about an outline's length times the spacing of the lines.
///
///   positions   [n] finite
///   indices     [3·m] each < n
///   hulls       each the convex hull of its points
///   direction   of any length but 0, finite (checked: std::logic_error)
///   n_lines     1…4096 (checked: std::logic_error)
///   cost        O((m + points) · lines that each crosses)
[[nodiscard]] CoverageError coverage_error(std::span<const glm::vec3> positions, std::span<const std::uint32_t> indices,
                                           std::span<const std::vector<glm::vec3>> hulls, const glm::dvec3& direction,
                                           int n_lines = 256);

/// What one hull covers along a direction, alone, and how much of that the model does not. Units squared.
struct HullCoverage {
  double area = 0.0;
  double over = 0.0;
};

/// The same of all hulls together and of each alone; same arguments, same checks.
struct EachCoverage {
  CoverageError all;
  std::vector<HullCoverage> hulls;  ///< [hulls]
};
[[nodiscard]] EachCoverage each_coverage(std::span<const glm::vec3> positions, std::span<const std::uint32_t> indices,
                                         std::span<const std::vector<glm::vec3>> hulls, const glm::dvec3& direction,
                                         int n_lines = 256);

/// x, y and z, then n_random directions that are uniform over the sphere: what the two-sided error is reported over.
[[nodiscard]] std::vector<glm::dvec3> measured_directions(int n_random = 100, std::uint64_t seed = 1);

}  // namespace lode::techniques::convex_culling
