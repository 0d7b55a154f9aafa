#pragma once
/// Model files to scenes: the one door. The format goes by the file's ending:
///
///   .gltf .glb   glTF 2.0: scene graph, cameras, vertex colours, textures, alpha modes, unlit, double-sided
///   .obj         Wavefront OBJ with MTL
///   .ply         ASCII and binary, both byte orders
///   .stl         ASCII and binary
///
/// A file that is damaged, hostile or not of its format is one Error (bad_input) that names file, place and mend;
/// memory stays below eight times the bytes read plus 1 GiB. Nothing outside the folder of the file is read unless the
/// file names it. Pure: the same bytes give the same scene.

#include <string>

#include "geometry/scene.h"

namespace lode::geometry {

/// Whether the ending is one of the above, upper or lower case.
[[nodiscard]] bool is_model_file(const std::string& path);

[[nodiscard]] Scene read_model_file(const std::string& path);

}  // namespace lode::geometry
