#pragma once
/// The z pyramid (Greene, Kass, Miller 1993, sec. 3.2): each texel of a level holds the farthest depth of the four
/// below it, so that one look tells whether a region is nearer than something everywhere.

#include <cstdint>
#include <span>
#include <vector>

#include "techniques/screen_box.h"

namespace lode::techniques {

/// Level 0 is a picture's depth plane, borrowed; level k has texels of 2^k × 2^k pixels, the last ones of what is left.
class DepthPyramid {
 public:
  /// Memory is kept from one call to the next. O(pixels).
  ///   depth     [size_px.x · size_px.y] 1 near, 0 far; must stay as long as the pyramid is asked
  ///   finest    ≥ 0; the level at which a question that is still open is answered with no
  void build(std::span<const float> depth, glm::ivec2 size_px, int finest);

  /// Whether every pixel of the box is strictly nearer than the box's nearest depth, as far as the finest level tells:
  /// at level 0 exactly, above it `false` too where a texel's farthest pixel lies beside the box. A box without pixels
  /// is hidden. `n_read` grows by the texels looked at.
  [[nodiscard]] bool hides(const ScreenBox& box, std::uint64_t& n_read) const;

  [[nodiscard]] int n_levels() const { return int(levels_.size()) + 1; }
  [[nodiscard]] glm::ivec2 size_of(int level) const;
  [[nodiscard]] float farthest(int level, glm::ivec2 texel) const;

 private:
  struct Level {
    glm::ivec2 size{0, 0};
    std::vector<float> farthest;  ///< [size.x · size.y]
  };
  [[nodiscard]] bool hides(const ScreenBox& box, int level, glm::ivec2 texel, std::uint64_t& n_read) const;

  std::span<const float> depth_;
  glm::ivec2 size_px_{0, 0};
  int finest_ = 0;
  std::vector<Level> levels_;  ///< from level 1 on
  std::vector<float> row_;
};

}  // namespace lode::techniques
