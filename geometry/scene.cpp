#include "geometry/scene.h"

#include <glm/mat3x3.hpp>
#include <glm/matrix.hpp>

namespace lode::geometry {

Bounds Scene::bounds() const {
  Bounds bounds;
  std::vector<char> used;
  for (const Instance& instance : instances) {
    const Mesh& mesh = meshes[instance.mesh];
    used.assign(mesh.positions.size(), 0);
    for (const std::uint32_t index : mesh.indices) used[index] = 1;
    for (std::size_t i = 0; i < used.size(); ++i) {
      if (used[i]) bounds.add(glm::dvec3(instance.world_from_object * glm::dvec4(mesh.positions[i], 1.0)));
    }
  }
  return bounds;
}

bool mirrors(const glm::dmat4& transform) { return glm::determinant(glm::dmat3(transform)) < 0.0; }

}  // namespace lode::geometry
