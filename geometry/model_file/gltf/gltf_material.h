#pragma once
/// Materials, textures, samplers and images of a glTF file: glTF 2.0, sec. 3.8 and 3.9. Of a material what Material
/// holds; of its textures that of the base colour.

#include <cstddef>
#include <glm/mat3x2.hpp>
#include <optional>
#include <vector>

#include "geometry/model_file/gltf/gltf_document.h"
#include "geometry/model_file/gltf/gltf_texture.h"

namespace lode::geometry {

/// Where a material's texture coordinates come from.
struct UvSource {
  std::size_t set = 0;                      ///< of TEXCOORD_0, TEXCOORD_1, ...
  std::optional<glm::dmat3x2> uv_from_set;  ///< (u, v) = matrix · (s, t, 1), by KHR_texture_transform
};

/// A material, and where its texture coordinates come from if it has a texture.
struct GltfMaterial {
  Material material;
  std::optional<UvSource> uvs;
};

/// All materials, in the file's order.
[[nodiscard]] std::vector<GltfMaterial> read_materials(GltfDocument& document, GltfTextures& textures);

}  // namespace lode::geometry
