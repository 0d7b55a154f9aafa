#pragma once
/// Polygons to triangles.

#include <cstddef>
#include <cstdint>
#include <glm/vec3.hpp>
#include <span>
#include <vector>

namespace lode::geometry {

/// More corners than this take a concave polygon too long: its ears are looked for among all corners, each time.
inline constexpr std::size_t kMaxConcaveCorners = 2048;

/// Appends the corners, 0…n−1, of n − 2 triangles with the polygon's own orientation. A convex polygon (seen along the
/// axis that its normal, by Newell's method, is nearest to) becomes a fan from its first corner; a concave one loses
/// ears (Meisters, "Polygons have ears", 1975), the next one from the corner before the last; exact predicates decide.
/// A polygon that crosses itself, or has no area, gives n − 2 triangles too, of whatever shape.
///
///   corners   [n] finite, n ≥ 3; they need not lie in a plane
///   returns   false, and nothing is appended, if it is concave and n > kMaxConcaveCorners
///   cost      O(n) if convex, else O(n²)
///   n_tests   if given, grows by the corners that were looked at for ears: the work, some 20 to 100 ns each
[[nodiscard]] bool triangulate(std::span<const glm::vec3> corners, std::vector<std::uint32_t>& triangles,
                               std::uint64_t* n_tests = nullptr);

/// What a file's concave polygons may cost together: some seconds. No model made in earnest comes near.
inline constexpr std::uint64_t kMaxEarTests = std::uint64_t{1} << 27;

}  // namespace lode::geometry
