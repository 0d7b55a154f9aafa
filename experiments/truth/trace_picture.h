#pragma once
/// A scene's picture by ray tracing: the same planes as the rasterizer's, by the same materials.
///
/// At each sample the nearest solid surface wins (at equal depth the lower ids), alpha-tested ones where they pass;
/// blended ones that are strictly nearer are then composited over it in the order of the draws. Lines and points have
/// no area that a ray could meet, and are left out.

#include <functional>
#include <glm/vec2.hpp>
#include <glm/vec4.hpp>
#include <span>

#include "experiments/truth/camera_rays.h"
#include "raster/image.h"
#include "techniques/scene_draws.h"

namespace lode::experiments::truth {

struct PictureRequest {
  glm::ivec2 size_px{0, 0};
  std::span<const glm::ivec2> samples_fx8;  ///< positions in a pixel; their colours are averaged
  glm::vec4 clear{0.0f};                    ///< in the target's unit
  raster::ColorFormat format = raster::ColorFormat::rgba32f;
  raster::Planes planes;  ///< depth and ids only with one sample
};

/// `on_row`, if given, is called for each row done, from any thread. Throws raster::Error, geometry::Error (machine).
[[nodiscard]] raster::Image trace_picture(const techniques::SceneDraws& draws, const geometry::Camera& camera,
                                          const geometry::Bounds& bounds, const PictureRequest& request, int threads,
                                          const std::function<void()>& on_row = {});

}  // namespace lode::experiments::truth
