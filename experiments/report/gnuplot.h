#pragma once
/// Plots: the one door to gnuplot, which is run as a program.

#include <span>
#include <string>
#include <vector>

namespace lode::experiments {

/// One series of points: a line, or points with a label each.
struct PlotSeries {
  std::string title;
  std::vector<double> x, y;              ///< [n]
  std::vector<std::string> labels = {};  ///< empty, or [n]: points are drawn instead of a line, "" without a label
  bool hollow = false;                   ///< of points
  bool ringed = false;                   ///< of a line: its points are ringed, so that one alone is seen, too
};

struct Plot {
  std::string x_title, y_title;
  bool log_y = false;  ///< y >= 0; zeros lie on a line of their own below the least decade, marked 0
  int width = 760, height = 380;
  std::vector<PlotSeries> series;
};

/// An SVG element for a page: no background, text in the page's colour; labels that would lie on another
/// are joined, or moved up. Deterministic for one version of gnuplot.
/// Throws Error (machine_failed) if gnuplot is not there or fails.
[[nodiscard]] std::string svg_of(const Plot& plot);

/// The same as a figure of a page, with a caption.
[[nodiscard]] std::string html_plot(const Plot& plot, const std::string& caption);

/// The points that no other point beats in both coordinates (least x, least y), by x: indices. Kung, Luccio, Preparata,
/// "On finding the maxima of a set of vectors", 1975.
[[nodiscard]] std::vector<std::size_t> pareto_front(std::span<const double> x, std::span<const double> y);

}  // namespace lode::experiments
