#pragma once
/// Textures, samplers and images of a glTF file: glTF 2.0, sec. 3.8.

#include <cstddef>
#include <cstdint>
#include <vector>

#include "geometry/material.h"
#include "geometry/model_file/gltf/gltf_document.h"

namespace lode::geometry {

/// Gives pictures their numbers when textures are first used, and decodes them when all else is known to be right.
class GltfTextures {
 public:
  explicit GltfTextures(GltfDocument& document);

  /// The texture that a reference leads to.
  [[nodiscard]] TextureUse use(const JsonView& reference);

  /// The pictures of all textures in use, in the order of their first use.
  [[nodiscard]] std::vector<Picture> read_pictures();

 private:
  Picture read_image(const JsonView& view);

  GltfDocument& document_;
  std::vector<std::size_t> images_;        ///< [pictures]: which of the file's "images" each is
  std::vector<std::uint32_t> picture_of_;  ///< [images]: which picture; kUnused: none
};

}  // namespace lode::geometry
