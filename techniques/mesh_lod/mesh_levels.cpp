#include "techniques/mesh_lod/mesh_levels.h"

#include <algorithm>
#include <cmath>
#include <glm/mat3x3.hpp>
#include <glm/matrix.hpp>
#include <string>
#include <utility>

#include "geometry/simplify.h"
#include "raster/parallel.h"

namespace lode::techniques {
namespace {

/// Of a mesh with simpler ones: half of a rectangle would be no coarser rectangle.
constexpr std::size_t kFewestTriangles = 64;

MeshLevel level_of(const World& world, std::uint32_t mesh, double share) {
  const geometry::Mesh& whole = world.scene().meshes[mesh];
  if (whole.n_primitives() < kFewestTriangles) return {};
  geometry::SimplifiedMesh simple = geometry::simplify(whole, share);
  if (simple.mesh.n_primitives() >= whole.n_primitives()) return {};
  return {.alternate = world.draws().alternate(mesh, std::move(simple.mesh)), .error = simple.error};
}

std::uint64_t bytes_of(const geometry::Mesh& mesh) {
  return mesh.positions.size() * sizeof(glm::vec3) + mesh.normals.size() * sizeof(glm::vec3) +
         mesh.uvs.size() * sizeof(glm::vec2) + mesh.colors.size() * sizeof(glm::vec4) +
         mesh.indices.size() * sizeof(std::uint32_t);
}

MeshLevels make_levels(const World& world, const MeshShares& shares, int threads) {
  const geometry::Scene& scene = world.scene();
  std::vector<std::uint32_t> meshes;  // that have an instance
  for (const geometry::Instance& instance : scene.instances) meshes.push_back(instance.mesh);
  std::sort(meshes.begin(), meshes.end());
  meshes.erase(std::unique(meshes.begin(), meshes.end()), meshes.end());

  MeshLevels levels;
  levels.of_mesh.resize(scene.meshes.size());
  raster::parallel_for(kMeshLevels * meshes.size(), raster::worker_count(threads), [&](std::size_t i, int) {
    const std::uint32_t mesh = meshes[i / kMeshLevels];
    const std::size_t k = i % kMeshLevels;
    levels.of_mesh[mesh][k] = level_of(world, mesh, shares[k]);
  });
  for (const LevelsOfMesh& of_mesh : levels.of_mesh) {
    for (const MeshLevel& level : of_mesh) {
      if (level.alternate) levels.bytes += bytes_of(level.alternate->mesh);
    }
  }
  return levels;
}

}  // namespace

std::shared_ptr<const MeshLevels> mesh_levels(const World& world, const MeshShares& shares, int threads) {
  std::string key = "mesh levels";
  for (const double share : shares) key += "; " + std::to_string(share);
  return world.once<MeshLevels>(key, [&] { return make_levels(world, shares, threads); });
}

double largest_scale(const glm::dmat4& transform) {
  const glm::dmat3 linear(transform);
  const glm::dmat3 squared = glm::transpose(linear) * linear;
  double largest = 0.0;
  for (int row = 0; row < 3; ++row) {
    double sum = 0.0;
    for (int column = 0; column < 3; ++column) sum += std::abs(squared[column][row]);
    largest = std::max(largest, sum);
  }
  return std::sqrt(largest);
}

}  // namespace lode::techniques
