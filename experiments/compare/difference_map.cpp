#include "experiments/compare/difference_map.h"

#include <cstdlib>

namespace lode::experiments {
namespace {

glm::u8 shown_difference(int difference) { return difference == 0 ? 0 : glm::u8(64 + difference * 191 / 255); }

}  // namespace

ColorPlane difference_map(const StoredPicture& a, const StoredPicture& b) {
  ColorPlane map(std::size_t(a.size_px.x) * std::size_t(a.size_px.y), {0, 0, 0, 255});
  for (std::size_t i = 0; i < map.size(); ++i) {
    if (const auto* color = std::get_if<ColorPlane>(&a.plane)) {
      const glm::u8vec4 p = (*color)[i], q = std::get<ColorPlane>(b.plane)[i];
      for (int c = 0; c < 3; ++c) map[i][c] = shown_difference(std::abs(int(p[c]) - int(q[c])));
    } else if (const auto* depth = std::get_if<DepthPlane>(&a.plane)) {
      if ((*depth)[i] != std::get<DepthPlane>(b.plane)[i]) map[i] = glm::u8vec4(255);
    } else if (std::get<IdPlane>(a.plane)[i] != std::get<IdPlane>(b.plane)[i]) {
      map[i] = glm::u8vec4(255);
    }
  }
  return map;
}

}  // namespace lode::experiments
