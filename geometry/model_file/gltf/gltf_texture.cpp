#include "geometry/model_file/gltf/gltf_texture.h"

#include <string>
#include <utility>

#include "geometry/model_file/gltf/uri.h"

namespace lode::geometry {
namespace {

// OpenGL's numbers for filters and wrapping, glTF 2.0, sec. 5.26.
constexpr std::int64_t kNearest = 9728, kLinear = 9729, kNearestMipmapNearest = 9984, kLinearMipmapLinear = 9987,
                       kRepeat = 10497, kClampToEdge = 33071, kMirroredRepeat = 33648;

TextureWrap read_wrap(const JsonView& sampler, std::string_view key) {
  const auto view = sampler.find(key);
  if (!view) return TextureWrap::repeat;
  switch (view->integer(kRepeat, kMirroredRepeat)) {
    case kRepeat:
      return TextureWrap::repeat;
    case kClampToEdge:
      return TextureWrap::clamp;
    case kMirroredRepeat:
      return TextureWrap::mirror;
    default:
      view->fail_expected("10497 (repeat), 33071 (clamp) or 33648 (mirror)");
  }
}

/// One filter for both: whoever asks for unfiltered texels near by gets them everywhere; else the filter for
/// minification decides, and any that blends mip levels or texels with mips is trilinear.
TextureFilter read_filter(const JsonView& sampler) {
  const auto mag = sampler.find("magFilter"), min = sampler.find("minFilter");
  if (mag && mag->integer(kNearest, kLinear) == kNearest) return TextureFilter::nearest;
  if (!min) return TextureFilter::trilinear;
  const std::int64_t filter = min->integer(kNearest, kLinearMipmapLinear);
  if (filter > kLinear && filter < kNearestMipmapNearest) min->fail_expected("9728, 9729 or 9984 to 9987");
  if (filter == kLinear) return TextureFilter::bilinear;
  return filter == kNearest || filter == kNearestMipmapNearest ? TextureFilter::nearest : TextureFilter::trilinear;
}

constexpr std::uint32_t kUnused = 0xFFFFFFFFu;

}  // namespace

GltfTextures::GltfTextures(GltfDocument& document)
    : document_(document), picture_of_(document.count("images"), kUnused) {}

TextureUse GltfTextures::use(const JsonView& reference) {
  const JsonView texture = document_.target(reference, "textures");
  TextureUse use;
  if (const auto sampler_reference = texture.find("sampler")) {
    const JsonView sampler = document_.target(*sampler_reference, "samplers");
    use.wrap_u = read_wrap(sampler, "wrapS");
    use.wrap_v = read_wrap(sampler, "wrapT");
    use.filter = read_filter(sampler);
  }
  const auto source = texture.find("source");
  if (!source) texture.fail("expected \"source\": a PNG or JPEG image");
  std::uint32_t& picture = picture_of_[source->index(picture_of_.size(), "images")];
  if (picture == kUnused) {
    picture = std::uint32_t(images_.size());
    images_.push_back(std::size_t(&picture - picture_of_.data()));
  }
  use.picture = picture;
  return use;
}

std::vector<Picture> GltfTextures::read_pictures() {
  std::vector<Picture> pictures;
  for (const std::size_t image : images_) pictures.push_back(read_image(document_.element("images", image)));
  return pictures;
}

Picture GltfTextures::read_image(const JsonView& view) {
  ModelFiles& files = document_.files();
  if (const auto reference = view.find("bufferView")) {
    return decode_picture(document_.buffer_view(*reference).bytes, view.place(), files.budget);
  }
  const JsonView uri = view.require("uri");
  if (is_data_uri(uri.string())) {
    files.budget.take(uri.string().size(), uri.place());
    const auto bytes = data_uri_bytes(uri.string());
    if (!bytes) uri.fail("expected base64 after \"data:...;base64,\"");
    return decode_picture(*bytes, uri.place(), files.budget);
  }
  if (has_scheme(uri.string())) uri.fail_expected("a file beside this one, or \"data:\"");
  return files.read_picture(ModelFiles::resolved(files.model_path(), percent_decoded(uri.string())), uri.place());
}

}  // namespace lode::geometry
