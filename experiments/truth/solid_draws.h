#pragma once
/// The part of a scene's draws that both sides of a check can draw alike: its triangles, as solid ones.

#include <cstdint>
#include <span>
#include <vector>

#include "experiments/truth/camera_rays.h"
#include "geometry/scene.h"
#include "raster/frame.h"

namespace lode::experiments::truth {

/// Draws that are not compared.
struct LeftOut {
  std::uint64_t blended = 0, lines = 0, points = 0;
};

struct SolidDraws {
  std::vector<raster::Draw> draws;            ///< with the ids of the scene's instances; no material, no alpha test
  std::vector<glm::dmat4> world_from_object;  ///< [draws]
  LeftOut left_out;

  [[nodiscard]] std::vector<TracedDraw> traced() const;
};

/// `draws` are the scene's, one an instance (techniques/scene_draws.h). Blended ones are left out, alpha-tested ones
/// count as solid.
[[nodiscard]] SolidDraws solid_draws(const geometry::Scene& scene, std::span<const raster::Draw> draws);

}  // namespace lode::experiments::truth
