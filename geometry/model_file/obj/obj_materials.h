#pragma once
/// The materials that an OBJ file uses: names become Materials of the scene when they are first used. Only their
/// pictures are read, when all else is known to be right.

#include <cstdint>
#include <map>
#include <optional>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include "geometry/model_file/obj/mtl_file.h"
#include "geometry/scene.h"

namespace lode::geometry {

/// How a material's texture coordinates are made of the file's, whose v points up.
struct ObjUvs {
  glm::dvec2 offset{0.0}, scale{1.0};
  [[nodiscard]] glm::vec2 operator()(const glm::vec2& uv) const {
    return {float(double(uv.x) * scale.x + offset.x), float(1.0 - (double(uv.y) * scale.y + offset.y))};
  }
};

class ObjMaterials {
 public:
  ObjMaterials(ModelFiles& files, Scene& scene) : files_(files), scene_(scene) {}

  /// Adds what an MTL file has; of two materials of one name, the later is used.
  void add_library(const std::string& path, const std::string& referrer);

  /// The scene's material of this name; "" is the default one. A name that no library has is an error, unless there is
  /// no library at all: then it is a default material of that name. `place` is what errors begin with.
  [[nodiscard]] std::uint32_t use(const std::string& name, const std::string& place);

  /// Reads the pictures of the materials in use into the scene.
  void read_pictures();

  [[nodiscard]] const ObjUvs& uvs(std::uint32_t material) const { return uvs_[material]; }

 private:
  /// A picture of the scene: colours, white if there are none, with an opacity.
  struct PictureSource {
    std::optional<MtlMap> colors, opacity;
  };

  Material made(const MtlMaterial& from, ObjUvs& uvs);
  std::uint32_t picture(const PictureSource& source);
  Picture read_picture(const PictureSource& source);

  ModelFiles& files_;
  Scene& scene_;
  bool has_library_ = false;
  std::map<std::string, MtlMaterial> library_;
  std::map<std::string, std::uint32_t> used_;
  std::vector<ObjUvs> uvs_;  ///< of each used material
  std::vector<PictureSource> pictures_;
  std::map<std::pair<std::string, std::string>, std::uint32_t> picture_of_paths_;  ///< of colours and opacity
};

}  // namespace lode::geometry
