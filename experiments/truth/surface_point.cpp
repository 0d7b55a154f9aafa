#include "experiments/truth/surface_point.h"

#include <algorithm>

#include "experiments/truth/source_triangle.h"

namespace lode::experiments::truth {
namespace {

double cross(const glm::dvec2& a, const glm::dvec2& b) { return a.x * b.y - a.y * b.x; }

double weighted(const std::array<double, 3>& b, double a0, double a1, double a2) {
  const double sum = (b[0] * a0 + b[1] * a1) + b[2] * a2;
  return std::clamp(sum, std::min({a0, a1, a2}), std::max({a0, a1, a2}));
}

/// (b₀·a₀ + b₁·a₁) + b₂·a₂ in float, inside the hull of the values (C7).
template <class Vector>
Vector interpolate(const SurfacePoint& point, std::span<const Vector> values) {
  const Vector &a0 = values[point.vertices[0]], &a1 = values[point.vertices[1]], &a2 = values[point.vertices[2]];
  const float b0 = float(point.weights[0]), b1 = float(point.weights[1]), b2 = float(point.weights[2]);
  Vector result;
  for (int c = 0; c < Vector::length(); ++c) {
    result[c] = std::clamp((b0 * a0[c] + b1 * a1[c]) + b2 * a2[c], std::min({a0[c], a1[c], a2[c]}),
                           std::max({a0[c], a1[c], a2[c]}));
  }
  return result;
}

/// The texture at the point, in the target's unit.
glm::vec4 texel_at(const raster::Draw& draw, raster::ColorFormat format, const raster::Footprint& footprint) {
  if (draw.texture->format == raster::TextureFormat::linear) {
    return raster::sample_linear(*draw.texture, draw.sampler, footprint);
  }
  const glm::vec4 bytes = glm::vec4(raster::sample_raw(*draw.texture, draw.sampler, footprint));
  return format == raster::ColorFormat::rgba8 ? bytes : bytes / 255.0f;
}

}  // namespace

SurfacePoint surface_point(const raster::Draw& draw, std::uint32_t primitive, glm::ivec2 size_px, glm::dvec2 p_px) {
  const auto& vertices = std::get<raster::ObjectVertices>(draw.vertices);
  const glm::dvec2 half = 0.5 * glm::dvec2(size_px);
  const double x = p_px.x / half.x - 1.0, y = 1.0 - p_px.y / half.y;

  SurfacePoint point;
  std::array<glm::dvec4, 3> c;
  std::array<glm::dvec2, 3> a;  // cᵢ − wᵢS: what is left in x and y, small where the triangle is
  for (std::size_t i = 0; i < 3; ++i) {
    const std::size_t k = 3 * std::size_t{primitive} + i;
    point.vertices[i] = draw.indices ? (*draw.indices)[k] : std::uint32_t(k);
    c[i] = clip_corner(vertices.clip_from_object, vertices.positions[point.vertices[i]]).p;
    a[i] = {c[i].x - x * c[i].w, c[i].y - y * c[i].w};
  }
  std::array<double, 3> beta, beta_x, beta_y;  // βᵢ and its derivatives by X and Y
  for (std::size_t i = 0; i < 3; ++i) {
    const std::size_t j = (i + 1) % 3, k = (i + 2) % 3;
    beta[i] = cross(a[j], a[k]);
    beta_x[i] = a[j].y * c[k].w - c[j].w * a[k].y;
    beta_y[i] = c[j].w * a[k].x - a[j].x * c[k].w;
  }
  const double sum = (beta[0] + beta[1]) + beta[2];
  const double det = (beta[0] * c[0].w + beta[1] * c[1].w) + beta[2] * c[2].w;
  for (std::size_t i = 0; i < 3; ++i) point.weights[i] = sum != 0.0 ? beta[i] / sum : 1.0 / 3.0;
  const double z = ((beta[0] * c[0].z + beta[1] * c[1].z) + beta[2] * c[2].z) / det;
  point.depth = float(z > 0.0 ? std::min(z, 1.0) : 0.0);  // NaN, of a triangle seen edge-on, becomes 0
  point.front_facing = det > 0.0;

  if (draw.uvs.empty()) return point;
  std::array<glm::dvec2, 3> uv;
  for (std::size_t i = 0; i < 3; ++i) uv[i] = glm::dvec2(draw.uvs[point.vertices[i]]);
  raster::Footprint& f = point.footprint;
  for (int k = 0; k < 2; ++k) {
    f.uv[k] = weighted(point.weights, uv[0][k], uv[1][k], uv[2][k]);
    const double d0 = uv[0][k] - f.uv[k], d1 = uv[1][k] - f.uv[k], d2 = uv[2][k] - f.uv[k];
    f.duv_dx[k] = ((beta_x[0] * d0 + beta_x[1] * d1) + beta_x[2] * d2) / sum / half.x;
    f.duv_dy[k] = -((beta_y[0] * d0 + beta_y[1] * d1) + beta_y[2] * d2) / sum / half.y;
  }
  return point;
}

glm::vec4 shade(const raster::Draw& draw, raster::Ids ids, raster::ColorFormat format, glm::ivec2 px,
                const SurfacePoint& point) {
  const float full = format == raster::ColorFormat::rgba8 ? 255.0f : 1.0f;
  const glm::vec4 white(full);
  glm::vec4 color = draw.color.value_or(white);
  if (!draw.colors.empty()) {
    const glm::vec4 vertex_color = interpolate(point, draw.colors);
    color = draw.color ? color * vertex_color / full : vertex_color;
  }
  const glm::vec4 texel = draw.texture ? texel_at(draw, format, point.footprint) : white;
  const glm::vec4 material = draw.texture ? color * texel / full : color;
  if (!draw.shader.function) return material;

  const glm::vec3 normal = draw.normals.empty() ? glm::vec3(0.0f) : interpolate(point, draw.normals);
  const glm::vec2 uv(point.footprint.uv);
  const raster::ShadeBatch batch{.n = 1,
                                 .draw = ids.draw,
                                 .primitive = ids.primitive,
                                 .front_facing = point.front_facing,
                                 .x_px = &px.x,
                                 .y_px = &px.y,
                                 .depth = &point.depth,
                                 .material = &material,
                                 .color = &color,
                                 .texel = &texel,
                                 .normal = &normal,
                                 .uv = &uv};
  glm::vec4 rgba;
  draw.shader.function(draw.shader.state.get(), batch, &rgba);
  return rgba;
}

}  // namespace lode::experiments::truth
