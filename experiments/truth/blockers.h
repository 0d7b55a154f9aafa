#pragma once
/// For answers that may be wrong: is there a triangle that must have won instead? One that covers the sample however
/// its vertices are placed, at a depth that is nearer however they are placed.

#include <functional>
#include <glm/vec2.hpp>
#include <span>
#include <vector>

#include "experiments/truth/triangle_table.h"
#include "raster/image.h"

namespace lode::experiments::truth {

struct Answer {
  glm::ivec2 px{0, 0};
  raster::Ids ids{raster::kNoId, raster::kNoId};  ///< kNoId: nothing was drawn
  float depth = 0.0f;
};

/// Triangles that one step of the work takes.
inline constexpr std::size_t kTrianglesPerStep = 4096;
[[nodiscard]] std::size_t blocker_steps(const TriangleTable& table);

/// For each answer (in reading order, no pixel twice) the triangle of the lowest ids that must have won instead, or
/// kNoId. Triangles whose bounds hold no answer's pixel cost their projection only.
[[nodiscard]] std::vector<raster::Ids> find_blockers(const TriangleTable& table, glm::ivec2 size_px,
                                                     std::span<const Answer> answers, int threads,
                                                     const std::function<void()>& on_step);

}  // namespace lode::experiments::truth
