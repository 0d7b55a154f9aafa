#pragma once
/// The masked depth buffer: for each 8 × 4 samples two depths and a mask, in the place of 32 depths (Hasselgren,
/// Andersson, Akenine-Möller 2016). What it says about a sample is a bound, never nearer than the nearest
/// triangle drawn there.

#include <cstdint>
#include <glm/vec2.hpp>
#include <vector>

#include "techniques/screen_box.h"

namespace lode::techniques {

inline constexpr int kSubtileWidth_px = 8, kSubtileHeight_px = 4;

/// Depth is reversed, 1 near and 0 far, so that the paper's maxima are minima here.
class MaskedDepth {
 public:
  /// Forgets everything: all samples are at depth 0.
  ///   size_px   samples, each ≥ 0; the buffer is padded to whole subtiles
  void begin(glm::ivec2 size_px);

  [[nodiscard]] glm::ivec2 n_subtiles() const { return n_subtiles_; }

  /// Part of a triangle in one subtile.
  ///   coverage   bit 8·y + x: sample (x, y) of the subtile
  ///   farthest   ≤ the triangle's depth at each of these
  void add(glm::ivec2 subtile, std::uint32_t coverage, float farthest) {
    Subtile& s = subtiles_[std::size_t(subtile.y) * std::size_t(n_subtiles_.x) + std::size_t(subtile.x)];
    if (!(farthest > s.reference)) return;
    merge(s, coverage, farthest);
  }

  /// Whether all samples of the box are sure to be strictly nearer than its nearest depth. A box without samples is
  /// hidden. `n_read` grows by the subtiles looked at.
  [[nodiscard]] bool hides(const ScreenBox& box, std::uint64_t& n_read) const;

  /// What the buffer says about a sample: the greatest depth that it is sure of.
  [[nodiscard]] float bound_at(glm::ivec2 p_px) const;

 private:
  /// Every sample is at `reference` or nearer; those in the mask are at `working` or nearer. working > reference where
  /// the mask has a bit.
  struct Subtile {
    std::uint32_t mask = 0;
    float reference = 0.0f;
    float working = 0.0f;
  };
  /// The paper's update of a tile. In contrast to the paper a part that covers the whole subtile sets the reference at
  /// once and leaves what is nearer in the working layer, and a part behind the reference never enters: the reference
  /// can only come nearer.
  static void merge(Subtile& s, std::uint32_t coverage, float farthest) {
    if (coverage == ~0u) {
      s.reference = farthest;
      if (!(s.working > farthest)) s.mask = 0;
      return;
    }
    // A part that is farther from the working layer than that is from the reference starts the layer anew.
    if (s.mask != 0 && farthest - s.working > s.working - s.reference) s.mask = 0;
    s.working = s.mask == 0 ? farthest : (farthest < s.working ? farthest : s.working);
    s.mask |= coverage;
    if (s.mask != ~0u) return;
    s.reference = s.working;
    s.mask = 0;
  }

  glm::ivec2 n_subtiles_{0, 0};
  std::vector<Subtile> subtiles_;
};

}  // namespace lode::techniques
