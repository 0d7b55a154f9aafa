#pragma once
/// glTF 2.0 files, .gltf and .glb: the specification of Khronos, "glTF 2.0", ISO/IEC 12113:2022, cited by section.

#include <string>

#include "geometry/scene.h"

namespace lode::geometry {

/// Meshes come in the order in which nodes first use them, materials in the file's. Throws Error, see model_file.h.
[[nodiscard]] Scene read_gltf(const std::string& path);

}  // namespace lode::geometry
