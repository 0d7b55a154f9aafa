#pragma once
/// A plot in gnuplot's language: ranges, a logarithmic axis with a place for 0, labels that do not lie on each other.

#include <string>

#include "experiments/report/gnuplot.h"

namespace lode::experiments {

/// A script that writes the plot to standard output as SVG. Pure.
[[nodiscard]] std::string plot_script(const Plot& plot);

}  // namespace lode::experiments
