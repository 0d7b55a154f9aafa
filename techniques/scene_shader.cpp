#include "techniques/scene_shader.h"

#include <algorithm>
#include <cmath>
#include <glm/geometric.hpp>

namespace lode::techniques {
namespace {

raster::Lambert lambert(const SceneSurface& surface) {
  return {.to_light = kToLight,
          .ambient = kAmbient,
          .light_from_normal = surface.world_from_normal,
          .turns_backs = surface.double_sided,
          .front_is_clockwise = surface.front_is_clockwise};
}

}  // namespace

raster::Shader scene_shader(const SceneSurface& surface) {
  raster::MaterialShading shading;
  if (surface.alpha_cutoff) shading.cut_out = raster::CutOut{.cutoff = *surface.alpha_cutoff, .full = surface.full};
  if (surface.lit) shading.light = lambert(surface);
  return raster::material_shader(shading);
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
