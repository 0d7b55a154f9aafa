// Depth as a plane: the quick way to the bits of C5, and the exact way where it cannot tell.
// Compiled once for each instruction set (Highway's re-included headers).

#include <algorithm>
#include <cstdint>

#include "raster/fast/kernels.h"

#if defined(LODE_RASTER_FAST_PLANE_INL_H_) == defined(HWY_TARGET_TOGGLE)
#ifdef LODE_RASTER_FAST_PLANE_INL_H_
#undef LODE_RASTER_FAST_PLANE_INL_H_
#else
#define LODE_RASTER_FAST_PLANE_INL_H_
#endif

#include <utility>

#include "raster/fast/lanes-inl.h"

HWY_BEFORE_NAMESPACE();
namespace lode::raster::fast {
namespace HWY_NAMESPACE {

/// The depth of C5, ((E₀·z₀ + E₁·z₁) + E₂·z₂) / ΣE clamped to the corners' range and rounded to float once, with E
/// exact and the corners in canonical order.
HWY_INLINE float ExactDepth(const std::int32_t (&x)[3], const std::int32_t (&y)[3], const double (&z)[3],
                            std::int32_t px, std::int32_t py) {
  int order[3] = {0, 1, 2};
  const auto sort_pair = [&](int i, int j) {
    const int a = order[i], b = order[j];
    if (x[b] < x[a] || (x[b] == x[a] && y[b] < y[a])) std::swap(order[i], order[j]);
  };
  sort_pair(0, 1);
  sort_pair(1, 2);
  sort_pair(0, 1);
  double e[3], area = 0.0, sum = 0.0;
  const auto doubled = [&](int a, int b) {
    return std::int64_t(x[b] - x[a]) * (py - y[a]) - std::int64_t(y[b] - y[a]) * (px - x[a]);
  };
  for (int k = 0; k < 3; ++k) {
    e[k] = double(doubled(order[(k + 1) % 3], order[(k + 2) % 3]));
    area += e[k];
  }
  const double sign = area < 0.0 ? -1.0 : 1.0;  // whole numbers below 2^53: exact
  for (int k = 0; k < 3; ++k) e[k] *= sign;
  sum = (e[0] * z[order[0]] + e[1] * z[order[1]]) + e[2] * z[order[2]];
  const double depth = sum / (area * sign);
  return float(std::clamp(depth, std::min({z[0], z[1], z[2]}), std::max({z[0], z[1], z[2]})));
}

/// A plane's depths are within `error` of the true ones, which lie in the corners' range, and the value of C5 before it
/// is rounded is nearer still: if both ends of the interval round to one float, that is the depth.
struct RoundedDepths {
  hn::Vec<HalfFloats> low, high;  ///< equal where the plane tells
};
HWY_INLINE RoundedDepths RoundBoth(hn::Vec<Doubles> z, hn::Vec<Doubles> error) {
  const HalfFloats f;
  return {hn::DemoteTo(f, hn::Sub(z, error)), hn::DemoteTo(f, hn::Add(z, error))};
}

/// Share of the sum of absolute terms that bounds a plane's error and C5's own: each is made of less than twenty
/// rounded operations on terms of which none is greater than that sum (depths are at most 1).
constexpr double kPlaneError = 0x1p-47;

}  // namespace HWY_NAMESPACE
}  // namespace lode::raster::fast
HWY_AFTER_NAMESPACE();

#endif  // per-target include guard
