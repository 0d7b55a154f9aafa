#include "techniques/scene_shader.h"

#include <algorithm>
#include <cmath>
#include <glm/geometric.hpp>

namespace lode::techniques {
namespace {

/// The cosine between a direction of any length and the light; 0 for one that is zero or not finite. Divided by its
/// largest component first, so that no square overflows or vanishes.
float cosine_to_light(const glm::vec3& normal) {
  const float largest = std::max({std::abs(normal.x), std::abs(normal.y), std::abs(normal.z)});
  if (!(largest > 0.0f) || !std::isfinite(largest)) return 0.0f;
  const float x = normal.x / largest, y = normal.y / largest, z = normal.z / largest;
  const float length = std::sqrt((x * x + y * y) + z * z);
  return ((x / length) * kToLight.x + (y / length) * kToLight.y) + (z / length) * kToLight.z;
}

/// How much light the side that is seen gets, 0…1.
float light_on(const SceneSurface& surface, const glm::vec3& normal, bool front_facing) {
  const glm::mat3& m = surface.world_from_normal;
  glm::vec3 n;
  for (int row = 0; row < 3; ++row) n[row] = (m[0][row] * normal.x + m[1][row] * normal.y) + m[2][row] * normal.z;
  const bool sees_back = front_facing == surface.front_is_clockwise;
  const float cosine = surface.double_sided && sees_back ? -cosine_to_light(n) : cosine_to_light(n);
  return kAmbient + (1.0f - kAmbient) * std::max(cosine, 0.0f);
}

/// A masked sample: opaque, or not there.
glm::vec4 cut_out(const SceneSurface& surface, const glm::vec4& c) {
  if (!(double{c.a} / double{surface.full} >= *surface.alpha_cutoff)) return glm::vec4(0.0f);
  if (!(c.a > 0.0f)) return {0.0f, 0.0f, 0.0f, surface.full};
  return {c.r / c.a * surface.full, c.g / c.a * surface.full, c.b / c.a * surface.full, surface.full};
}

void shade(const void* state, const raster::ShadeBatch& batch, glm::vec4* rgba) noexcept {
  const SceneSurface& surface = *static_cast<const SceneSurface*>(state);
  for (int i = 0; i < batch.n; ++i) {
    glm::vec4 color = surface.alpha_cutoff ? cut_out(surface, batch.material[i]) : batch.material[i];
    if (surface.lit) {
      const float light = light_on(surface, batch.normal[i], batch.front_facing);
      color = {color.r * light, color.g * light, color.b * light, color.a};
    }
    rgba[i] = color;
  }
}

}  // namespace

raster::Shader scene_shader(const SceneSurface& surface) {
  if (!surface.lit && !surface.alpha_cutoff) return {};
  return {shade, std::make_shared<const SceneSurface>(surface)};
}

glm::mat3 world_from_normal(const glm::dmat4& world_from_object) {
  const glm::dvec3 x(world_from_object[0]), y(world_from_object[1]), z(world_from_object[2]);
  // The cofactors are the inverse transpose times the determinant, whose sign must not turn normals inside out. The
  // columns are scaled first, which scales the cofactors and keeps them from overflowing.
  double largest = 0.0;
  for (const glm::dvec3& column : {x, y, z}) {
    for (int row = 0; row < 3; ++row) {
      if (!std::isfinite(column[row])) return glm::mat3(0.0f);
      largest = std::max(largest, std::abs(column[row]));
    }
  }
  if (!(largest > 0.0)) return glm::mat3(0.0f);
  const glm::dvec3 a = x / largest, b = y / largest, c = z / largest;
  const glm::dmat3 cofactors(glm::cross(b, c), glm::cross(c, a), glm::cross(a, b));
  const double sign = glm::dot(a, cofactors[0]) < 0.0 ? -1.0 : 1.0;
  double scale = 0.0;
  for (int i = 0; i < 9; ++i) scale = std::max(scale, std::abs(cofactors[i / 3][i % 3]));
  if (!(scale > 0.0)) return glm::mat3(0.0f);
  return glm::mat3(sign / scale * cofactors);
}

}  // namespace lode::techniques
