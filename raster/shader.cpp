#include "raster/shader.h"

#include <algorithm>
#include <cmath>

namespace lode::raster {
namespace {

/// The cosine of the angle between a direction of any length and the unit vector to the light; 0 for one that is zero or
/// not finite. Divided by its largest component first, so that neither 1e-30 nor 1e30 is lost in a square.
float cosine_to_light(const glm::vec3& n, const glm::vec3& to_light) {
  if (!std::isfinite(n.x) || !std::isfinite(n.y) || !std::isfinite(n.z)) return 0.0f;
  const float largest = std::max({std::abs(n.x), std::abs(n.y), std::abs(n.z)});
  if (largest == 0.0f) return 0.0f;
  const float x = n.x / largest, y = n.y / largest, z = n.z / largest;
  const float length = std::sqrt((x * x + y * y) + z * z);
  return ((x / length) * to_light.x + (y / length) * to_light.y) + (z / length) * to_light.z;
}

float light_on(const Lambert& lambert, const glm::vec3& normal, bool front_facing) {
  const glm::mat3& m = lambert.light_from_normal;
  glm::vec3 n;
  for (int row = 0; row < 3; ++row) n[row] = (m[0][row] * normal.x + m[1][row] * normal.y) + m[2][row] * normal.z;
  float cosine = cosine_to_light(n, lambert.to_light);
  if (lambert.turns_backs && front_facing == lambert.front_is_clockwise) cosine = -cosine;
  const float facing = lambert.two_sided ? std::abs(cosine) : std::max(cosine, 0.0f);
  return lambert.ambient + (1.0f - lambert.ambient) * facing;
}

glm::vec4 cut(const CutOut& c, const glm::vec4& material) {
  if (!(double{material.a} / double{c.full} >= c.cutoff)) return glm::vec4(0.0f);
  if (!(material.a > 0.0f)) return {0.0f, 0.0f, 0.0f, c.full};
  return {material.r / material.a * c.full, material.g / material.a * c.full, material.b / material.a * c.full, c.full};
}

void shade_material(const void* state, const ShadeBatch& batch, glm::vec4* rgba) noexcept {
  const MaterialShading& shading = *static_cast<const MaterialShading*>(state);
  for (int i = 0; i < batch.n; ++i) {
    if (shading.cut_out && !shading.cut_out->keeps(batch.x_px[i], batch.y_px[i])) {
      rgba[i] = glm::vec4(0.0f);
      continue;
    }
    const glm::vec4 c = shading.cut_out ? cut(*shading.cut_out, batch.material[i]) : batch.material[i];
    const float light = shading.light ? light_on(*shading.light, batch.normal[i], batch.front_facing) : 1.0f;
    rgba[i] = {c.r * light, c.g * light, c.b * light, c.a};
  }
}

}  // namespace

Shader lambert_shader(const Lambert& params) { return material_shader({.cut_out = {}, .light = params}); }

Shader material_shader(const MaterialShading& params) {
  if (!params.cut_out && !params.light) return {};
  return {shade_material, std::make_shared<const MaterialShading>(params)};
}

const MaterialShading* material_of(const Shader& shader) {
  return shader.function == shade_material ? static_cast<const MaterialShading*>(shader.state.get()) : nullptr;
}

}  // namespace lode::raster
