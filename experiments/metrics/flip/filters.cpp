#include "experiments/metrics/flip/filters.h"

#include <cmath>
#include <stdexcept>
#include <string>

#include "geometry/exponential.h"
#include "geometry/trigonometry.h"

namespace lode::experiments::flip {
namespace {

constexpr double kLog2E = 0x1.71547652b82fep+0;
constexpr double kPi2 = geometry::kPi * geometry::kPi;
constexpr float kFeatureWidth_deg = 0.082f;  // w: of what is a feature

double exponential(double x) { return geometry::exp2_of(x * kLog2E); }

/// One term of a contrast sensitivity function: a·√(π/b)·e^(−π²x²/b), x in degrees (table 1 of the paper).
struct Term {
  double a, b;
};
constexpr Term kAchromatic{1.0, 0.0047}, kRedGreen{1.0, 0.0053}, kBlueYellow1{34.1, 0.04}, kBlueYellow2{13.5, 0.025};

/// The square root of the term's factor at each tap: rows and columns have one each.
std::vector<double> sampled(const Term& term, int radius, double ppd) {
  const double factor = std::sqrt(term.a * std::sqrt(geometry::kPi / term.b));
  std::vector<double> row;
  for (int k = -radius; k <= radius; ++k) {
    const double x_deg = k / ppd;
    row.push_back(factor * exponential(-kPi2 * (x_deg * x_deg) / term.b));
  }
  return row;
}

double sum_of(const std::vector<double>& row) {
  double sum = 0.0;
  for (const double w : row) sum += w;
  return sum;
}

void scale(std::vector<double>& row, double factor) {
  for (double& w : row) w *= factor;
}

/// Positive weights are made to sum to 1, negative ones to −1.
void normalize_by_sign(std::vector<float>& row) {
  float positive = 0.0f, negative = 0.0f;
  for (const float w : row) (w > 0.0f ? positive : negative) += std::fabs(w);
  for (float& w : row) w /= w > 0.0f ? positive : negative;
}

void add_contrast_sensitivity(Filters& filters, double ppd) {
  filters.achromatic = sampled(kAchromatic, filters.radius, ppd);
  filters.red_green = sampled(kRedGreen, filters.radius, ppd);
  filters.blue_yellow_1 = sampled(kBlueYellow1, filters.radius, ppd);
  filters.blue_yellow_2 = sampled(kBlueYellow2, filters.radius, ppd);
  scale(filters.achromatic, 1.0 / sum_of(filters.achromatic));
  scale(filters.red_green, 1.0 / sum_of(filters.red_green));
  // The two products of a row and a column are made to sum to 1 together.
  const double sum_1 = sum_of(filters.blue_yellow_1), sum_2 = sum_of(filters.blue_yellow_2);
  const double both = 1.0 / std::sqrt(sum_1 * sum_1 + sum_2 * sum_2);
  scale(filters.blue_yellow_1, both);
  scale(filters.blue_yellow_2, both);
}

/// In the program's order of operations: see flip.h.
void add_features(Filters& filters, float ppd) {
  const float sigma = 0.5f * kFeatureWidth_deg * ppd;
  const int radius = int(std::ceil(3.0f * sigma));
  float sum = 0.0f;
  for (int k = -filters.radius; k <= filters.radius; ++k) {
    const float x = float(k);
    const float g = std::abs(k) <= radius ? float(exponential(double{-(x * x) / (2.0f * sigma * sigma)})) : 0.0f;
    filters.gaussian.push_back(g);
    filters.edge.push_back(-x * g);
    filters.point.push_back((x * x / (sigma * sigma) - 1.0f) * g);
    sum += g;
  }
  for (float& g : filters.gaussian) g /= sum;
  normalize_by_sign(filters.edge);
  normalize_by_sign(filters.point);
}

}  // namespace

Filters make_filters(double pixels_per_degree) {
  if (!(pixels_per_degree >= 1.0 && pixels_per_degree <= 1000.0)) {
    throw std::logic_error("FLIP: expected pixels per degree in [1, 1000], found " + std::to_string(pixels_per_degree));
  }
  // Three standard deviations of the widest contrast sensitivity, 0.045°; those of features are a little less, 0.041°.
  Filters filters;
  filters.radius = int(std::ceil(3.0 * std::sqrt(kBlueYellow1.b / (2.0 * kPi2)) * pixels_per_degree));
  add_contrast_sensitivity(filters, pixels_per_degree);
  add_features(filters, float(pixels_per_degree));
  return filters;
}

}  // namespace lode::experiments::flip
