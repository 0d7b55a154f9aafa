#include "techniques/hierarchical_z/depth_pyramid.h"

#include <algorithm>

namespace lode::techniques {
namespace {

/// Halves a level, up to the last odd row and column.
void halve(std::span<const float> fine, glm::ivec2 size, std::vector<float>& row, std::span<float> coarse) {
  const auto n = std::size_t(size.x), n_half = (n + 1) / 2;
  row.resize(n);
  for (int y = 0; y < size.y; y += 2) {
    const float* const above = fine.data() + std::size_t(y) * n;
    const float* const below = y + 1 < size.y ? above + n : above;
    for (std::size_t x = 0; x < n; ++x) row[x] = std::min(above[x], below[x]);
    float* const out = coarse.data() + std::size_t(y / 2) * n_half;
    for (std::size_t x = 0; x < n / 2; ++x) out[x] = std::min(row[2 * x], row[2 * x + 1]);
    if (n % 2 == 1) out[n_half - 1] = row[n - 1];
  }
}

/// Whether the rectangle's part in this level is at most 2 × 2 texels.
bool spans_two(const ScreenBox& box, int level) {
  return (box.last_px.x >> level) - (box.first_px.x >> level) < 2 &&
         (box.last_px.y >> level) - (box.first_px.y >> level) < 2;
}

}  // namespace

void DepthPyramid::build(std::span<const float> depth, glm::ivec2 size_px, int finest) {
  depth_ = depth;
  size_px_ = size_px;
  std::size_t n = 0;
  std::span<const float> fine = depth;
  for (glm::ivec2 size = size_px; size.x > 1 || size.y > 1;) {
    const glm::ivec2 half((size.x + 1) / 2, (size.y + 1) / 2);
    if (n == levels_.size()) levels_.emplace_back();
    Level& level = levels_[n++];
    level.size = half;
    level.farthest.resize(std::size_t(half.x) * std::size_t(half.y));
    halve(fine, size, row_, level.farthest);
    fine = level.farthest;
    size = half;
  }
  levels_.resize(n);
  finest_ = std::min(finest, int(n));
}

glm::ivec2 DepthPyramid::size_of(int level) const {
  return level == 0 ? size_px_ : levels_[std::size_t(level - 1)].size;
}

float DepthPyramid::farthest(int level, glm::ivec2 texel) const {
  const std::span<const float> texels = level == 0 ? depth_ : levels_[std::size_t(level - 1)].farthest;
  return texels[std::size_t(texel.y) * std::size_t(size_of(level).x) + std::size_t(texel.x)];
}

bool DepthPyramid::hides(const ScreenBox& box, std::uint64_t& n_read) const {
  if (box.empty()) return true;
  int level = finest_;
  while (!spans_two(box, level)) ++level;  // the last level is one texel
  for (int y = box.first_px.y >> level; y <= box.last_px.y >> level; ++y) {
    for (int x = box.first_px.x >> level; x <= box.last_px.x >> level; ++x) {
      if (!hides(box, level, {x, y}, n_read)) return false;
    }
  }
  return true;
}

/// What is open in a texel that the box covers wholly is open in its farthest pixel, and that one is the box's.
bool DepthPyramid::hides(const ScreenBox& box, int level, glm::ivec2 texel, std::uint64_t& n_read) const {
  ++n_read;
  if (box.nearest < farthest(level, texel)) return true;  // strictly: at a tie the lower id wins
  if (level <= finest_) return false;
  const glm::ivec2 begin_px(texel.x << level, texel.y << level);
  const glm::ivec2 last_px = glm::min(begin_px + glm::ivec2((1 << level) - 1), size_px_ - 1);
  const bool whole = begin_px.x >= box.first_px.x && last_px.x <= box.last_px.x &&  //
                     begin_px.y >= box.first_px.y && last_px.y <= box.last_px.y;
  if (whole) return false;
  const int fine = level - 1;
  for (int k = 0; k < 4; ++k) {
    const glm::ivec2 child(2 * texel.x + (k & 1), 2 * texel.y + (k >> 1));
    const bool beside = child.x < box.first_px.x >> fine || child.x > box.last_px.x >> fine ||
                        child.y < box.first_px.y >> fine || child.y > box.last_px.y >> fine;
    if (!beside && !hides(box, fine, child, n_read)) return false;
  }
  return true;
}

}  // namespace lode::techniques
