#include "experiments/convex_approximation/section.h"

#include <algorithm>
#include <array>
#include <charconv>
#include <cmath>
#include <iterator>

#include "experiments/convex_approximation/growth.h"
#include "experiments/report/gnuplot.h"
#include "experiments/report/html.h"

namespace lode::experiments {
namespace {

/// Onozawa & Kitazawa, Table 1.
struct PaperRow {
  const char* model;
  int level, hulls, vertices;
  double error_percent;
};
constexpr PaperRow kPaper[] = {{"table", 1, 9, 210, 0.75}, {"table", 2, 17, 282, 0.75}, {"chair", 1, 14, 286, 6.6},
                               {"chair", 2, 24, 396, 6.4}, {"sofa", 1, 8, 158, 3.7},    {"sofa", 2, 52, 557, 3.2}};

/// With the paper's figures, where it has the model.
std::vector<Row> beside_the_paper(const std::vector<Row>& rows) {
  std::vector<Row> all;
  for (const Row& row : rows) {
    if (row.text("model") == kGrowth) continue;
    Row& one = all.emplace_back(row);
    for (const PaperRow& paper : kPaper) {
      if (row.text("model") != paper.model || row.number("level") != paper.level) continue;
      one.add("paper_hulls", std::int64_t(paper.hulls)).add("paper_vertices", std::int64_t(paper.vertices));
      one.add("paper_error", paper.error_percent);
    }
  }
  return all;
}

constexpr const char* kExplanation = R"(<p>Before anything is drawn, a model is approximated by a few convex hulls. The
paper limits the number of their vertices and reports the <em>orthographic error</em>: how far the area of the hulls'
silhouettes is from the model's, on the three planes of the axes, in per cent. Too much and too little can cancel in it, so
that the two stand beside it: what hulls cover beside the model (an occluder that hides too much), and what they leave out of
it. The limit can be read as vertices that differ or as a sum over hulls; the way down the tree of clusters as the paper
prints it, or the better of that and another one. The models of the paper are not known: ours have the same numbers of
polygons and vertices, and were made before any error was measured.</p>
)";

/// The reading that the other experiments use: the limit counts vertices that differ, the better way down.
bool is_default(const Row& row) { return row.text("count") == "distinct" && row.text("order") == "better"; }
bool is_growth(const Row& row) { return row.text("model").starts_with("torus"); }

template <class Keep>
std::vector<Row> those(const std::vector<Row>& rows, Keep keep) {
  std::vector<Row> kept;
  std::copy_if(rows.begin(), rows.end(), std::back_inserter(kept), keep);
  return kept;
}

std::string digits(double value, int n) {
  std::array<char, 64> text;
  const auto [end, error] = std::to_chars(text.data(), text.data() + text.size(), value, std::chars_format::fixed, n);
  return error == std::errc() ? std::string(text.data(), end) : "–";
}

std::string table_of_errors(const std::vector<Row>& rows, bool with_reading) {
  std::vector<Column> columns = {{"model", "model"}, {"level", "level"}};
  if (with_reading) columns.insert(columns.end(), {{"count", "limit counts"}, {"order", "way down"}});
  columns.insert(columns.end(), {{"paper_hulls", "paper: hulls"},
                                 {"paper_vertices", "vertices"},
                                 {"paper_error", "error %", 2},
                                 {"hulls", "ours: hulls"},
                                 {"distinct", "vertices"},
                                 {"error_percent", "error %", 2},
                                 {"over_axes_percent", "too much %", 1},
                                 {"under_axes_percent", "too little %", 1},
                                 {"over_random_percent", "anywhere: too much %", 1},
                                 {"under_random_percent", "too little %", 1}});
  return html_table(rows, columns);
}

/// What the second levels of the paper's three models say.
std::string finding(const std::vector<Row>& rows) {
  std::string html = "<p class=\"finding\">";
  for (const Row& row : rows) {
    if (row.number("level") != 2.0 || row.find("paper_error") == nullptr) continue;
    html += "The " + escaped(row.text("model")) + "'s error at level 2 is " + digits(row.number("error_percent"), 1) +
            " % (the paper's: " + digits(row.number("paper_error"), 2) + " %), of which the sum hides " +
            digits(row.number("over_axes_percent"), 1) + " % too much and " +
            digits(row.number("under_axes_percent"), 1) + " % too little. ";
  }
  return html + "</p>\n";
}

/// Seconds over polygons, with n log² n through the first point.
std::string growth_plot(const std::vector<Row>& times) {
  PlotSeries measured{.title = "measured", .x = {}, .y = {}, .labels = {}},
      bound{.title = "n log² n through the first", .x = {}, .y = {}, .labels = {}};
  for (const Row& row : those(times, is_growth)) {
    const double n = row.number("polygons"), seconds = row.number("seconds");
    if (!(n > 1.0) || !(seconds > 0.0)) continue;
    measured.x.push_back(n), measured.y.push_back(seconds);
    const auto cost = [](double k) { return k * std::log2(k) * std::log2(k); };
    bound.x.push_back(n), bound.y.push_back(measured.y[0] * cost(n) / cost(measured.x[0]));
  }
  if (measured.x.size() < 2) return {};
  Plot plot{.x_title = "polygons", .y_title = "seconds", .series = {measured, bound}};
  plot.log_x = plot.log_y = true;
  return "<figure>" + svg_of(plot) + "<figcaption>Time to approximate a torus</figcaption></figure>\n";
}

}  // namespace

std::string convex_approximation_section(const FoundResults& found) {
  const std::vector<Column> times = {
      {"model", "model"},           {"count", "limit counts"},      {"order", "way down"},
      {"seconds", "seconds", 2},    {"weld_s", "welding", 3},       {"area_s", "silhouettes", 3},
      {"cluster_s", "clusters", 3}, {"partition_s", "way down", 3}, {"hulls_s", "hulls", 3}};
  const std::vector<Column> growth = {{"polygons", "polygons of the largest torus"},
                                      {"exponent", "slope of log seconds over log polygons", 2},
                                      {"exponent_n_log2_n", "that of n log² n", 2},
                                      {"hulls_percent", "% of the time in hulls", 1}};
  const std::vector<Row> rows = beside_the_paper(
      those(found.summary, [](const Row& row) { return !is_growth(row) && row.text("model") != kGrowth; }));
  const std::vector<Row> shown = those(rows, is_default);
  return std::string(kExplanation) + finding(shown) + table_of_errors(shown, false) +
         "<details><summary>All readings of the limit and of the way down</summary>\n" + table_of_errors(rows, true) +
         "</details>\n<h3>Time to make them</h3>\n" + growth_plot(found.times) +
         html_table(those(found.summary, [](const Row& row) { return row.text("model") == kGrowth; }), growth) +
         "<details><summary>Seconds, part by part</summary>\n" + html_table(found.times, times) + "</details>\n";
}

}  // namespace lode::experiments
