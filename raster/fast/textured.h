#pragma once
/// Triangles with a texture, made ready for the kernels. A texture coordinate is N/D of two functions that are affine
/// in the window (Heckbert & Moreton, "Interpolation for polygon texture mapping and shading", 1991), so that a sample
/// costs one division, and derivatives cost none: the numerators of ∂(N/D)/∂x = (N_x·D − N·D_x)/D² do not depend on x,
/// nor those of ∂/∂y on y. This is not the reference's order of operations (C7). The kernels give its bytes all the
/// same: they carry a bound of the difference, and a sample whose coordinate or level of detail lies within the bound
/// of a rounding's tie is done by the reference's own functions, `exact_texel`.

#include <array>
#include <cstdint>
#include <glm/vec2.hpp>
#include <glm/vec4.hpp>

#include "raster/fast/triangle_edges.h"
#include "raster/image.h"
#include "raster/level_of_detail.h"
#include "raster/reference/assemble.h"

namespace lode::raster::fast {

/// A value that is affine in the window: at(x, y) = x·X + y·Y + c, in pixels from the tile's corner.
struct Plane {
  double x = 0.0, y = 0.0, c = 0.0;
};

/// One triangle that was not clipped, relative to a tile.
struct TexturedTriangle : TriangleEdges {
  std::array<double, 3> bias{};  ///< inside is edge ≥ bias
  std::array<double, 3> z{};
  double area = 1.0;  ///< doubled, 1/256² px²: the sum of the edge values
  double z_low = 0.0, z_high = 0.0;

  // Approximate, for samples inside the triangle and the tile. Where `bounded` is false no bound is of use.
  bool bounded = false;
  Plane u, v, sum;  ///< uᵢ and vᵢ times the weights, and the weights, which add up to `sum`, 0 < sum ≤ 1
  std::array<double, 4> slope{};  ///< numerators, in texels of level 0: ∂u/∂x, ∂v/∂x at y = 0; ∂u/∂y, ∂v/∂y at x = 0
  std::array<double, 4> slope_step{};  ///< what they gain per pixel of y, y, x, x
  std::int32_t margin_fx31 = 0;        ///< bound of the error of u and v, plus 1, in 2^-31
  float margin_lambda = 0.0f;          ///< bound of the error of 128·log2(ρ²)
  LevelPair levels;                    ///< of every sample, unless `levels_vary`
  bool levels_vary = false;            ///< trilinear in perspective
  alignas(64) std::array<double, 16> lane_u{}, lane_v{}, lane_sum{};  ///< what the planes gain within a 4×4

  const Texture* texture = nullptr;
  Sampler sampler;
  bool has_color = false;  ///< the draw's
  bool has_vertex_colors = false;
  std::array<float, 4> color{};
  std::array<std::array<float, 4>, 3> vertex_colors{};

  // For the reference's functions.
  reference::Triangle shape;
  std::array<glm::vec2, 3> uvs{};
  glm::ivec2 origin_fx8{0, 0};  ///< the tile's corner
};

/// Whether the kernels shade a draw's triangles: bytes of a raw texture by an isotropic filter, without border, shader
/// or alpha test.
[[nodiscard]] bool can_texture(const Draw& draw, ColorFormat format);

/// Whether `draw_textured` draws them, too: ordered, and depth is not written.
[[nodiscard]] bool can_draw_textured(const Draw& draw, ColorFormat format);

/// As the kernels need it.
///   piece   a Triangle with no polygon, of a draw that can_texture let pass
/// Cost: a few hundred cycles; keep it for all samples of a tile.
[[nodiscard]] TexturedTriangle make_textured(const Draw& draw, const reference::Piece& piece,
                                             glm::ivec2 tile_origin_px);

/// The filtered texel at a sample, as the reference has it; texels_read grows by what the filter fetched.
///   p_fx8   from the tile's corner
[[nodiscard]] std::uint32_t exact_texel(const TexturedTriangle& t, glm::ivec2 p_fx8, std::uint64_t* texels_read);

}  // namespace lode::raster::fast
