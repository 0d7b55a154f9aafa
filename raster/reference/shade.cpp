#include "raster/reference/shade.h"

#include <algorithm>
#include <array>

namespace lode::raster::reference {
namespace {

/// Weights of the piece's vertices at a sample, rounded once.
std::array<float, 3> vertex_weights(const Piece& piece, glm::ivec2 p_fx8) {
  const VertexWeights b = visit_shape(piece.shape, [&](const auto& shape) { return weights_at(shape, p_fx8); });
  return {float(b[0]), float(b[1]), float(b[2])};
}

/// (b₀·a₀ + b₁·a₁) + b₂·a₂, inside the hull of the values used (C7).
float interpolate(const std::array<float, 3>& b, const std::array<float, 3>& a, int n) {
  if (n == 1) return a[0];
  float value = b[0] * a[0] + b[1] * a[1];
  float low = std::min(a[0], a[1]), high = std::max(a[0], a[1]);
  if (n == 3) {
    value = value + b[2] * a[2];
    low = std::min(low, a[2]);
    high = std::max(high, a[2]);
  }
  return value < low ? low : (value > high ? high : value);
}

template <class Vector>
Vector interpolate(const std::array<float, 3>& b, std::span<const Vector> values, const Piece& piece) {
  const Vector &a0 = values[piece.vertices[0]], &a1 = values[piece.vertices[1]], &a2 = values[piece.vertices[2]];
  Vector result;
  for (int c = 0; c < Vector::length(); ++c) result[c] = interpolate(b, {a0[c], a1[c], a2[c]}, piece.n_vertices);
  return result;
}

/// The texture at a footprint, in the target's unit.
glm::vec4 texel_at(const Draw& draw, ColorFormat format, const Footprint& footprint, FrameStats& stats) {
  if (draw.texture->format == TextureFormat::linear) {
    return sample_linear(*draw.texture, draw.sampler, footprint, &stats.texels_read);
  }
  const glm::vec4 bytes = glm::vec4(sample_raw(*draw.texture, draw.sampler, footprint, &stats.texels_read));
  return format == ColorFormat::rgba8 ? bytes : bytes / 255.0f;
}

}  // namespace

float depth_of(const Piece& piece, glm::ivec2 p_fx8) {
  return visit_shape(piece.shape, [&](const auto& shape) { return depth_at(shape, p_fx8); });
}

VertexUvs piece_uvs(const Draw& draw, const Piece& piece) {
  if (draw.uvs.empty()) return std::nullopt;
  return {{draw.uvs[piece.vertices[0]], draw.uvs[piece.vertices[1]], draw.uvs[piece.vertices[2]]}};
}

void shade(const Draw& draw, const Piece& piece, ColorFormat format, const SampleRun& run, glm::vec4* rgba,
           FrameStats& stats) {
  const std::size_t n = run.pixels.size();
  const float full = format == ColorFormat::rgba8 ? 255.0f : 1.0f;
  const glm::vec4 white(full);
  const VertexUvs uvs = piece_uvs(draw, piece);

  std::array<std::int32_t, kMaxShadeBatch> x_px, y_px;
  std::array<glm::vec4, kMaxShadeBatch> material, color, texel;
  std::array<glm::vec3, kMaxShadeBatch> normal;
  std::array<glm::vec2, kMaxShadeBatch> uv;
  for (std::size_t i = 0; i < n; ++i) {
    const glm::ivec2 p_fx8 = sample_position_fx8(run.pixels[i], run.sample_fx8);
    const std::array<float, 3> b = vertex_weights(piece, p_fx8);
    x_px[i] = run.pixels[i].x;
    y_px[i] = run.pixels[i].y;
    color[i] = draw.color.value_or(white);
    if (!draw.colors.empty()) {
      const glm::vec4 vertex_color = interpolate(b, draw.colors, piece);
      color[i] = draw.color ? color[i] * vertex_color / full : vertex_color;
    }
    texel[i] = white;
    uv[i] = glm::vec2(0.0f);
    if (draw.texture || draw.shader.function) {
      const Footprint footprint =
          visit_shape(piece.shape, [&](const auto& shape) { return footprint_at(shape, uvs, p_fx8); });
      uv[i] = glm::vec2(footprint.uv);
      if (draw.texture) texel[i] = texel_at(draw, format, footprint, stats);
    }
    material[i] = draw.texture ? color[i] * texel[i] / full : color[i];
    normal[i] = draw.normals.empty() ? glm::vec3(0.0f) : interpolate(b, draw.normals, piece);
  }
  stats.fragments_shaded += n;

  if (!draw.shader.function) {
    std::copy_n(material.begin(), n, rgba);
    return;
  }
  const ShadeBatch batch{.n = int(n),
                         .draw = piece.ids.draw,
                         .primitive = piece.ids.primitive,
                         .front_facing = piece.front_facing,
                         .x_px = x_px.data(),
                         .y_px = y_px.data(),
                         .depth = run.depths.data(),
                         .material = material.data(),
                         .color = color.data(),
                         .texel = texel.data(),
                         .normal = normal.data(),
                         .uv = uv.data()};
  draw.shader.function(draw.shader.state.get(), batch, rgba);
}

}  // namespace lode::raster::reference
