#pragma once
/// The laboratory's scenes as built-in ones: furniture, the town and the interior of occlusion culling, and what is
/// assembled from kits of models.

#include <vector>

#include "experiments/scenes/builtin_scene.h"

namespace lode::experiments {

[[nodiscard]] std::vector<BuiltinScene> laboratory_scenes();

}  // namespace lode::experiments
