#include "techniques/masked_occlusion/masked_depth.h"

#include <algorithm>

namespace lode::techniques {
namespace {

/// Bits of the samples [first, last] of a subtile, both within it.
std::uint32_t rectangle(glm::ivec2 first, glm::ivec2 last) {
  const std::uint32_t columns = (0xFFu >> (7 - last.x)) & (0xFFu << first.x);
  const std::uint32_t rows = (0xFFFFFFFFu >> (8 * (3 - last.y))) & (0xFFFFFFFFu << (8 * first.y));
  return (columns * 0x01010101u) & rows;
}

}  // namespace

void MaskedDepth::begin(glm::ivec2 size_px) {
  n_subtiles_ = {(size_px.x + kSubtileWidth_px - 1) / kSubtileWidth_px,
                 (size_px.y + kSubtileHeight_px - 1) / kSubtileHeight_px};
  subtiles_.assign(std::size_t(n_subtiles_.x) * std::size_t(n_subtiles_.y), Subtile{});
}

/// In contrast to the paper, which asks the reference alone, a box that touches only samples of the mask may be hidden
/// by the working layer.
bool MaskedDepth::hides(const ScreenBox& box, std::uint64_t& n_read) const {
  if (box.empty()) return true;
  const glm::ivec2 side(kSubtileWidth_px, kSubtileHeight_px);
  const glm::ivec2 first = box.first_px / side, last = box.last_px / side;
  for (int y = first.y; y <= last.y; ++y) {
    const Subtile* const row = subtiles_.data() + std::size_t(y) * std::size_t(n_subtiles_.x);
    for (int x = first.x; x <= last.x; ++x) {
      ++n_read;
      if (box.nearest < row[x].reference) continue;  // strictly: at a tie the lower id wins
      if (row[x].mask == 0 || !(box.nearest < row[x].working)) return false;
      const glm::ivec2 begin_px = glm::ivec2(x, y) * side;
      const std::uint32_t touched =
          rectangle(glm::max(box.first_px - begin_px, 0), glm::min(box.last_px - begin_px, side - 1));
      if ((touched & ~row[x].mask) != 0) return false;
    }
  }
  return true;
}

float MaskedDepth::bound_at(glm::ivec2 p_px) const {
  const int x = p_px.x / kSubtileWidth_px, y = p_px.y / kSubtileHeight_px;
  const Subtile& s = subtiles_[std::size_t(y) * std::size_t(n_subtiles_.x) + std::size_t(x)];
  const int bit = 8 * (p_px.y % kSubtileHeight_px) + p_px.x % kSubtileWidth_px;
  return (s.mask >> bit & 1u) != 0 ? s.working : s.reference;
}

}  // namespace lode::techniques
