#include "experiments/harness/scene_hash.h"

#include <span>

#include "experiments/sha256.h"

namespace lode::experiments {
namespace {

template <class T>
std::string hash_of_list(const std::vector<T>& list) {
  return std::to_string(list.size()) + ":" + sha256_hex(std::as_bytes(std::span(list)));
}

}  // namespace

std::string hash_of(const geometry::Scene& scene) {
  std::string all;
  for (const geometry::Mesh& mesh : scene.meshes) {
    all += std::to_string(int(mesh.kind)) + hash_of_list(mesh.positions) + hash_of_list(mesh.indices);
    if (!mesh.material) continue;
    const geometry::Material& material = scene.materials[*mesh.material];
    all += std::to_string(int(material.alpha_mode)) + (material.double_sided ? "d" : "s");
    if (material.alpha_mode != geometry::AlphaMode::mask) continue;
    all += std::to_string(material.alpha_cutoff) + hash_of_list(mesh.uvs);
    if (material.color_texture) all += hash_of_list(scene.pictures[material.color_texture->picture].texels);
  }
  for (const geometry::Instance& instance : scene.instances) {
    const std::vector<glm::dmat4> place = {instance.world_from_object};
    all += std::to_string(instance.mesh) + hash_of_list(place);
  }
  for (const geometry::SceneObject& o : geometry::objects_of(scene)) {
    all += std::to_string(o.first_instance) + "+" + std::to_string(o.n_instances) + ";";
  }
  return sha256_hex(std::as_bytes(std::span(all)));
}

}  // namespace lode::experiments
