#pragma once
/// Triangles made ready for exact shading: colours, normals and texture coordinates in C7's order of operations, for
/// targets whose values leave no room for a shortcut (floats), and for light. Sixteen samples of a 4×4 at a time.

#include <array>
#include <cstdint>
#include <optional>

#include "raster/fast/triangle_edges.h"
#include "raster/image.h"
#include "raster/reference/assemble.h"

namespace lode::raster::fast {

/// What a draw's samples have in common.
struct Surface {
  bool has_color = false, has_vertex_colors = false;
  std::array<float, 4> color{};  ///< the draw's, or white
  float full = 1.0f;             ///< 255 for bytes
  const Lambert* lambert = nullptr;
  bool has_normals = false;
  bool cut_out = false;      ///< before it is lit
  float opaque = 1.0f;       ///< alpha of what the cut-out keeps
  float least_kept = 0.0f;   ///< alpha: the least that the cut-out keeps, in the target's unit; NaN: none
  std::uint32_t kept_pixels = 0xFFFF;  ///< of each 4×4, by the cut-out
  float least_passing = 0.0f;  ///< alpha: the least that passes the draw's alpha test, if it has one; NaN: none
  const Texture* texture = nullptr;
  Sampler sampler;
};

/// A triangle of a surface, relative to a tile; of a clipped primitive the attributes are its own vertices', and
/// `polygon` weighs them.
struct SurfaceTriangle : TriangleEdges {
  bool clipped = false, front_facing = true;
  bool flat = false;  ///< colours and normals are the same at all vertices, so that whatever weighs them does not matter
  std::array<std::array<double, 3>, 3> polygon{};        ///< [corner][vertex]
  std::array<std::array<float, 3>, 4> colors{};          ///< [channel][vertex]
  std::array<std::array<float, 3>, 3> normals{};         ///< [axis][vertex]
  std::array<std::array<double, 3>, 2> uvs{};            ///< [axis][corner]
  std::array<std::array<double, 3>, 2> weight_slopes{};  ///< [x, y][corner]: of edge / w, per pixel
};

/// Whether all samples of the triangle have one colour, wherever they are.
[[nodiscard]] inline bool has_one_color(const Surface& s, const SurfaceTriangle& t) {
  const bool varies = s.has_vertex_colors || (s.lambert && s.has_normals);
  return !s.texture && s.kept_pixels == 0xFFFF && (t.flat || !varies);
}

/// What the kernels make of sixteen samples.
struct SurfaceSamples {
  alignas(64) float rgba[4][16];  ///< lit, if nothing is to come before: a texture, a cut-out
  alignas(64) float light[16];         ///< if the surface is lit
  alignas(64) double u[16], v[16];     ///< if it has a texture
  alignas(64) double rho_squared[16];  ///< likewise, if the filter is trilinear: of the longer derivative, texels
};

/// None if the draw's triangles cannot be shaded as a surface's: by another shader than material_shader's, or an
/// anisotropic filter.
[[nodiscard]] std::optional<Surface> make_surface(const Draw& draw, ColorFormat format);

/// piece: a Triangle
[[nodiscard]] SurfaceTriangle make_surface_triangle(const Draw& draw, const reference::Piece& piece,
                                                    glm::ivec2 tile_origin_px);

/// Multiplies the colours of the lanes (a bit each) by their texels, then by their light, unless they are cut out
/// first. Returns how many were read.
std::uint64_t apply_texture(const Surface& surface, std::uint32_t lanes, SurfaceSamples& samples);

}  // namespace lode::raster::fast
