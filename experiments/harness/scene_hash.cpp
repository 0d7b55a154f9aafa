#include "experiments/harness/scene_hash.h"

#include <span>

#include "experiments/parameter.h"
#include "experiments/sha256.h"

namespace lode::experiments {
namespace {

template <class T>
std::string hash_of_list(const std::vector<T>& list) {
  return std::to_string(list.size()) + ":" + sha256_hex(std::as_bytes(std::span(list)));
}

std::string text_of(const geometry::Material& m) {
  std::string text = "material";
  for (int c = 0; c < 4; ++c) text += " " + number_text(m.color[c]);
  text += " " + number_text(m.alpha_cutoff) + (m.double_sided ? " d" : " s") + (m.unlit ? " u" : " l");
  text += " " + std::to_string(int(m.alpha_mode));
  if (const auto& use = m.color_texture) {
    for (const int v : {int(use->picture), int(use->wrap_u), int(use->wrap_v), int(use->filter)}) {
      text += " " + std::to_string(v);
    }
  }
  return text + ";";
}

}  // namespace

std::string look_hash_of(const geometry::Scene& scene) {
  std::string all = hash_of(scene);
  for (const geometry::Mesh& mesh : scene.meshes) {
    all += hash_of_list(mesh.normals) + hash_of_list(mesh.uvs) + hash_of_list(mesh.colors);
    all += mesh.material ? std::to_string(*mesh.material) : "none";
  }
  for (const geometry::Material& material : scene.materials) all += text_of(material);
  for (const geometry::Picture& picture : scene.pictures) {
    all += std::to_string(picture.size_px.x) + "x" + std::to_string(picture.size_px.y) + hash_of_list(picture.texels);
  }
  return sha256_hex(std::as_bytes(std::span(all)));
}

std::string hash_of(const geometry::Scene& scene) {
  std::string all;
  for (const geometry::Mesh& mesh : scene.meshes) {
    all += std::to_string(int(mesh.kind)) + hash_of_list(mesh.positions) + hash_of_list(mesh.indices);
    if (!mesh.material) continue;
    const geometry::Material& material = scene.materials[*mesh.material];
    all += std::to_string(int(material.alpha_mode)) + (material.double_sided ? "d" : "s");
    if (material.alpha_mode != geometry::AlphaMode::mask) continue;
    all += std::to_string(material.alpha_cutoff) + " " + number_text(material.color.a);
    all += hash_of_list(mesh.colors) + hash_of_list(mesh.uvs);
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
