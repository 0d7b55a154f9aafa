#include "geometry/model_file/obj/obj_materials.h"

#include <algorithm>

#include "geometry/error.h"
#include "geometry/shortened.h"

namespace lode::geometry {
namespace {

/// Luminance of display values, ITU-R BT.709's weights; rounded half up.
std::uint8_t luminance(const glm::u8vec4& c) {
  return std::uint8_t((2126 * c.r + 7152 * c.g + 722 * c.b + 5000) / 10000);
}

/// Gives each texel the opacity that the mask has at the same place (of the mask's texels the one that the texel's
/// centre lies in): the mask's alpha if it has any, else its luminance.
void set_opacity(Picture& picture, const Picture& mask) {
  const auto [w, h] = std::pair(picture.size_px.x, picture.size_px.y);
  const auto at = [](int i, int n, int n_mask) { return std::size_t((2 * std::int64_t(i) + 1) * n_mask / (2 * n)); };
  picture.has_alpha = false;
  for (int y = 0; y < h; ++y) {
    const std::size_t row = at(y, h, mask.size_px.y) * std::size_t(mask.size_px.x);
    for (int x = 0; x < w; ++x) {
      const glm::u8vec4& m = mask.texels[row + at(x, w, mask.size_px.x)];
      glm::u8vec4& texel = picture.texels[std::size_t(y) * std::size_t(w) + std::size_t(x)];
      texel.a = mask.has_alpha ? m.a : luminance(m);
      picture.has_alpha = picture.has_alpha || texel.a != 255;
    }
  }
}

}  // namespace

void ObjMaterials::add_library(const std::string& path, const std::string& referrer) {
  has_library_ = true;
  for (MtlMaterial& material : read_mtl(files_, path, referrer)) {
    std::string name = material.name;
    library_.insert_or_assign(std::move(name), std::move(material));
  }
}

std::uint32_t ObjMaterials::use(const std::string& name, const std::string& place) {
  const auto known = used_.find(name);
  if (known != used_.end()) return known->second;

  Material material;
  material.name = name;
  material.double_sided = true;
  ObjUvs uvs;
  const auto found = library_.find(name);
  if (found != library_.end()) {
    material = made(found->second, uvs);
  } else if (has_library_ && !name.empty()) {
    throw Error(ErrorKind::bad_input, place + ": no material library has \"" + shortened(name, 60) + "\"");
  }
  const auto index = std::uint32_t(scene_.materials.size());
  scene_.materials.push_back(std::move(material));
  uvs_.push_back(uvs);
  used_.emplace(name, index);
  return index;
}

Material ObjMaterials::made(const MtlMaterial& from, ObjUvs& uvs) {
  Material material;
  material.name = from.name;
  material.double_sided = true;
  material.color = glm::vec4(from.color, from.opacity);
  const std::optional<MtlMap>& opacity_map = from.opacity_map;
  if (const auto& map = from.color_map ? from.color_map : opacity_map) {
    if (opacity_map && (map->offset != opacity_map->offset || map->scale != opacity_map->scale)) {
      throw Error(ErrorKind::bad_input, opacity_map->place + ": other -o and -s than map_Kd: expected the same");
    }
    TextureUse use;
    use.picture = picture({from.color_map, opacity_map});
    use.wrap_u = use.wrap_v = map->clamp ? TextureWrap::clamp : TextureWrap::repeat;
    material.color_texture = use;
    uvs = {map->offset, map->scale};
  }
  if (from.opacity < 1.0f) {
    material.alpha_mode = AlphaMode::blend;
  } else if (opacity_map) {
    material.alpha_mode = AlphaMode::mask;
  }
  return material;
}

std::uint32_t ObjMaterials::picture(const PictureSource& source) {
  const auto path = [](const std::optional<MtlMap>& map) { return map ? map->path : std::string(); };
  const auto [entry, is_new] = picture_of_paths_.try_emplace(std::pair(path(source.colors), path(source.opacity)),
                                                             std::uint32_t(pictures_.size()));
  if (is_new) pictures_.push_back(source);
  return entry->second;
}

void ObjMaterials::read_pictures() {
  for (const PictureSource& source : pictures_) scene_.pictures.push_back(read_picture(source));
}

Picture ObjMaterials::read_picture(const PictureSource& source) {
  Picture picture;
  if (source.colors) picture = files_.read_picture(source.colors->path, source.colors->place);
  if (!source.opacity) return picture;

  const Picture mask = files_.read_picture(source.opacity->path, source.opacity->place);
  if (!source.colors) {
    files_.budget.take(mask.texels.size() * sizeof(glm::u8vec4), mask.name);
    picture = mask;
    std::fill(picture.texels.begin(), picture.texels.end(), glm::u8vec4(255));
  }
  set_opacity(picture, mask);
  files_.budget.give_back(mask.texels.size() * sizeof(glm::u8vec4));
  return picture;
}

}  // namespace lode::geometry
