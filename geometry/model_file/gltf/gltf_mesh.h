#pragma once
/// Mesh primitives of a glTF file: glTF 2.0, sec. 3.7.2.

#include <optional>
#include <vector>

#include "geometry/mesh.h"
#include "geometry/model_file/gltf/gltf_document.h"
#include "geometry/model_file/gltf/gltf_material.h"

namespace lode::geometry {

/// One element of a mesh's "primitives". Strips, loops and fans become lists in the order of sec. 3.7.2.1. One without
/// positions draws nothing (sec. 3.7.2.1) and is an empty mesh, so that those after it keep their draw ids. Triangles
/// that are lit and have no normals get flat ones.
[[nodiscard]] Mesh read_primitive(GltfDocument& document, const JsonView& view,
                                  const std::vector<GltfMaterial>& materials);

}  // namespace lode::geometry
