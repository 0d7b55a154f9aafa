#pragma once
/// FLIP's filters, each a product of a row and a column (Andersson et al. 2020, sec. 4.1.1 and 4.2), in the separated
/// form of NVIDIA's FLIP 1.2 and later.
///
/// All rows have one odd length, the short ones with zeros at both ends, so that all filtered pictures have one size.

#include <vector>

namespace lode::experiments::flip {

struct Filters {
  int radius = 0;  ///< of every row below, which has 2·radius + 1 weights

  // The eye's contrast sensitivity, by channel. Blue-yellow is a sum of two.
  std::vector<double> achromatic, red_green, blue_yellow_1, blue_yellow_2;

  // Features: a Gaussian, its first derivative (edges) and its second (points). Single precision: see flip.h.
  std::vector<float> gaussian, edge, point;
};

/// For so many pixels per degree of sight, from 1 to 1000 (checked: std::logic_error).
[[nodiscard]] Filters make_filters(double pixels_per_degree);

}  // namespace lode::experiments::flip
