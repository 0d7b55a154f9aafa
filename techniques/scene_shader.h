#pragma once
/// How a scene's surfaces are shaded: Lambert under one fixed light with an ambient part, and the cut-out of masked
/// materials. Colours are premultiplied and in the target's unit; lit colours are
///
///   material · (ambient + (1 − ambient) · max(n·l, 0))
///
/// with the normal of the side that is seen. It is linear in an srgb picture and taken as it is in a raw one.

#include <glm/mat3x3.hpp>
#include <glm/mat4x4.hpp>
#include <glm/vec3.hpp>
#include <optional>

#include "raster/shader.h"

namespace lode::techniques {

/// The light stands still in the world, to the upper right behind someone who looks down −z: (3, 6, 4) / √61.
inline constexpr glm::vec3 kToLight{0.38411063f, 0.76822126f, 0.51214755f};
inline constexpr float kAmbient = 0.25f;

/// What shading an instance needs to know.
struct SceneSurface {
  bool lit = false;
  glm::mat3 world_from_normal{1.0f};  ///< takes object normals to directions in the world, of any length
  bool front_is_clockwise = false;    ///< a mirrored instance: its front is the renderer's back
  bool double_sided = false;          ///< the back is lit as if its normals pointed the other way

  /// Masked: raster::CutOut's.
  std::optional<double> alpha_cutoff;
  float full = 1.0f;  ///< 1 in the target's unit: 255 for rgba8
};

/// An empty shader (the material as it is) where the surface is neither lit nor masked.
[[nodiscard]] raster::Shader scene_shader(const SceneSurface& surface);

/// The inverse transpose of the transform's linear part, scaled so that its largest element is 1: normals stay
/// perpendicular, also where it stretches, and point outwards, also where it mirrors. Zero where it is not finite.
[[nodiscard]] glm::mat3 world_from_normal(const glm::dmat4& world_from_object);

}  // namespace lode::techniques
