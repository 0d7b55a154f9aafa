#include "raster/reference/surfel_bounds.h"

#include <algorithm>
#include <array>
#include <cmath>

#include "raster/reference/primitive.h"

namespace lode::raster::reference {
namespace {

/// Half the side of the disc's box along axis i is r·√(1 − nᵢ²/|n|²), here not less than that. Squares of
/// floats neither overflow nor vanish in double.
double half_extent(const SurfelInput& s, int i) {
  const double a = s.normal[(i + 1) % 3], b = s.normal[(i + 2) % 3], c = s.normal[i];
  const double across = a * a + b * b;
  return s.radius * std::sqrt(across / (across + c * c)) * (1.0 + 0x1p-40);
}

/// A row of clip_from_object at a point.
Bounded row_at(const std::array<Bounded, 4>& row, const glm::dvec3& p) {
  return row[0] * Bounded{p.x} + row[1] * Bounded{p.y} + row[2] * Bounded{p.z} + row[3];
}

/// centre + half · a/w for w > 2·(its error), as an interval that contains the exact value.
struct Interval {
  double low, high;
};
Interval window_interval(double centre, double half, const Bounded& a, const Bounded& w) {
  const double ratio = a.value / w.value;
  const double ratio_error = 2.0 * ((a.error + std::abs(ratio) * w.error) / w.value) + 0x1p-50 * std::abs(ratio);
  const double middle = centre + half * ratio;
  const double error = std::abs(half) * ratio_error * (1.0 + 0x1p-50) + 0x1p-50 * (std::abs(centre) + std::abs(middle));
  return {middle - error, middle + error};
}

}  // namespace

int matrix_exponent(const glm::dmat4& m) {
  double largest = 0.0;
  for (int i = 0; i < 4; ++i) {
    for (int j = 0; j < 4; ++j) largest = std::max(largest, std::abs(m[i][j]));
  }
  return largest == 0.0 ? 0 : std::ilogb(largest);
}

std::optional<WindowBox> surfel_bounds(const SurfelInput& s) {
  const int exponent = matrix_exponent(s.clip_from_object);
  std::array<std::array<Bounded, 4>, 4> rows;
  for (int i = 0; i < 4; ++i) {
    for (int j = 0; j < 4; ++j) rows[std::size_t(i)][std::size_t(j)] = scaled(s.clip_from_object[j][i], -exponent);
  }
  std::array<glm::dvec3, 2> ends;  // lower and upper corner, each rounded outwards
  for (int i = 0; i < 3; ++i) {
    const double half = half_extent(s, i);
    const double rounding = 0x1p-51 * (std::abs(s.centre[i]) + half);
    ends[0][i] = (s.centre[i] - half) - rounding;
    ends[1][i] = (s.centre[i] + half) + rounding;
  }

  const glm::dvec2 half_fx8 = 128.0 * glm::dvec2(s.viewport_size_px);
  const glm::dvec2 centre_fx8 = 256.0 * glm::dvec2(s.viewport_origin_px) + half_fx8;
  const double guard = double(kGuard_fx8);
  glm::dvec2 low{guard}, high{-guard};
  bool all_behind = true, all_too_near = true, all_too_far = true, whole = false;
  for (unsigned corner = 0; corner < 8; ++corner) {
    const glm::dvec3 p{ends[corner & 1u].x, ends[(corner >> 1) & 1u].y, ends[corner >> 2].z};
    const Bounded x = row_at(rows[0], p), y = row_at(rows[1], p), z = row_at(rows[2], p), w = row_at(rows[3], p);
    all_behind = all_behind && surely_negative(w);
    all_too_near = all_too_near && surely_negative(w - z);
    all_too_far = all_too_far && surely_negative(z);
    if (!(w.value > 2.0 * w.error)) {
      whole = true;
      continue;
    }
    const Interval window_x = window_interval(centre_fx8.x, half_fx8.x, x, w);
    const Interval window_y = window_interval(centre_fx8.y, -half_fx8.y, y, w);
    // A NaN fails these comparisons.
    whole = whole || !(window_x.low <= window_x.high) || !(window_y.low <= window_y.high);
    low = {std::min(low.x, window_x.low), std::min(low.y, window_y.low)};
    high = {std::max(high.x, window_x.high), std::max(high.y, window_y.high)};
  }
  if (all_behind || all_too_near || all_too_far) return std::nullopt;
  if (whole) return WindowBox{glm::ivec2(-kGuard_fx8), glm::ivec2(kGuard_fx8)};
  // In front of the eye a convex body projects into the hull of its corners. Clamped before the cast.
  low = glm::max(low, glm::dvec2(-guard));
  high = glm::min(high, glm::dvec2(guard));
  if (!(low.x <= high.x && low.y <= high.y)) return std::nullopt;
  return WindowBox{glm::ivec2(glm::floor(low)), glm::ivec2(glm::ceil(high))};
}

}  // namespace lode::raster::reference
