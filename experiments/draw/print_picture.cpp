#include "experiments/draw/print_picture.h"

#include <string_view>

namespace lode::experiments {

std::string printed_picture(glm::ivec2 size_px, std::span<const raster::Ids> ids) {
  constexpr std::string_view kLetters = "ABCDEFGHIJKLMNOPQRSTUVWXYZabcdefghijklmnopqrstuvwxyz";
  if (size_px.x == 0) return "";
  std::string text;
  text.reserve(std::size_t(size_px.x + 1) * std::size_t(size_px.y));
  for (std::size_t i = 0; i < ids.size(); ++i) {
    text += ids[i].draw == raster::kNoId ? '.' : kLetters[ids[i].draw % kLetters.size()];
    if ((i + 1) % std::size_t(size_px.x) == 0) text += '\n';
  }
  return text;
}

}  // namespace lode::experiments
