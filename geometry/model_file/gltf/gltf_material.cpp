#include "geometry/model_file/gltf/gltf_material.h"

#include <cfloat>
#include <string>

#include "geometry/trigonometry.h"

namespace lode::geometry {
namespace {

/// [x, y], any finite numbers.
glm::dvec2 read_pair(const JsonView& view) {
  if (view.size("[x, y]") != 2) view.fail_expected("[x, y]");
  return {view.at(0).number(-DBL_MAX, DBL_MAX), view.at(1).number(-DBL_MAX, DBL_MAX)};
}

glm::vec4 read_factor(const JsonView& view) {
  if (view.size("[r, g, b, a]") != 4) view.fail_expected("[r, g, b, a]");
  glm::vec4 factor;
  for (int c = 0; c < 4; ++c) factor[c] = view.at(std::size_t(c)).float_number();
  return factor;
}

/// KHR_texture_transform: scaled, then rotated counter-clockwise in the picture, where v points down, then moved.
glm::dmat3x2 read_transform(const JsonView& view) {
  const auto offset_view = view.find("offset"), scale_view = view.find("scale"), angle_view = view.find("rotation");
  const glm::dvec2 offset = offset_view ? read_pair(*offset_view) : glm::dvec2(0.0);
  const glm::dvec2 scale = scale_view ? read_pair(*scale_view) : glm::dvec2(1.0);
  constexpr double kMaxAngle = 1048576.0;  // sin_cos's range
  const SinCos turn = sin_cos(angle_view ? angle_view->number(-kMaxAngle, kMaxAngle) : 0.0);
  return {turn.cos * scale.x, -turn.sin * scale.x, turn.sin * scale.y, turn.cos * scale.y, offset.x, offset.y};
}

class MaterialReader {
 public:
  explicit MaterialReader(GltfTextures& textures) : textures_(textures) {}

  GltfMaterial read(const JsonView& view) {
    GltfMaterial result;
    Material& material = result.material;
    if (const auto name = view.find("name")) material.name = name->string();
    if (const auto pbr = view.find("pbrMetallicRoughness")) {
      if (const auto factor = pbr->find("baseColorFactor")) material.color = read_factor(*factor);
      if (const auto texture = pbr->find("baseColorTexture")) read_texture(*texture, result);
    }
    if (const auto extensions = view.find("extensions")) read_extensions(*extensions, result);
    if (const auto mode = view.find("alphaMode")) {
      constexpr AlphaMode kModes[] = {AlphaMode::opaque, AlphaMode::mask, AlphaMode::blend};
      material.alpha_mode = kModes[mode->choice({"OPAQUE", "MASK", "BLEND"})];
    }
    if (const auto cutoff = view.find("alphaCutoff")) material.alpha_cutoff = cutoff->number(0.0, DBL_MAX);
    if (const auto sides = view.find("doubleSided")) material.double_sided = sides->boolean();
    return result;
  }

 private:
  void read_texture(const JsonView& info, GltfMaterial& result) {
    constexpr std::int64_t kMaxSet = 1000;
    result.material.color_texture = textures_.use(info.require("index"));
    UvSource& uvs = result.uvs.emplace();
    if (const auto set = info.find("texCoord")) uvs.set = std::size_t(set->integer(0, kMaxSet));
    const auto extensions = info.find("extensions");
    if (!extensions) return;
    const auto transform = extensions->find("KHR_texture_transform");
    if (!transform) return;
    uvs.uv_from_set = read_transform(*transform);
    if (const auto set = transform->find("texCoord")) uvs.set = std::size_t(set->integer(0, kMaxSet));
  }

  void read_extensions(const JsonView& extensions, GltfMaterial& result) {
    Material& material = result.material;
    material.unlit = extensions.find("KHR_materials_unlit").has_value();
    // The older model of reflection; its diffuse colour stands where the base colour does.
    const auto glossy = extensions.find("KHR_materials_pbrSpecularGlossiness");
    if (!glossy) return;
    const auto factor = glossy->find("diffuseFactor");
    material.color = factor ? read_factor(*factor) : glm::vec4(1.0f);
    material.color_texture.reset();
    result.uvs.reset();
    if (const auto texture = glossy->find("diffuseTexture")) read_texture(*texture, result);
  }

  GltfTextures& textures_;
};

}  // namespace

std::vector<GltfMaterial> read_materials(GltfDocument& document, GltfTextures& textures) {
  std::vector<GltfMaterial> materials;
  MaterialReader reader(textures);
  for (std::size_t i = 0; i < document.count("materials"); ++i) {
    materials.push_back(reader.read(document.element("materials", i)));
  }
  return materials;
}

}  // namespace lode::geometry
