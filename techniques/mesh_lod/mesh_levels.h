#pragma once
/// Levels of detail of a scene's meshes: each simplified to a few shares of its triangles, once per scene.

#include <array>
#include <cstdint>
#include <memory>
#include <optional>
#include <vector>

#include "techniques/world.h"

namespace lode::techniques {

inline constexpr int kMeshLevels = 3;  ///< beside level 0, which is the mesh itself

struct MeshLevel {
  std::optional<AlternateMesh> alternate;  ///< none where the library leaves the mesh as it is
  double error = 0.0;                      ///< of geometry::simplify, object units; 0 without an alternate
};

/// Level k is element k − 1.
using LevelsOfMesh = std::array<MeshLevel, kMeshLevels>;
using MeshShares = std::array<double, kMeshLevels>;

struct MeshLevels {
  std::vector<LevelsOfMesh> of_mesh;  ///< [the scene's meshes]
  std::uint64_t bytes = 0;            ///< of all levels' vertices and indices
};

/// Makes them, or finds those that were made of this world with the same shares.
///   shares   of a mesh's triangles that each level keeps, 0…1
///   cost     O(n log n) for n triangles of all meshes; on `threads` threads, the same for any number of them
[[nodiscard]] std::shared_ptr<const MeshLevels> mesh_levels(const World& world, const MeshShares& shares, int threads);

/// How much a transform lengthens a vector at most: at least the largest singular value of its linear part M, and that
/// itself where M's columns are at right angles (rotations and scales). √‖MᵀM‖ by the largest sum of a row.
[[nodiscard]] double largest_scale(const glm::dmat4& transform);

}  // namespace lode::techniques
