#include "techniques/screen_box.h"

#include <algorithm>
#include <cmath>

namespace lode::techniques {
namespace {

constexpr double kLost = 0x1p-36;    ///< of the terms' magnitude
constexpr double kLeastW = 0x1p-20;  ///< of its terms' magnitude: what w has lost then moves no corner by half a pixel
constexpr double kGuard_px = 32000.0;  ///< inside the renderer's guard band of 32768 px, by more than a pixel
constexpr double kWider_px = 1.0;

/// Row · (p, 1), and the magnitude of its terms.
struct Sum {
  double value, magnitude;
};
Sum row_at(const glm::dmat4& m, int row, const glm::dvec3& p) {
  const double a = m[0][row] * p.x, b = m[1][row] * p.y, c = m[2][row] * p.z, d = m[3][row];
  return {((a + b) + c) + d, ((std::abs(a) + std::abs(b)) + std::abs(c)) + std::abs(d)};
}

glm::dvec3 corner(const geometry::Bounds& box, int k) {
  return {k & 1 ? box.high.x : box.low.x, k & 2 ? box.high.y : box.low.y, k & 4 ? box.high.z : box.low.z};
}

}  // namespace

std::optional<ScreenBox> whole_screen_box(const glm::dmat4& clip_from_world, glm::ivec2 size_px,
                                          const geometry::Bounds& box) {
  if (box.empty()) return ScreenBox{};
  const glm::dvec2 half_px = 0.5 * glm::dvec2(size_px);
  glm::dvec2 low_px(kGuard_px), high_px(-kGuard_px);
  double nearest = 0.0;
  for (int k = 0; k < 8; ++k) {
    const glm::dvec3 p = corner(box, k);
    const Sum x = row_at(clip_from_world, 0, p), y = row_at(clip_from_world, 1, p);
    const Sum z = row_at(clip_from_world, 2, p), w = row_at(clip_from_world, 3, p);
    const double greatest_z = z.value + kLost * z.magnitude, least_w = w.value - kLost * w.magnitude;
    // Also if anything is NaN. Depth 1 and beyond is the near plane, where the renderer cuts.
    if (!(w.value > kLeastW * w.magnitude && greatest_z < least_w)) return std::nullopt;
    const glm::dvec2 p_px(half_px.x + half_px.x * (x.value / w.value), half_px.y - half_px.y * (y.value / w.value));
    if (!(std::abs(p_px.x) < kGuard_px && std::abs(p_px.y) < kGuard_px)) return std::nullopt;
    low_px = glm::min(low_px, p_px);
    high_px = glm::max(high_px, p_px);
    nearest = std::max(nearest, greatest_z / least_w);
  }
  ScreenBox result;
  // Pixels whose centres lie in between.
  result.first_px = glm::ivec2(glm::ceil(low_px - kWider_px - 0.5));
  result.last_px = glm::ivec2(glm::floor(high_px + kWider_px - 0.5));
  // The renderer rounds depths to float as this does, and rounding keeps the order.
  result.nearest = float(std::min(nearest, 1.0));
  return result;
}

std::optional<ScreenBox> screen_box(const glm::dmat4& clip_from_world, glm::ivec2 size_px,
                                    const geometry::Bounds& box) {
  std::optional<ScreenBox> seen = whole_screen_box(clip_from_world, size_px, box);
  if (!seen) return seen;
  seen->first_px = glm::max(seen->first_px, glm::ivec2(0));
  seen->last_px = glm::min(seen->last_px, size_px - 1);
  return seen;
}

}  // namespace lode::techniques
