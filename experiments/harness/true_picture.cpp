#include "experiments/harness/true_picture.h"

#include <array>
#include <cstring>
#include <stdexcept>

#include "experiments/harness/view_key.h"

namespace lode::experiments {
namespace {

std::string key_of(std::string_view look, const techniques::View& view) {
  return "true picture 2; contract " + std::to_string(raster::kPixelContract) + "; look " + std::string(look) +
         "; samples " + std::to_string(kTrueSamplesPerAxis) + "; " + view_key(view);
}

std::array<glm::ivec2, std::size_t(kTrueSamplesPerAxis) * kTrueSamplesPerAxis> samples() {
  std::array<glm::ivec2, std::size_t(kTrueSamplesPerAxis) * kTrueSamplesPerAxis> places_fx8;
  constexpr int kStep_fx8 = 256 / kTrueSamplesPerAxis;
  for (std::size_t k = 0; k < places_fx8.size(); ++k) {
    const glm::ivec2 cell(int(k) % kTrueSamplesPerAxis, int(k) / kTrueSamplesPerAxis);
    places_fx8[k] = cell * kStep_fx8 + kStep_fx8 / 2;
  }
  return places_fx8;
}

TruePicture drawn(const techniques::World& world, const techniques::View& view, raster::RenderOptions options) {
  options.skips = {};
  options.memory = nullptr;
  const auto places = samples();
  const std::vector<raster::Draw> draws = world.draws().draws(view.camera, view.size_px);
  raster::Image image =
      raster::make_image(view.size_px, raster::ColorFormat::rgba32f, {.color = true, .depth = false, .ids = false});
  static_cast<void>(
      raster::render({.draws = draws, .clear = glm::vec4(0.0f), .viewport = {}, .scissor = {}, .samples_fx8 = places},
                     image, options));
  return {image.rgba32f.begin(), image.rgba32f.end()};
}

}  // namespace

TruePicture true_picture(const techniques::World& world, std::string_view look, const techniques::View& view,
                         const raster::RenderOptions& options, const KeptResults& kept) {
  if (world.color_space() == techniques::ColorSpace::raw) throw std::logic_error("true_picture: raw colours");
  TruePicture picture;
  const std::string bytes = kept.get(key_of(look, view), [&] {
    picture = drawn(world, view, options);
    return std::string(reinterpret_cast<const char*>(picture.data()), picture.size() * sizeof(glm::vec4));
  });
  picture.resize(bytes.size() / sizeof(glm::vec4));
  std::memcpy(picture.data(), bytes.data(), picture.size() * sizeof(glm::vec4));
  return picture;
}

}  // namespace lode::experiments
