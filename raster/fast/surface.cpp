#include "raster/fast/surface.h"

#include <algorithm>
#include <bit>
#include <cmath>
#include <limits>

#include "raster/level_of_detail.h"
#include "raster/reference/shade.h"

namespace lode::raster::fast {
namespace {

void set_uvs(const Draw& draw, const reference::Piece& piece, SurfaceTriangle& t) {
  const auto& shape = std::get<reference::Triangle>(piece.shape);
  const std::array<glm::dvec2, 3> corners = reference::corner_uvs(shape, reference::piece_uvs(draw, piece).value());
  for (std::size_t i = 0; i < 3; ++i) {
    t.uvs[0][i] = corners[i].x, t.uvs[1][i] = corners[i].y;
    t.weight_slopes[0][i] = 256.0 * t.edge_x[i], t.weight_slopes[1][i] = 256.0 * t.edge_y[i];
    for (auto& slopes : t.weight_slopes) slopes[i] = t.affine ? slopes[i] : slopes[i] / t.w[i];
  }
}

/// The least alpha in the target's unit for which double(alpha) / full ≥ threshold; NaN if there is none.
float least_alpha(double threshold, float full) {
  constexpr float kInfinity = std::numeric_limits<float>::infinity();
  if (std::isnan(threshold)) return std::numeric_limits<float>::quiet_NaN();
  const auto passes = [&](float alpha) { return double{alpha} / double{full} >= threshold; };
  auto least = float(threshold * full);  // none below passes: it would be half a float away, and doubles are finer
  while (!passes(least)) least = std::nextafter(least, kInfinity);
  return least;
}

/// Whether interpolation gives the vertices' value whatever the weights are: it is clamped to what is between them (C7).
/// Not so where it is infinite.
template <std::size_t N>
bool all_equal(const std::array<std::array<float, 3>, N>& attribute) {
  return std::all_of(attribute.begin(), attribute.end(),
                     [](const auto& a) { return a[0] == a[1] && a[1] == a[2] && std::isfinite(a[0]); });
}

}  // namespace

std::optional<Surface> make_surface(const Draw& draw, ColorFormat format) {
  const MaterialShading* shading = material_of(draw.shader);
  if (draw.shader.function && !shading) return std::nullopt;
  if (draw.texture && (draw.uvs.empty() || draw.sampler.filter == Filter::anisotropic)) return std::nullopt;
  Surface s;
  s.full = format == ColorFormat::rgba8 ? 255.0f : 1.0f;
  const glm::vec4 color = draw.color.value_or(glm::vec4(s.full));
  s.color = {color.r, color.g, color.b, color.a};
  s.has_color = draw.color.has_value();
  s.has_vertex_colors = !draw.colors.empty();
  if (shading && shading->light) s.lambert = &*shading->light;
  if (shading && shading->cut_out) {
    s.cut_out = true;
    s.opaque = shading->cut_out->full;
    s.least_kept = least_alpha(shading->cut_out->cutoff, s.opaque);
    s.kept_pixels = shading->cut_out->pixels;
  }
  if (draw.alpha_test) s.least_passing = least_alpha(*draw.alpha_test, s.full);
  s.has_normals = !draw.normals.empty();
  s.texture = draw.texture;
  s.sampler = draw.sampler;
  return s;
}

SurfaceTriangle make_surface_triangle(const Draw& draw, const reference::Piece& piece, glm::ivec2 tile_origin_px) {
  const auto& shape = std::get<reference::Triangle>(piece.shape);
  SurfaceTriangle t{make_triangle_edges(shape, tile_origin_px * 256)};
  t.clipped = shape.polygon != nullptr;
  t.front_facing = piece.front_facing;
  for (std::size_t i = 0; i < 3; ++i) {
    if (t.clipped) t.polygon[i] = shape.polygon->weights[std::size_t(shape.polygon_vertex[i])];
    const std::uint32_t vertex = piece.vertices[i];
    for (int c = 0; c < 4 && !draw.colors.empty(); ++c) t.colors[std::size_t(c)][i] = draw.colors[vertex][c];
    for (int c = 0; c < 3 && !draw.normals.empty(); ++c) t.normals[std::size_t(c)][i] = draw.normals[vertex][c];
  }
  t.flat = all_equal(t.colors) && all_equal(t.normals);
  if (draw.texture) set_uvs(draw, piece, t);
  return t;
}

std::uint64_t apply_texture(const Surface& s, std::uint32_t lanes, SurfaceSamples& samples) {
  std::uint64_t n_read = 0;
  for (; lanes != 0; lanes &= lanes - 1) {
    const auto k = std::size_t(std::countr_zero(lanes));
    const glm::dvec2 uv(samples.u[k], samples.v[k]);
    const std::int32_t lambda = s.sampler.filter == Filter::trilinear ? lambda_fx8(samples.rho_squared[k]) : 0;
    glm::vec4 texel;
    if (s.texture->format == TextureFormat::linear) {
      texel = sample_linear(*s.texture, s.sampler, uv, lambda, &n_read);
    } else {
      texel = glm::vec4(sample_raw(*s.texture, s.sampler, uv, lambda, &n_read));
      if (s.full == 1.0f) texel /= 255.0f;
    }
    for (std::size_t c = 0; c < 4; ++c) samples.rgba[c][k] = samples.rgba[c][k] * texel[int(c)] / s.full;
  }
  if (!s.lambert || s.cut_out) return n_read;
  for (std::size_t c = 0; c < 3; ++c) {
    for (std::size_t k = 0; k < 16; ++k) samples.rgba[c][k] *= samples.light[k];
  }
  return n_read;
}

}  // namespace lode::raster::fast
