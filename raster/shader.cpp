#include "raster/shader.h"

#include <algorithm>
#include <cmath>

namespace lode::raster {
namespace {

/// The cosine of the angle between a normal of any length and the unit vector to the light; 0 for a normal that is
/// zero or not finite. Divided by its largest component first, so that neither 1e-30 nor 1e30 is lost in a square.
float cosine_to_light(const glm::vec3& normal, const glm::vec3& to_light) {
  if (!std::isfinite(normal.x) || !std::isfinite(normal.y) || !std::isfinite(normal.z)) return 0.0f;
  const float largest = std::max({std::abs(normal.x), std::abs(normal.y), std::abs(normal.z)});
  if (largest == 0.0f) return 0.0f;
  const float x = normal.x / largest, y = normal.y / largest, z = normal.z / largest;
  const float length = std::sqrt((x * x + y * y) + z * z);
  return ((x / length) * to_light.x + (y / length) * to_light.y) + (z / length) * to_light.z;
}

void shade_lambert(const void* state, const ShadeBatch& batch, glm::vec4* rgba) noexcept {
  const Lambert& lambert = *static_cast<const Lambert*>(state);
  for (int i = 0; i < batch.n; ++i) {
    const float cosine = cosine_to_light(batch.normal[i], lambert.to_light);
    const float facing = lambert.two_sided ? std::abs(cosine) : std::max(cosine, 0.0f);
    const float light = lambert.ambient + (1.0f - lambert.ambient) * facing;
    const glm::vec4& material = batch.material[i];
    rgba[i] = {material.r * light, material.g * light, material.b * light, material.a};
  }
}

}  // namespace

Shader lambert_shader(const Lambert& params) { return {shade_lambert, std::make_shared<const Lambert>(params)}; }

}  // namespace lode::raster
