#include "experiments/display_bytes.h"

#include "raster/srgb.h"

namespace lode::experiments {

std::vector<glm::u8vec4> display_bytes(std::span<const glm::vec4> linear) {
  std::vector<glm::u8vec4> bytes;
  bytes.reserve(linear.size());
  for (const glm::vec4& c : linear) bytes.push_back(raster::srgb8_from_linear(c));
  return bytes;
}

}  // namespace lode::experiments
