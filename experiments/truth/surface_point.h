#pragma once
/// What a ray meets on a triangle: depth, weights of the vertices, texture footprint, in double; and its colour, by the
/// same draw, textures and shader that the rasterizer uses.
///
/// A point of the target is the direction S = (X, Y, 1) in (x, y, w) of clip space. It lies on the triangle c₀c₁c₂ at
/// weights βᵢ with Σ βᵢcᵢ ∝ S, which are linear on the object, so perspective-correct: β₀ = det(S, c₁, c₂) and so on in
/// turn (Olano & Greer, Triangle scan conversion using 2D homogeneous coordinates, 1997, sec. 3). They are linear in X
/// and Y, which gives the footprint's derivatives; no corner need be in front of the eye.

#include <array>
#include <glm/vec2.hpp>

#include "raster/frame.h"
#include "raster/image.h"
#include "raster/texture.h"

namespace lode::experiments::truth {

struct SurfacePoint {
  std::array<std::uint32_t, 3> vertices{};  ///< of the draw
  std::array<double, 3> weights{};          ///< sum 1; a little outside [0, 1] where the hit is
  raster::Footprint footprint;              ///< of the draw's texture coordinates
  float depth = 0.0f;                       ///< [0, 1]
  bool front_facing = true;                 ///< counter-clockwise on screen
};

/// Of triangle `primitive` of a draw of ObjectVertices, at a point of the target.
[[nodiscard]] SurfacePoint surface_point(const raster::Draw& draw, std::uint32_t primitive, glm::ivec2 size_px,
                                         glm::dvec2 p_px);

/// The shader's result in the target's unit, not yet stored: as the rasterizer's shading (C7, C10), with these weights.
[[nodiscard]] glm::vec4 shade(const raster::Draw& draw, raster::Ids ids, raster::ColorFormat format, glm::ivec2 px,
                              const SurfacePoint& point);

}  // namespace lode::experiments::truth
