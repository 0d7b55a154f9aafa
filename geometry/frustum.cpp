#include "geometry/frustum.h"

#include <cmath>
#include <glm/common.hpp>

namespace lode::geometry {

Frustum frustum(const glm::dmat4& m) {
  const auto row = [&](int i) { return glm::dvec4(m[0][i], m[1][i], m[2][i], m[3][i]); };
  const glm::dvec4 x = row(0), y = row(1), z = row(2), w = row(3);
  const glm::dvec4 ax = glm::abs(x), ay = glm::abs(y), az = glm::abs(z), aw = glm::abs(w);
  return {{w + x, w - x, w + y, w - y, w - z, z}, {aw + ax, aw + ax, aw + ay, aw + ay, aw + az, az}};
}

bool is_outside(const Frustum& frustum, const Bounds& box) {
  if (box.empty()) return true;
  for (std::size_t k = 0; k < frustum.planes.size(); ++k) {
    const glm::dvec4 &plane = frustum.planes[k], &magnitude = frustum.magnitudes[k];
    double sum = plane.w, bound = magnitude.w;  // at the corner that is farthest inside
    for (int i = 0; i < 3; ++i) {
      sum += plane[i] * (plane[i] > 0.0 ? box.high[i] : box.low[i]);
      bound += magnitude[i] * std::fmax(std::fabs(box.low[i]), std::fabs(box.high[i]));
    }
    if (sum + 0x1p-48 * bound < 0.0) return true;
  }
  return false;
}

}  // namespace lode::geometry
