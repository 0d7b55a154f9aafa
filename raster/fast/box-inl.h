// Boxes of space on the screen.
// Compiled once for each instruction set (Highway's re-included headers).

#include <algorithm>
#include <cmath>
#include <cstdint>

#include "raster/fast/kernels.h"

#if defined(LODE_RASTER_FAST_BOX_INL_H_) == defined(HWY_TARGET_TOGGLE)
#ifdef LODE_RASTER_FAST_BOX_INL_H_
#undef LODE_RASTER_FAST_BOX_INL_H_
#else
#define LODE_RASTER_FAST_BOX_INL_H_
#endif

#include "raster/fast/lanes-inl.h"

HWY_BEFORE_NAMESPACE();
namespace lode::raster::fast {
namespace HWY_NAMESPACE {

Projected Project(const DrawView& v, const glm::vec3& low, const glm::vec3& high) {
  const Doubles d;
  const auto* m = v.clip_from_object.data();
  alignas(64) double px[8], py[8], pz[8], x[8], y[8], z[8], w[8];
  for (int i = 0; i < 8; ++i) {
    px[i] = i & 1 ? high.x : low.x;
    py[i] = i & 2 ? high.y : low.y;
    pz[i] = i & 4 ? high.z : low.z;
  }
  double magnitude[4];
  const double ax = std::max(std::fabs(double(low.x)), std::fabs(double(high.x)));
  const double ay = std::max(std::fabs(double(low.y)), std::fabs(double(high.y)));
  const double az = std::max(std::fabs(double(low.z)), std::fabs(double(high.z)));
  double* const rows[4] = {x, y, z, w};
  for (int r = 0; r < 4; ++r) {
    const double a = m[4 * r], b = m[4 * r + 1], c = m[4 * r + 2], e = m[4 * r + 3];
    magnitude[r] = (std::fabs(a) * ax + std::fabs(b) * ay) + (std::fabs(c) * az + std::fabs(e));
    for (std::size_t i = 0; i < 8; i += hn::Lanes(d)) {
      const auto sum = hn::Add(
          hn::Add(hn::Add(hn::Mul(hn::Set(d, a), hn::Load(d, px + i)), hn::Mul(hn::Set(d, b), hn::Load(d, py + i))),
                  hn::Mul(hn::Set(d, c), hn::Load(d, pz + i))),
          hn::Set(d, e));
      hn::Store(sum, d, rows[r] + i);
    }
  }
  // Distances to the planes are sums of these; 2^-46 of the magnitudes is more than all their roundings.
  const double slack_w = 0x1p-46 * magnitude[3];
  const double slack_z = 0x1p-46 * (magnitude[3] + magnitude[2]);
  constexpr double kGuard = 1 << 23;
  Projected p;
  const auto all = [&](auto f) {
    double least = f(0), most = least;
    for (int i = 1; i < 8; ++i) {
      const double value = f(i);
      least = std::min(least, value);
      most = std::max(most, value);
    }
    return std::pair(least, most);
  };
  const auto near = all([&](int i) { return w[i] - z[i]; });
  const auto front = all([&](int i) { return w[i]; });
  const auto far = all([&](int i) { return z[i]; });
  if (near.second < -slack_z || front.second < -slack_w || far.second < -slack_z) {
    p.outside = true;
    return p;
  }
  const double slack_x = 0x1p-46 * (v.half_fx8.x * magnitude[0] + (std::fabs(v.centre_fx8.x) + kGuard) * magnitude[3]);
  const double slack_y = 0x1p-46 * (v.half_fx8.y * magnitude[1] + (std::fabs(v.centre_fx8.y) + kGuard) * magnitude[3]);
  const auto wx = [&](int i) { return v.half_fx8.x * x[i] + v.centre_fx8.x * w[i]; };
  const auto wy = [&](int i) { return v.centre_fx8.y * w[i] - v.half_fx8.y * y[i]; };
  p.clean = near.first > slack_z && front.first > slack_w && front.first > 0x1p-140 && far.first >= slack_z &&
            all([&](int i) { return wx(i) + kGuard * w[i]; }).first > slack_x &&
            all([&](int i) { return kGuard * w[i] - wx(i); }).first > slack_x &&
            all([&](int i) { return wy(i) + kGuard * w[i]; }).first > slack_y &&
            all([&](int i) { return kGuard * w[i] - wy(i); }).first > slack_y && magnitude[3] < 0x1p120;
  if (!p.clean) return p;
  double x0 = 1e30, x1 = -1e30, y0 = 1e30, y1 = -1e30, nearest = 0.0;
  for (int i = 0; i < 8; ++i) {
    const double inverse = 1.0 / w[i];
    const double sx = wx(i) * inverse, sy = wy(i) * inverse;
    x0 = std::min(x0, sx), x1 = std::max(x1, sx);
    y0 = std::min(y0, sy), y1 = std::max(y1, sy);
    nearest = std::max(nearest, z[i] * inverse);
  }
  // A sub-pixel for the snap, another for rounding; a pixel is covered if its sample (anywhere in it) is.
  p.begin_x = int(std::floor((x0 - 2.0) / 256.0)), p.end_x = int(std::floor((x1 + 2.0) / 256.0)) + 1;
  p.begin_y = int(std::floor((y0 - 2.0) / 256.0)), p.end_y = int(std::floor((y1 + 2.0) / 256.0)) + 1;
  p.nearest = float(std::min(1.0, nearest * (1.0 + 0x1p-20)));
  return p;
}

}  // namespace HWY_NAMESPACE
}  // namespace lode::raster::fast
HWY_AFTER_NAMESPACE();

#endif  // per-target include guard
