#pragma once
/// How far a triangle is at most in a part of the picture.

#include <algorithm>
#include <cmath>
#include <glm/vec2.hpp>

#include "techniques/masked_occlusion/screen_triangle.h"

namespace lode::techniques {

/// A depth that the triangle's fragments do not fall below.
///
/// The plane is z₀ + a·(x − x₀) + b·(y − y₀). Where its gradient is a quotient of sums, each sum loses at most 2^-51 of
/// its terms; over the triangle's box that is at most `lost_`. The renderer's depth is within 2^-50 of the plane's, and
/// both are rounded to float alike.
class DepthPlane {
 public:
  DepthPlane(const ScreenTriangle& t, double area) : z0_(t.z[0]), p0_(t.p_fx8[0]) {
    const glm::dvec2 u(t.p_fx8[1] - t.p_fx8[0]), v(t.p_fx8[2] - t.p_fx8[0]);
    const double du = t.z[1] - t.z[0], dv = t.z[2] - t.z[0];
    a_ = (du * v.y - dv * u.y) / area;
    b_ = (dv * u.x - du * v.x) / area;
    const glm::dvec2 size = glm::max(glm::abs(u), glm::abs(v)) + glm::abs(u - v);
    farthest_ = std::min({t.z[0], t.z[1], t.z[2]});
    const double nearest = std::max({t.z[0], t.z[1], t.z[2]});
    lost_ = 0x1p-48 * (4.0 * (nearest - farthest_) * (size.x * size.y / std::abs(area)) + nearest);
  }

  /// Over the samples [first, last].
  [[nodiscard]] float farthest_in(glm::ivec2 first, glm::ivec2 last) const {
    const double x = 256.0 * (a_ > 0.0 ? first.x : last.x) + 128.0 - p0_.x;
    const double y = 256.0 * (b_ > 0.0 ? first.y : last.y) + 128.0 - p0_.y;
    return float(std::max((z0_ + (a_ * x + b_ * y)) - lost_, farthest_));
  }

 private:
  double z0_, a_, b_, farthest_, lost_;
  glm::dvec2 p0_;
};

}  // namespace lode::techniques
