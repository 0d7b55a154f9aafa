#include "experiments/report/plot_script.h"

#include <algorithm>
#include <cmath>
#include <iterator>
#include <limits>

#include "experiments/parameter.h"

namespace lode::experiments {
namespace {

/// A text in gnuplot's double quotes, with nothing in it that it would take as markup.
std::string gnuplot_string(const std::string& text) {
  std::string result = "\"";
  for (const char c : text) {
    if (c == '"' || c == '\\') result += '\\';
    result += c == '\n' ? ' ' : c;
  }
  return result + "\"";
}

/// Colours that are seen on white and on black.
constexpr const char* kColors[] = {"#3b78d8", "#e07b00", "#1f9e77", "#d6336c",
                                   "#9a6ff0", "#00a3bf", "#8f8f00", "#b5651d"};

struct Range {
  double low = 0.0, high = 1.0;
  [[nodiscard]] double part(double v) const { return (v - low) / (high - low); }
};

/// Where a plot's values lie. Logarithms of y where the axis is logarithmic.
struct Frame {
  Range x, y;
  double zero = 0.0;  ///< where y = 0 lies, if the axis is logarithmic
};

Range widened(Range range, double below, double above) {
  if (!(range.high > range.low)) range = {range.low - 1.0, range.low + 1.0};
  const double size = range.high - range.low;
  return {range.low - below * size, range.high + above * size};
}

Frame frame_of(const Plot& plot) {
  const double far = std::numeric_limits<double>::max();
  Range x{far, -far}, y{far, -far};
  for (const PlotSeries& series : plot.series) {
    for (const double v : series.x) x = {std::min(x.low, v), std::max(x.high, v)};
    for (const double v : series.y) {
      if (!plot.log_y || v > 0.0) y = {std::min(y.low, v), std::max(y.high, v)};
    }
  }
  if (x.low > x.high) x = {};
  Frame frame{widened(x, 0.03, 0.03), {}, 0.0};
  if (!plot.log_y) {
    const bool labels = std::any_of(plot.series.begin(), plot.series.end(),
                                    [](const PlotSeries& series) { return !series.labels.empty(); });
    frame.y = widened({std::min(y.low, 0.0), std::max(y.high, 0.0)}, 0.0, labels ? 0.12 : 0.05);
    return frame;
  }
  if (y.low > y.high) y = {1e-3, 1.0};
  const double least = std::floor(std::log10(y.low));
  frame.zero = least - 1.0;
  frame.y = {least - 1.3, std::max(std::log10(y.high), least + 1.0) + 0.7};
  return frame;
}

double placed(const Plot& plot, const Frame& frame, double y) {
  if (!plot.log_y) return y;
  return y > 0.0 ? std::log10(y) : frame.zero;
}

/// A label above its points: where they are, and what the text covers, in px of the plot's inside, about.
struct Label {
  std::string text;
  double x, y;  ///< as the axes have them; the mean of the points' x
  double n_points = 1.0;
  double x_px, y_px;
  [[nodiscard]] double half_width_px() const { return 4.0 * double(text.size()); }
  [[nodiscard]] bool meets_beside(const Label& other) const {
    return std::abs(x_px - other.x_px) < half_width_px() + other.half_width_px();
  }
};
constexpr double kLine_px = 14.0;

/// Labels at one height that would lie on each other become one, "2 7", from left to right.
std::vector<Label> joined_labels(const Plot& plot, const Frame& frame) {
  std::vector<Label> labels, joined;
  for (const PlotSeries& series : plot.series) {
    for (std::size_t i = 0; i < series.labels.size(); ++i) {
      if (series.labels[i].empty()) continue;
      const double y = placed(plot, frame, series.y[i]);
      labels.push_back({.text = series.labels[i],
                        .x = series.x[i],
                        .y = y,
                        .x_px = frame.x.part(series.x[i]) * 0.9 * plot.width,
                        .y_px = frame.y.part(y) * 0.75 * plot.height + kLine_px});
    }
  }
  std::stable_sort(labels.begin(), labels.end(),
                   [](const Label& a, const Label& b) { return a.y != b.y ? a.y < b.y : a.x < b.x; });
  for (Label label : labels) {
    // What has become longer may reach the one before.
    while (!joined.empty() && joined.back().y == label.y && joined.back().meets_beside(label)) {
      const Label& before = joined.back();
      const double n = before.n_points + label.n_points;
      label.text = before.text + " " + label.text;
      label.x = (before.n_points * before.x + label.n_points * label.x) / n;
      label.x_px = (before.n_points * before.x_px + label.n_points * label.x_px) / n;
      label.n_points = n;
      joined.pop_back();
    }
    joined.push_back(std::move(label));
  }
  return joined;
}

/// Labels above their points, each as high as it must be to lie on no other.
std::string labels_of(const Plot& plot, const Frame& frame) {
  std::vector<Label> taken;
  std::string script;
  for (Label label : joined_labels(plot, frame)) {
    const auto meets = [&](const Label& other) {
      return label.meets_beside(other) && std::abs(label.y_px - other.y_px) < kLine_px;
    };
    double lines = 0.8;
    for (; std::any_of(taken.begin(), taken.end(), meets); lines += 1.0) label.y_px += kLine_px;
    script += "set label " + gnuplot_string(label.text) + " at " + number_text(label.x) + "," + number_text(label.y) +
              " center offset 0," + number_text(lines) + " font ',11' front\n";
    taken.push_back(std::move(label));
  }
  return script;
}

/// The decades of a logarithmic axis, and 0.
std::string decades(const Frame& frame) {
  std::string script = "set ytics (\"0\" " + number_text(frame.zero);
  for (double k = frame.zero + 1.0; k <= frame.y.high; k += 1.0) {
    script += ", " + gnuplot_string(number_text(std::stod("1e" + std::to_string(int(k))))) + " " + number_text(k);
  }
  return script + ")\nset arrow from graph 0, first " + number_text(frame.zero + 0.5) + " to graph 1, first " +
         number_text(frame.zero + 0.5) + " nohead lc rgb '#888888' dt 2\n";
}

}  // namespace

std::string plot_script(const Plot& plot) {
  const Frame frame = frame_of(plot);
  const auto range = [](const Range& r) { return "[" + number_text(r.low) + ":" + number_text(r.high) + "]"; };
  std::string s = "set terminal svg size " + std::to_string(plot.width) + "," + std::to_string(plot.height) +
                  " dynamic noenhanced font 'sans-serif,13'\n";
  s += "set xlabel " + gnuplot_string(plot.x_title) + "\nset ylabel " + gnuplot_string(plot.y_title) + "\n";
  s += "set key outside top center horizontal Left reverse\nset grid lc rgb '#888888'\nset border 3\n"
       "set tics nomirror\nset xrange " +
       range(frame.x) + "\nset yrange " + range(frame.y) + "\n" + labels_of(plot, frame);
  if (plot.log_y) s += decades(frame);
  for (std::size_t k = 0; k < plot.series.size(); ++k) {
    const PlotSeries& series = plot.series[k];
    s += "$d" + std::to_string(k) + " << EOD\n";
    for (std::size_t i = 0; i < series.x.size(); ++i) {
      s += number_text(series.x[i]) + " " + number_text(placed(plot, frame, series.y[i])) + "\n";
    }
    s += "EOD\n";
  }
  s += "plot ";
  for (std::size_t k = 0; k < plot.series.size(); ++k) {
    const PlotSeries& series = plot.series[k];
    const std::string color = " lc rgb '" + std::string(kColors[k % std::size(kColors)]) + "' lw 2";
    const std::string lines = series.ringed ? " with linespoints ps 1.7 pt 6" : " with lines";
    const std::string points = std::string(" with points ps 0.8 pt ") + (series.hollow ? "6" : "7");
    s += (k > 0 ? ", $d" : "$d") + std::to_string(k) + " using 1:2";
    s += (series.labels.empty() ? lines : points) + color + " title " + gnuplot_string(series.title);
  }
  return s + "\n";
}

}  // namespace lode::experiments
