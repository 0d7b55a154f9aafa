#include "techniques/predicted_reuse/relief.h"

#include <algorithm>
#include <glm/matrix.hpp>

namespace lode::techniques {
namespace {

/// A picture's grid while its relief is made.
class ReliefMaker {
 public:
  ReliefMaker(const CapturedPicture& picture, const glm::dvec3& centre, int cell_px)
      : picture_(picture),
        centre_(centre),
        cell_px_(cell_px),
        size_px_(picture.size_px()),
        n_cells_((size_px_ + cell_px - 1) / cell_px),
        world_from_clip_(glm::inverse(geometry::clip_from_world(picture.camera, picture.view_size_px))),
        vertex_of_(std::size_t(n_cells_.x + 1) * std::size_t(n_cells_.y + 1), kNone) {}

  PictureRelief make() {
    for (int j = 0; j < n_cells_.y; ++j) {
      for (int i = 0; i < n_cells_.x; ++i) add_cell({i, j});
    }
    return std::move(relief_);
  }

 private:
  static constexpr std::uint32_t kNone = 0xFFFFFFFFu;

  [[nodiscard]] float depth_at(int x, int y) const {
    return picture_.depth[std::size_t(y) * std::size_t(size_px_.x) + std::size_t(x)];
  }

  [[nodiscard]] bool covered(const glm::ivec2& cell) const {
    const glm::ivec2 begin = cell * cell_px_, end = glm::min(begin + cell_px_, size_px_);
    for (int y = begin.y; y < end.y; ++y) {
      for (int x = begin.x; x < end.x; ++x) {
        if (depth_at(x, y) > 0.0f) return true;
      }
    }
    return false;
  }

  void add_cell(const glm::ivec2& cell) {
    if (!covered(cell)) return;
    const std::uint32_t a = vertex(cell), b = vertex(cell + glm::ivec2(0, 1)), c = vertex(cell + glm::ivec2(1, 1)),
                        d = vertex(cell + glm::ivec2(1, 0));
    for (const std::uint32_t corner : {a, b, c, a, c, d}) relief_.indices.push_back(corner);
  }

  std::uint32_t vertex(const glm::ivec2& corner) {
    std::uint32_t& known = vertex_of_[std::size_t(corner.y) * std::size_t(n_cells_.x + 1) + std::size_t(corner.x)];
    if (known != kNone) return known;
    known = std::uint32_t(relief_.positions.size());
    const glm::ivec2 px = glm::min(corner * cell_px_, size_px_);
    const glm::dvec2 ndc = 2.0 * glm::dvec2(picture_.origin_px + px) / glm::dvec2(picture_.view_size_px) - 1.0;
    const glm::dvec4 p = world_from_clip_ * glm::dvec4(ndc.x, -ndc.y, double{closest_depth(px)}, 1.0);
    relief_.positions.push_back(glm::vec3(glm::dvec3(p) / p.w - centre_));
    relief_.uvs.push_back(glm::vec2(px) / glm::vec2(size_px_));
    return known;
  }

  /// Of the covered pixels around a corner the one whose centre is closest; of those at one distance the nearest to the
  /// eye.
  [[nodiscard]] float closest_depth(const glm::ivec2& px) const {
    const glm::ivec2 begin = glm::max(px - cell_px_, glm::ivec2(0)), end = glm::min(px + cell_px_, size_px_);
    int least = 8 * cell_px_ * cell_px_ + 1;
    float depth = 0.0f;
    for (int y = begin.y; y < end.y; ++y) {
      for (int x = begin.x; x < end.x; ++x) {
        const float here = depth_at(x, y);
        if (!(here > 0.0f)) continue;
        const int dx = 2 * (x - px.x) + 1, dy = 2 * (y - px.y) + 1, distance = dx * dx + dy * dy;
        if (distance > least || (distance == least && here <= depth)) continue;
        least = distance, depth = here;
      }
    }
    return depth;
  }

  const CapturedPicture& picture_;
  glm::dvec3 centre_;
  int cell_px_;
  glm::ivec2 size_px_, n_cells_;
  glm::dmat4 world_from_clip_;
  std::vector<std::uint32_t> vertex_of_;  ///< [corners of the grid]
  PictureRelief relief_;
};

}  // namespace

PictureRelief make_relief(const CapturedPicture& picture, const glm::dvec3& centre, int cell_px) {
  return ReliefMaker(picture, centre, cell_px).make();
}

std::uint64_t most_relief_bytes(glm::ivec2 size_px, int cell_px) {
  if (cell_px <= 0) return 0;
  const glm::ivec2 n = (size_px + cell_px - 1) / cell_px;
  const auto cells = std::uint64_t(n.x) * std::uint64_t(n.y), corners = std::uint64_t(n.x + 1) * std::uint64_t(n.y + 1);
  return corners * (sizeof(glm::vec3) + sizeof(glm::vec2)) + cells * 6 * sizeof(std::uint32_t);
}

}  // namespace lode::techniques
