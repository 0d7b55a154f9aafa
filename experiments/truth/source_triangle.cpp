#include "experiments/truth/source_triangle.h"

#include <algorithm>
#include <cmath>

namespace lode::experiments::truth {

ClipCorner clip_corner(const glm::dmat4& m, const glm::vec3& p_object) {
  const double x = p_object.x, y = p_object.y, z = p_object.z;
  ClipCorner corner;
  for (int row = 0; row < 4; ++row) {
    const double a = m[0][row] * x, b = m[1][row] * y, c = m[2][row] * z, d = m[3][row];
    corner.p[row] = ((a + b) + c) + d;
    // A component that is a sum of zeros and one term (w of an orthographic view, z of an infinite one) is exact.
    const bool one_term = (a != 0.0) + (b != 0.0) + (c != 0.0) == 0;
    corner.error[row] =
        one_term ? 0.0 : 5.0 * kRoundoff * (((std::abs(a) + std::abs(b)) + std::abs(c)) + std::abs(d)) + 0x1p-1000;
  }
  return corner;
}

ExactCorner exact_clip_corner(const glm::dmat4& m, const glm::vec3& p_object) {
  const Rational x(p_object.x), y(p_object.y), z(p_object.z);
  ExactCorner corner;
  for (int row = 0; row < 4; ++row) {
    corner[std::size_t(row)] =
        Rational(m[0][row]) * x + Rational(m[1][row]) * y + Rational(m[2][row]) * z + Rational(m[3][row]);
  }
  return corner;
}

namespace {

/// Of corners whose x, y and w are at most 1.
Facing facing_of_scaled(raster::Cull cull, const std::array<ClipCorner, 3>& corners) {
  const glm::dvec4 &a = corners[0].p, &b = corners[1].p, &c = corners[2].p;
  const double det = (a.x * (b.y * c.w - c.y * b.w) - a.y * (b.x * c.w - c.x * b.w)) + a.w * (b.x * c.y - c.x * b.y);
  // The sum of the six products' sizes, and the same with every factor as large as its error allows: the difference
  // bounds what the corners' errors move, 2^-48 of the sum every rounding of either evaluation.
  const auto size = [&](double errors) {
    glm::dvec4 p[3];
    for (int i = 0; i < 3; ++i) p[i] = glm::abs(corners[std::size_t(i)].p) + errors * corners[std::size_t(i)].error;
    return p[0].x * (p[1].y * p[2].w + p[2].y * p[1].w) + p[0].y * (p[1].x * p[2].w + p[2].x * p[1].w) +
           p[0].w * (p[1].x * p[2].y + p[2].x * p[1].y);
  };
  const double largest = size(1.0);
  const double bound = 2.0 * (largest - size(0.0)) + 0x1p-48 * largest + 0x1p-900;  // and what underflows
  if (!(std::abs(det) > bound)) return Facing::doubtful;                            // so is NaN
  const bool front = det > 0.0;
  return front == (cull == raster::Cull::back) ? Facing::kept : Facing::dropped;
}

}  // namespace

Facing facing(raster::Cull cull, const std::array<ClipCorner, 3>& corners) {
  if (cull == raster::Cull::none) return Facing::kept;
  // Each corner divided by a power of two of its own: exact, and of no matter to the sign. No product can overflow.
  std::array<ClipCorner, 3> scaled = corners;
  for (ClipCorner& c : scaled) {
    int exponent = 0;
    static_cast<void>(std::frexp(std::max({std::abs(c.p.x), std::abs(c.p.y), std::abs(c.p.w)}), &exponent));
    for (int i = 0; i < 4; ++i) {
      c.p[i] = std::ldexp(c.p[i], -exponent);
      c.error[i] = std::ldexp(c.error[i], -exponent);
    }
  }
  return facing_of_scaled(cull, scaled);
}

}  // namespace lode::experiments::truth
