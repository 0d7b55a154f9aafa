#include "experiments/explain/explained_scene.h"

#include <cmath>

namespace lode::experiments {

const char* fate_name(raster::Fate fate) {
  constexpr const char* kNames[] = {"shown",     "hidden", "drawn",        "behind",      "alpha-failed", "not-covered",
                                    "scissored", "facing", "near-clipped", "far-clipped", "empty"};
  return kNames[std::size_t(fate)];
}

double view_distance(const geometry::Camera& camera, double depth) {
  const double n = camera.near, f = camera.far;
  if (camera.projection == geometry::Projection::orthographic) return f - depth * (f - n);
  if (std::isinf(f)) return n / depth;
  return n * f / (depth * (f - n) + n);
}

std::string draw_name(const geometry::Scene& scene, std::uint32_t draw) {
  const geometry::Instance& instance = scene.instances[draw];
  if (instance.node < scene.nodes.size() && !scene.nodes[instance.node].name.empty()) {
    return scene.nodes[instance.node].name;
  }
  const auto material = scene.meshes[instance.mesh].material;
  return material ? scene.materials[*material].name : "";
}

}  // namespace lode::experiments
