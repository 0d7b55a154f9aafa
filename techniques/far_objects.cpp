#include "techniques/far_objects.h"

#include <algorithm>
#include <glm/common.hpp>
#include <glm/geometric.hpp>
#include <glm/vec4.hpp>

namespace lode::techniques {
namespace {

constexpr int kMostSide_px = 16384;  ///< of a picture

}  // namespace

bool FarRule::is_far(const View& view, const geometry::Bounds& box) const {
  return glm::distance(box.centre(), view.camera.eye) >= std::max(distance, radii * 0.5 * box.diagonal());
}

bool worth_capturing(const View& view, const raster::Rect& window_px) {
  const glm::ivec2& size_px = window_px.size_px;
  return std::max(size_px.x, size_px.y) <= kMostSide_px &&
         std::int64_t(size_px.x) * size_px.y <= std::int64_t(view.size_px.x) * view.size_px.y;
}

std::uint64_t captured_bytes(glm::ivec2 size_px) {
  std::uint64_t n = std::uint64_t(size_px.x) * std::uint64_t(size_px.y) * sizeof(float);
  for (glm::ivec2 level = size_px;; level = glm::max(level / 2, glm::ivec2(1))) {
    n += std::uint64_t(level.x) * std::uint64_t(level.y) * sizeof(glm::vec4);
    if (level == glm::ivec2(1)) return n;
  }
}

}  // namespace lode::techniques
