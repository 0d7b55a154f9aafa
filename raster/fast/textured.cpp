#include "raster/fast/textured.h"

#include <algorithm>
#include <bit>
#include <cmath>

namespace lode::raster::fast {
namespace {

constexpr double kTile_px = 128.0;  ///< planes are bounded this far from the tile's corner

void set_edges(TexturedTriangle& t) {
  static_cast<TriangleEdges&>(t) = make_triangle_edges(t.shape, t.origin_fx8);
  const std::array<reference::EdgeFunction, 3> edges = reference::edges_of(t.shape);
  for (std::size_t i = 0; i < 3; ++i) {
    t.bias[i] = double(edges[i].bias);
    t.z[i] = t.shape.v[i].z;
  }
  t.area = (t.edge_c[0] + t.edge_c[1]) + t.edge_c[2];
  t.z_low = std::min({t.z[0], t.z[1], t.z[2]});
  t.z_high = std::max({t.z[0], t.z[1], t.z[2]});
}

/// Σ weightᵢ·aᵢ as a plane.
Plane weighted(const std::array<Plane, 3>& weight, double a0, double a1, double a2) {
  return {(weight[0].x * a0 + weight[1].x * a1) + weight[2].x * a2,
          (weight[0].y * a0 + weight[1].y * a1) + weight[2].y * a2,
          (weight[0].c * a0 + weight[1].c * a1) + weight[2].c * a2};
}

/// Largest magnitudes of what the planes are made of.
struct Magnitudes {
  double weights = 0.0;  ///< Σ |weightᵢ| anywhere in the tile, and of every partial sum; ≥ 1 if a sample is covered
  double steps = 0.0;    ///< Σ |weightᵢ's change per pixel|
  double uv = 0.0;
  double ratio = 1.0;  ///< of the greatest to the least w: inside the triangle the weights add up to ≥ 1/ratio
};

/// Weights Eᵢ/wᵢ, scaled so that each is at most 1 inside.
std::array<Plane, 3> weight_planes(const TexturedTriangle& t, Magnitudes& most) {
  const double w_low = std::min({t.w[0], t.w[1], t.w[2]}), w_high = std::max({t.w[0], t.w[1], t.w[2]});
  most.ratio = w_high / w_low;
  std::array<Plane, 3> weight;
  for (std::size_t i = 0; i < 3; ++i) {
    const double k = (t.affine ? 1.0 : w_low / t.w[i]) / t.area;
    weight[i] = {256.0 * t.edge_x[i] * k, 256.0 * t.edge_y[i] * k, t.edge_c[i] * k};
    const double step = std::max(std::fabs(weight[i].x), std::fabs(weight[i].y));
    most.steps += step;
    most.weights += std::fabs(weight[i].c) + kTile_px * (std::fabs(weight[i].x) + std::fabs(weight[i].y));
    most.uv = std::max({most.uv, std::fabs(double(t.uvs[i].x)), std::fabs(double(t.uvs[i].y))});
  }
  return weight;
}

/// Numerators of the derivatives: with N, D the planes, N_x·D − N·D_x = (N_x·D_c − N_c·D_x) + (N_x·D_y − N_y·D_x)·Y.
void set_slopes(TexturedTriangle& t, const glm::dvec2& size_px) {
  const Plane& d = t.sum;
  for (std::size_t k = 0; k < 2; ++k) {
    const Plane& n = k == 0 ? t.u : t.v;
    const double size = k == 0 ? size_px.x : size_px.y;
    const double cross = n.x * d.y - n.y * d.x;
    t.slope[k] = (n.x * d.c - n.c * d.x) * size;
    t.slope_step[k] = cross * size;
    t.slope[2 + k] = (n.y * d.c - n.c * d.y) * size;
    t.slope_step[2 + k] = -cross * size;
  }
}

/// Bounds on how far the planes' results and the reference's are apart. With ε = 2^-53: a plane's coefficients are off
/// by at most 6ε times the magnitudes they are made of (U for uv, M for weights, P for their steps), its value by
/// 18ε·U·M, and N/D by 38ε·U·M·R, as D ≥ 1/R inside. The reference's own u is off by 12ε·U. Together below 2^-45·U·M·R.
/// Likewise a numerator of a derivative is off by 2^7·ε·P·U·M, the derivative by that times R², the reference's by
/// less; ρ by 2^-44·P·U·M·R² texels, times the size, and as only ρ ≥ 0.99 matters (below, λ < 0), ρ² by the relative
/// `eta`; d(128·log2 ρ²) is 185 times that. 2^-12 is for the kernels' single precision (lambda-inl.h).
void set_margins(TexturedTriangle& t, const Magnitudes& most, double size_px) {
  const double uv_error = 0x1p-45 * most.uv * most.weights * most.ratio;
  const double eta = t.sampler.filter != Filter::trilinear
                         ? 0.0
                         : 0x1p-42 * most.steps * most.uv * most.weights * most.ratio * most.ratio * size_px +
                               0x1p-46 * most.weights * most.ratio;
  // Not so for NaN and infinities, either. The limit of the ratio keeps fourth powers of it in single precision.
  t.bounded = uv_error < 0x1p-12 && eta < 0x1p-10 && most.ratio < 0x1p20 && most.uv < 0x1p30;
  if (!t.bounded) return;
  t.margin_fx31 = 1 + std::int32_t(std::ceil(uv_error * 0x1p31));
  t.margin_lambda = float(0x1p-12 + 185.0 * eta);
  if (t.sampler.filter != Filter::trilinear) return;
  t.levels_vary = !t.affine;
  if (!t.affine) return;
  const double rho_squared =
      std::max(t.slope[0] * t.slope[0] + t.slope[1] * t.slope[1], t.slope[2] * t.slope[2] + t.slope[3] * t.slope[3]);
  const auto n_levels = std::int32_t(t.texture->levels.size());
  t.levels = mip_levels(lambda_fx8(rho_squared * (1.0 - eta)), n_levels);
  const LevelPair other = mip_levels(lambda_fx8(rho_squared * (1.0 + eta)), n_levels);
  t.bounded = t.levels.level == other.level && t.levels.second_weight_fx8 == other.second_weight_fx8;
}

void set_colors(TexturedTriangle& t, const Draw& draw, const reference::Piece& piece) {
  t.has_color = draw.color.has_value();
  const glm::vec4 color = draw.color.value_or(glm::vec4(255.0f));
  t.color = {color.r, color.g, color.b, color.a};
  t.has_vertex_colors = !draw.colors.empty();
  if (!t.has_vertex_colors) return;
  for (std::size_t i = 0; i < 3; ++i) {
    const glm::vec4& c = draw.colors[piece.vertices[i]];
    t.vertex_colors[i] = {c.r, c.g, c.b, c.a};
  }
}

}  // namespace

bool can_texture(const Draw& draw, ColorFormat format) {
  const Sampler& s = draw.sampler;
  return format == ColorFormat::rgba8 && draw.texture && draw.texture->format == TextureFormat::raw &&
         s.filter != Filter::anisotropic && s.wrap_u != Wrap::border && s.wrap_v != Wrap::border && !draw.uvs.empty() &&
         !draw.shader.function && !draw.alpha_test &&
         (draw.topology == Topology::triangles || draw.topology == Topology::quads);
}

bool can_draw_textured(const Draw& draw, ColorFormat format) {
  return can_texture(draw, format) && !draw.writes_depth();
}

TexturedTriangle make_textured(const Draw& draw, const reference::Piece& piece, glm::ivec2 tile_origin_px) {
  TexturedTriangle t;
  t.shape = std::get<reference::Triangle>(piece.shape);
  t.origin_fx8 = tile_origin_px * 256;
  t.texture = draw.texture;
  t.sampler = draw.sampler;
  for (std::size_t i = 0; i < 3; ++i) t.uvs[i] = draw.uvs[piece.vertices[i]];
  set_colors(t, draw, piece);
  set_edges(t);

  Magnitudes most;
  const std::array<Plane, 3> weight = weight_planes(t, most);
  t.sum = t.affine ? Plane{0.0, 0.0, 1.0} : weighted(weight, 1.0, 1.0, 1.0);
  t.u = weighted(weight, t.uvs[0].x, t.uvs[1].x, t.uvs[2].x);
  t.v = weighted(weight, t.uvs[0].y, t.uvs[1].y, t.uvs[2].y);
  const glm::dvec2 size_px = t.texture->levels[0].size_px;
  set_slopes(t, size_px);
  set_margins(t, most, std::max(size_px.x, size_px.y));
  for (std::size_t i = 0; i < 16; ++i) {
    const double x = double(i & 3), y = double(i >> 2);
    t.lane_u[i] = t.u.x * x + t.u.y * y;
    t.lane_v[i] = t.v.x * x + t.v.y * y;
    t.lane_sum[i] = t.sum.x * x + t.sum.y * y;
  }
  return t;
}

std::uint32_t exact_texel(const TexturedTriangle& t, glm::ivec2 p_fx8, std::uint64_t* texels_read) {
  const Footprint footprint = reference::footprint_at(t.shape, t.uvs, t.origin_fx8 + p_fx8);
  return std::bit_cast<std::uint32_t>(sample_raw(*t.texture, t.sampler, footprint, texels_read));
}

}  // namespace lode::raster::fast
