#include "experiments/metrics/flip/color_difference.h"

#include <cmath>
#include <glm/common.hpp>
#include <glm/mat3x3.hpp>

#include "geometry/exponential.h"

namespace lode::experiments::flip {
namespace {

constexpr double kColorExponent = 0.7;     // q_c
constexpr double kSplitOfLargest = 0.4;    // p_c
constexpr double kSplitDifference = 0.95;  // p_t

// Relative to the white point, so that (1, 1, 1) is white in all three spaces. In rows.
constexpr double kWhiteX = 23359437.0 / 24577794.0, kWhiteZ = 80288307.0 / 73733382.0;
constexpr double kXyzFromLinear[3][3] = {{10135552.0 / 23359437.0, 8788810.0 / 23359437.0, 4435075.0 / 23359437.0},
                                         {2613072.0 / 12288897.0, 8788810.0 / 12288897.0, 887015.0 / 12288897.0},
                                         {1425312.0 / 80288307.0, 8788810.0 / 80288307.0, 70074185.0 / 80288307.0}};
constexpr double kLinearFromXyz[3][3] = {
    {3.2410032329763587 * kWhiteX, -1.5373989694887855, -0.4986158819963629 * kWhiteZ},
    {-0.9692242522025166 * kWhiteX, 1.875929983695176, 0.041554226340084724 * kWhiteZ},
    {0.055639419851975444 * kWhiteX, -0.20401120612390997, 1.0571489771875335 * kWhiteZ}};

glm::dvec3 product(const double (&m)[3][3], const glm::dvec3& v) {
  const auto row = [&](int i) { return m[i][0] * v.x + m[i][1] * v.y + m[i][2] * v.z; };
  return {row(0), row(1), row(2)};
}

/// CIE's f(t): the cube root, a line near 0.
double lightness_of(double t) {
  constexpr double kDelta = 6.0 / 29.0;
  if (t > kDelta * kDelta * kDelta) return geometry::power(t, 1.0 / 3.0);
  return t / (3.0 * kDelta * kDelta) + 4.0 / 29.0;
}

/// L*, a*, b* of a linear colour, chroma scaled by lightness (Hunt's effect).
glm::dvec3 hunt_adjusted_lab(const glm::dvec3& linear) {
  const glm::dvec3 xyz = product(kXyzFromLinear, linear);
  const double x = lightness_of(xyz.x), y = lightness_of(xyz.y), z = lightness_of(xyz.z);
  const double l = 116.0 * y - 16.0;
  return {l, 0.01 * l * (500.0 * (x - y)), 0.01 * l * (200.0 * (y - z))};
}

glm::dvec3 linear_from_ycxcz(const glm::dvec3& c) {
  const double y = (c.x + 16.0) / 116.0;
  return product(kLinearFromXyz, {y + c.y / 500.0, y, y - c.z / 200.0});
}

/// HyAB: city-block in lightness, Euclidean in chroma.
double hyab(const glm::dvec3& p, const glm::dvec3& q) {
  const double a = p.y - q.y, b = p.z - q.z;
  return std::fabs(p.x - q.x) + std::sqrt(a * a + b * b);
}

double largest_difference() {
  const double distance = hyab(hunt_adjusted_lab({0.0, 1.0, 0.0}), hunt_adjusted_lab({0.0, 0.0, 1.0}));
  return geometry::power(distance, kColorExponent);
}

}  // namespace

glm::dvec3 ycxcz_from_linear(const glm::dvec3& linear) {
  const glm::dvec3 xyz = product(kXyzFromLinear, linear);
  return {116.0 * xyz.y - 16.0, 500.0 * (xyz.x - xyz.y), 200.0 * (xyz.y - xyz.z)};
}

double color_difference(const glm::dvec3& reference, const glm::dvec3& test) {
  static const double largest = largest_difference();
  const glm::dvec3 p = glm::clamp(linear_from_ycxcz(reference), 0.0, 1.0);
  const glm::dvec3 q = glm::clamp(linear_from_ycxcz(test), 0.0, 1.0);
  if (p == q) return 0.0;
  const double difference = geometry::power(hyab(hunt_adjusted_lab(p), hunt_adjusted_lab(q)), kColorExponent);
  const double split = kSplitOfLargest * largest;
  if (difference < split) return difference * (kSplitDifference / split);
  return kSplitDifference + (difference - split) / (largest - split) * (1.0 - kSplitDifference);
}

}  // namespace lode::experiments::flip
