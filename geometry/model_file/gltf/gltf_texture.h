#pragma once
/// Textures, samplers and images of a glTF file: glTF 2.0, sec. 3.8.

#include <cstdint>
#include <map>

#include "geometry/model_file/gltf/gltf_document.h"
#include "geometry/scene.h"

namespace lode::geometry {

/// Decodes images when they are first used.
class GltfTextures {
 public:
  GltfTextures(GltfDocument& document, Scene& scene) : document_(document), scene_(scene) {}

  /// The texture that a reference leads to; its picture is in the scene then.
  [[nodiscard]] TextureUse use(const JsonView& reference);

 private:
  std::uint32_t picture(const JsonView& reference);
  Picture read_image(const JsonView& view);

  GltfDocument& document_;
  Scene& scene_;
  std::map<std::size_t, std::uint32_t> pictures_;  ///< of images already read, by their index
};

}  // namespace lode::geometry
