#include "techniques/scene_shader.h"

#include <algorithm>
#include <array>
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

/// A surface with what lights it.
struct Masked {
  SceneSurface surface;
  raster::Shader light;
};

/// A masked sample: opaque, or not there.
glm::vec4 cut_out(const SceneSurface& surface, const glm::vec4& c) {
  if (!(double{c.a} / double{surface.full} >= *surface.alpha_cutoff)) return glm::vec4(0.0f);
  if (!(c.a > 0.0f)) return {0.0f, 0.0f, 0.0f, surface.full};
  return {c.r / c.a * surface.full, c.g / c.a * surface.full, c.b / c.a * surface.full, surface.full};
}

void shade(const void* state, const raster::ShadeBatch& batch, glm::vec4* rgba) noexcept {
  const Masked& masked = *static_cast<const Masked*>(state);
  std::array<glm::vec4, raster::kMaxShadeBatch> cut;
  for (int i = 0; i < batch.n; ++i) cut[std::size_t(i)] = cut_out(masked.surface, batch.material[i]);
  if (!masked.surface.lit) {
    std::copy_n(cut.begin(), batch.n, rgba);
    return;
  }
  raster::ShadeBatch lit = batch;
  lit.material = cut.data();
  masked.light.function(masked.light.state.get(), lit, rgba);
}

}  // namespace

raster::Shader scene_shader(const SceneSurface& surface) {
  const raster::Shader light = surface.lit ? raster::lambert_shader(lambert(surface)) : raster::Shader{};
  if (!surface.alpha_cutoff) return light;
  return {shade, std::make_shared<const Masked>(Masked{surface, light})};
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
