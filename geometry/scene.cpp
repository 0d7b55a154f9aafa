#include "geometry/scene.h"

#include <glm/mat3x3.hpp>
#include <glm/matrix.hpp>
#include <span>

namespace lode::geometry {

namespace {

/// Adds an instance's indexed vertices, in the world; `used` is only memory to work in.
void add_instance_bounds(const Scene& scene, const Instance& instance, std::vector<char>& used, Bounds& bounds) {
  const Mesh& mesh = scene.meshes[instance.mesh];
  used.assign(mesh.positions.size(), 0);
  for (const std::uint32_t index : mesh.indices) used[index] = 1;
  for (std::size_t i = 0; i < used.size(); ++i) {
    if (used[i]) bounds.add(glm::dvec3(instance.world_from_object * glm::dvec4(mesh.positions[i], 1.0)));
  }
}

std::span<const Instance> instances_of(const Scene& scene, const SceneObject& object) {
  return std::span(scene.instances).subspan(object.first_instance, object.n_instances);
}

}  // namespace

Bounds Scene::bounds() const {
  Bounds bounds;
  std::vector<char> used;
  for (const Instance& instance : instances) add_instance_bounds(*this, instance, used, bounds);
  return bounds;
}

std::vector<SceneObject> objects_of(const Scene& scene) {
  if (!scene.objects.empty()) return scene.objects;
  std::vector<SceneObject> objects;
  for (std::uint32_t i = 0; i < scene.instances.size(); ++i) {
    const std::uint32_t node = scene.instances[i].node;
    if (i == 0 || scene.instances[i - 1].node != node) objects.push_back({scene.nodes[node].name, i, 0});
    ++objects.back().n_instances;
  }
  return objects;
}

Bounds object_bounds(const Scene& scene, const SceneObject& object) {
  Bounds bounds;
  std::vector<char> used;
  for (const Instance& instance : instances_of(scene, object)) add_instance_bounds(scene, instance, used, bounds);
  return bounds;
}

std::size_t n_triangles(const Scene& scene, const SceneObject& object) {
  std::size_t n = 0;
  for (const Instance& instance : instances_of(scene, object)) {
    const Mesh& mesh = scene.meshes[instance.mesh];
    if (mesh.kind == MeshKind::triangles) n += mesh.n_primitives();
  }
  return n;
}

bool may_occlude(const Scene& scene, const SceneObject& object) {
  for (const Instance& instance : instances_of(scene, object)) {
    const std::optional<std::uint32_t>& material = scene.meshes[instance.mesh].material;
    if (material && scene.materials[*material].alpha_mode != AlphaMode::opaque) return false;
  }
  return n_triangles(scene, object) > 0;
}

bool mirrors(const glm::dmat4& transform) { return glm::determinant(glm::dmat3(transform)) < 0.0; }

}  // namespace lode::geometry
