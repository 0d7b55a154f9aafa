#pragma once
/// A scene's geometry as a short text: what was found out about one scene is never taken for another's.

#include <string>

#include "geometry/scene.h"

namespace lode::experiments {

/// SHA-256 over positions, indices, kinds, instances, objects and alpha modes. Colours and textures are not in it, but
/// for alpha-tested materials' pictures.
[[nodiscard]] std::string hash_of(const geometry::Scene& scene);

}  // namespace lode::experiments
