#pragma once
/// A scene's geometry as a short text: what was found out about one scene is never taken for another's.

#include <string>

#include "geometry/scene.h"

namespace lode::experiments {

/// SHA-256 over what decides which object owns a sample: positions, indices, kinds, instances, objects, sides and alpha
/// modes, and of masked materials all that their alpha depends on.
[[nodiscard]] std::string hash_of(const geometry::Scene& scene);

/// SHA-256 over that and over what decides its colour: normals, texture coordinates, colours, materials, pictures.
[[nodiscard]] std::string look_hash_of(const geometry::Scene& scene);

}  // namespace lode::experiments
