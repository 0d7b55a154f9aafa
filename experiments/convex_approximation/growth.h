#pragma once
/// How the work of approximating grows with a model's polygons. Onozawa & Kitazawa, sec. 2.4: O(n log² n) on average.

#include "experiments/experiment.h"

namespace lode::experiments {

/// Approximates tori of 1 k to 64 k polygons, or to 1 M in the full size, with the limits of 6 and 13 % of the
/// vertices.
///   results.results, results.times   a row for each, "torus 1k" …
///   results.summary                  one row, of the model kGrowth: polygons of the largest; exponent, the slope of
///                                    log seconds over log polygons (least squares); exponent_n_log2_n, that of n log²
///                                    n over the same polygons; hulls_percent, the share of the time spent in hulls
void add_growth(const ExperimentRun& run, ExperimentResults& results);
inline constexpr const char* kGrowth = "growth";

}  // namespace lode::experiments
