#pragma once
/// Nodes and cameras of a glTF file: glTF 2.0, sec. 3.5 and 3.10.

#include <cstdint>
#include <glm/mat4x4.hpp>
#include <vector>

#include "geometry/camera.h"
#include "geometry/model_file/gltf/gltf_document.h"

namespace lode::geometry {

/// A place in the scene that is read, and the node of the file that stands there.
struct PlacedNode {
  std::uint32_t node;    ///< index in the file's "nodes"
  std::uint32_t parent;  ///< index in the list that this is in; its own for a root
  glm::dmat4 parent_from_node;
  glm::dmat4 world_from_node;
};

/// The nodes of the default scene, else of the first, else all, depth first in document order. Throws Error (bad_input)
/// for cycles, nodes with two parents, and places that are not finite.
[[nodiscard]] std::vector<PlacedNode> placed_nodes(const GltfDocument& document);

/// The camera that a node's "camera" leads to, standing where the node does: its position, the direction of its −z, and
/// of its y so far as that is across; scale and shear are left out.
[[nodiscard]] Camera read_camera(const GltfDocument& document, const JsonView& reference,
                                 const glm::dmat4& world_from_node);

}  // namespace lode::geometry
