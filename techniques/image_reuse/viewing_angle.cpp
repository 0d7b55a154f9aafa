#include "techniques/image_reuse/viewing_angle.h"

#include <cmath>
#include <glm/geometric.hpp>

#include "geometry/trigonometry.h"

namespace lode::techniques {
namespace {

constexpr double kNoAngle = 5.0;  ///< 4 is that of 180°

double squared_length(const glm::dvec3& v) { return (v.x * v.x + v.y * v.y) + v.z * v.z; }

}  // namespace

glm::dvec3 viewing_direction(const glm::dvec3& centre, const glm::dvec3& eye, AngleRule rule) {
  const glm::dvec3 full = eye - centre, yaw(full.x, 0.0, full.z);
  const glm::dvec3& towards = rule == AngleRule::yaw && squared_length(yaw) > 0.0 ? yaw : full;
  const double length = std::sqrt(squared_length(towards));
  return length > 0.0 ? towards / length : glm::dvec3(0.0);
}

double angle_measure(const glm::dvec3& a, const glm::dvec3& b) {
  if (!(squared_length(a) > 0.0 && squared_length(b) > 0.0)) return kNoAngle;
  return squared_length(a - b);
}

double angle_measure(double angle_deg) {
  const double half_chord = 2.0 * geometry::sin_cos(angle_deg * (geometry::kPi / 360.0)).sin;
  return half_chord * half_chord;
}

}  // namespace lode::techniques
