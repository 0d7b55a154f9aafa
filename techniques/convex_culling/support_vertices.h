#pragma once
/// The few vertices U(v) whose hull stands for a cluster. Onozawa & Kitazawa, sec. 2.2.

#include <cstdint>
#include <glm/vec3.hpp>
#include <span>
#include <vector>

namespace lode::techniques::convex_culling {

/// nearest_to_sphere: the vertex nearest to each point where a direction meets the bounding sphere (the paper's).
/// farthest: the vertex that is the farthest in each direction, which is always extreme.
enum class SupportRule : std::uint8_t { nearest_to_sphere, farthest };

/// Unit vectors at steps of latitude and longitude, the poles (±y) once each: 26 at 45°. The paper does not give the
/// step; 180° / step_deg must be a whole number, 5…90 (checked: std::logic_error).
[[nodiscard]] std::vector<glm::dvec3> sphere_directions(double step_deg);

/// For each direction one of the vertices; the list ascends and holds each once. The sphere is about the middle of the
/// vertices' box. Of equally near ones the lowest index is taken.
///
///   positions  of the model, indexed by `vertices`
///   vertices   [n] n ≥ 1, some may be listed twice
///   cost       O(n · directions)
[[nodiscard]] std::vector<std::uint32_t> support_vertices(std::span<const glm::vec3> positions,
                                                          std::span<const std::uint32_t> vertices,
                                                          std::span<const glm::dvec3> directions, SupportRule rule);

}  // namespace lode::techniques::convex_culling
