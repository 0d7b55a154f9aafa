#pragma once
/// Surfels: flat discs with a centre, a normal and a radius in object space (C12; Pfister et al., Surfels,
/// SIGGRAPH 2000). A sample is covered if the ray of its points in object space meets the closed disc in front
/// of the eye, between the near and the far plane (w ≥ kMinW, 0 ≤ z ≤ w at the hit: each sample is clipped by
/// itself). The test is exact for all finite inputs: doubles with an error bound decide, and integers where that
/// bound does not (exact_surfel.h). Infinite inputs are read as ±2^128. Both sides of a surfel are drawn.

#include <glm/mat4x4.hpp>
#include <glm/vec2.hpp>
#include <glm/vec3.hpp>
#include <optional>

#include "raster/reference/box_walk.h"
#include "raster/reference/exact_surfel.h"
#include "raster/reference/primitive.h"

namespace lode::raster::reference {

struct Surfel {
  SurfelInput input;
  HitMap<Bounded> map;                       ///< w > 0
  glm::ivec2 low_fx8{0, 0}, high_fx8{0, 0};  ///< closed box around all covered samples, in the guard band
  bool inside_clip_volume = false;           ///< true: none of the box's samples is clipped or hits behind the eye
};

/// A NaN in the centre or the normal: such a surfel is bad data, counted as not finite.
[[nodiscard]] bool has_nan(const glm::vec3& centre, const glm::vec3& normal);

/// Nothing where no sample can be covered: a NaN, radius ≤ 0, a normal of length 0, a plane through the eye or
/// parallel to an orthographic view, all of the disc outside the clip volume, a matrix that is not finite, an
/// empty viewport.
///   normal     any length but 0; only its direction counts
///   radius     object units, > 0
///   viewport   where clip space lands, in pixels; may leave the target
[[nodiscard]] std::optional<Surfel> make_surfel(const glm::vec3& centre, const glm::vec3& normal, float radius,
                                                const glm::dmat4& clip_from_object, glm::ivec2 viewport_origin_px,
                                                glm::ivec2 viewport_size_px);

[[nodiscard]] bool covers(const Surfel& s, glm::ivec2 p_fx8);

[[nodiscard]] PixelBox bounds_px(const Surfel& s, glm::ivec2 sample_fx8);

/// z/w of the hit, within 0.501 ULP.
[[nodiscard]] float depth_at(const Surfel& s, glm::ivec2 p_fx8);
[[nodiscard]] inline VertexWeights weights_at(const Surfel&, glm::ivec2) { return {1.0, 0.0, 0.0}; }

/// (0,0)…(1,1) across the square around the disc, whose sides follow a basis that depends on the normal alone
/// (Duff et al., Building an Orthonormal Basis, Revisited, JCGT 2017); the vertex's own coordinate where it has one.
[[nodiscard]] Footprint footprint_at(const Surfel& s, const VertexUvs& uvs, glm::ivec2 p_fx8);

}  // namespace lode::raster::reference
