#pragma once
/// An explanation together with what its numbers mean in the scene.

#include "experiments/scene_options.h"
#include "raster/explain.h"
#include "techniques/scene_draws.h"

namespace lode::experiments {

struct ExplainedScene {
  const SceneView& view;
  techniques::ColorSpace color_space;
  const raster::PixelExplanation& explanation;
  std::size_t sample = 0;  ///< the one that text tells in full
};

/// "shown", "alpha-failed", …: for programs.
[[nodiscard]] const char* fate_name(raster::Fate fate);

/// The view distance at which the camera's depth is this; infinite at depth 0 with an infinite far plane.
[[nodiscard]] double view_distance(const geometry::Camera& camera, double depth);

/// The name of the instance's node, or of its material, or "".
[[nodiscard]] std::string draw_name(const geometry::Scene& scene, std::uint32_t draw);

/// Lines for people.
[[nodiscard]] std::string explanation_text(const ExplainedScene& explained);

/// One JSON object and a line break, with all samples and pieces.
[[nodiscard]] std::string explanation_json(const ExplainedScene& explained);

}  // namespace lode::experiments
