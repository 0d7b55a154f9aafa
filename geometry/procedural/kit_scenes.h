#pragma once
/// Scenes assembled from real models: KayKit's "City Builder Bits", "Dungeon Remastered" and "Furniture Bits" by Kay
/// Lousberg, and the furniture of Blend Swap, from folders that hold them. Metres, y up, one object a placed model;
/// each has a first-person path and free space. Each throws Error (bad_input), naming the file, if one that it uses is
/// not there or cannot be read.

#include <cstdint>
#include <string>

#include "geometry/scene.h"

namespace lode::geometry {

/// Streets of 10 m tiles around 4 × 4 blocks of eight houses, with cars and street furniture: about 400 objects.
/// Paths: "street", 600 frames, with two turns. `folder` holds building_A.gltf and so on.
[[nodiscard]] Scene kit_city(const std::string& folder, std::uint64_t seed);

/// Ten rooms on either side of a corridor: floor, walls with doorways, ceiling, what stands in them: about 450 objects.
/// Path: "rooms", 600 frames, from the first room through doorways to the last. `folder` holds wall.gltf.glb and so on.
[[nodiscard]] Scene kit_dungeon(const std::string& folder, std::uint64_t seed);

/// The flat of interior.h with its walls, furnished from the kit `folder` (couch.gltf and so on) and with the scanned
/// furniture in the folders of `furniture_folder` (oakTable/oakTable.obj and so on). Path: "rooms", 600 frames.
[[nodiscard]] Scene kit_rooms(const std::string& folder, const std::string& furniture_folder, std::uint64_t seed);

}  // namespace lode::geometry
