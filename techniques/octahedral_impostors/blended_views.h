#pragma once
/// The shader of an octahedral impostor's plate: up to three pictures of one object, taken from different directions,
/// each read where the ray from the eye meets it, and mixed by weights.

#include <array>
#include <cstdint>
#include <glm/vec2.hpp>
#include <glm/vec3.hpp>

#include "raster/render.h"
#include "raster/shader.h"
#include "techniques/stage.h"

namespace lode::techniques {

/// A plate as a function of its uv, and the rays from the eye through it, from the centre of the object's box.
struct PlateRays {
  glm::dvec3 corner{0.0};  ///< at uv (0, 0)
  glm::dvec3 along_u{0.0}, along_v{0.0};
  glm::dvec3 eye{0.0};        ///< perspective
  glm::dvec3 direction{0.0};  ///< of all rays, if any is 0: orthographic
  bool parallel = false;
};

/// A picture that a parallel projection took (parallel_picture.h), and how much it counts.
struct WeightedView {
  const CapturedPicture* picture = nullptr;
  double weight = 0.0;          ///< 0…1
  double texels_a_pixel = 0.0;  ///< of the view, along a side: which level of detail is read
};

/// Colours of the plate, premultiplied, by its uv. With `parallax` a picture is read where the ray meets its plane
/// moved to the height that its depth has where the ray meets the plane through the centre: one step towards where the
/// ray meets the object. A view that the ray does not come down on counts as empty.
///   views    those of weight 0 are not looked at; the pictures must outlive the shader
///   target   whose kernels read the pictures; the same bits by all
/// Where the weighted alpha is at least one half the result is opaque, its colour divided by that alpha; 0 elsewhere.
[[nodiscard]] raster::Shader blended_views(const PlateRays& plate, const std::array<WeightedView, 3>& views,
                                           bool parallax, raster::Target target = raster::Target::best);

}  // namespace lode::techniques
