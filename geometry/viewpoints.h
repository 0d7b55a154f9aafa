#pragma once
/// Random places in a scene to look from.

#include <cstdint>
#include <vector>

#include "geometry/camera.h"
#include "geometry/scene.h"

namespace lode::geometry {

/// `n` cameras (walking_camera()) in the scene's free space, in any level direction, up or down by up to 14°.
/// Places are uniform over the volume of Scene::free_space's boxes. One within 0.2 units of the box of an object is not
/// taken (boxes are larger than objects: some free air is left out), unless that box holds the whole box of free space
/// (the walls around a room, the ground below a street). Camera k depends on the seed and k alone.
/// Throws Error (bad_input) if the scene has no free space, or none is found in 1000 tries.
[[nodiscard]] std::vector<Camera> random_viewpoints(const Scene& scene, std::uint64_t seed, int n);

}  // namespace lode::geometry
