#include "experiments/convex_approximation/section.h"

#include <algorithm>

#include "experiments/convex_approximation/growth.h"
#include "experiments/convex_approximation/model_pictures.h"
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
it, along the axes and in random directions. The models of the paper are not known: ours have the same numbers of polygons and
vertices, and were made before any error was measured.</p>
)";

constexpr const char* kReadings =
    R"(<p>The limit can be read as vertices that differ (<em>distinct</em>, as in the table
above) or as a sum over hulls, and the tree of clusters can be gone down as the paper prints it or by the better of that and
another way (as above).</p>
)";

/// The first reading alone: distinct vertices, the better way down.
std::vector<Row> main_reading(const std::vector<Row>& rows) {
  std::vector<Row> found;
  for (const Row& row : rows) {
    if (row.text("count") == "distinct" && row.text("order") == "better") found.push_back(row);
  }
  return found;
}

/// Where ours is better than the paper's, where worse, and what cancels, in sentences.
std::string findings(const std::vector<Row>& rows) {
  int n = 0, n_better = 0;
  const Row* hides_most = nullptr;
  for (const Row& row : rows) {
    if (row.find("paper_error") != nullptr) {
      ++n;
      n_better += row.number("error_percent") <= row.number("paper_error") ? 1 : 0;
    }
    const auto cancelled = [](const Row& r) {
      return std::min(r.number("over_axes_percent"), r.number("under_axes_percent"));
    };
    if (hides_most == nullptr || cancelled(row) > cancelled(*hides_most)) hides_most = &row;
  }
  std::string text = "<p>Our error is at most the paper's in " + std::to_string(n_better) + " of " + std::to_string(n) +
                     " rows that it has.";
  if (hides_most != nullptr) {
    text += " What cancels can be much: the " + escaped(hides_most->text("model")) + " (level " +
            hides_most->text("level") + ") has an error of " + fixed_text(hides_most->number("error_percent"), 1) +
            " %, as hulls cover " + fixed_text(hides_most->number("over_axes_percent"), 1) + " % too much and " +
            fixed_text(hides_most->number("under_axes_percent"), 1) + " % too little.";
  }
  return text + "</p>\n";
}

std::string growth(const std::vector<Row>& summary) {
  for (const Row& row : summary) {
    if (row.text("model") != kGrowth) continue;
    return "<p>Over tori of up to " + row.text("polygons") + " polygons the time grows as n to the power of " +
           fixed_text(row.number("exponent"), 2) +
           "; n log&sup2; n, which the paper states, grows there as n to the power of " +
           fixed_text(row.number("exponent_n_log2_n"), 2) + ". " + fixed_text(row.number("hulls_percent"), 1) +
           " % of the time is spent in hulls.</p>\n";
  }
  return {};
}

std::string pictures(const FoundResults& found, const std::vector<Row>& rows) {
  std::string html, last;
  for (const Row& row : rows) {
    const std::string model = row.text("model"), name = found.images + "/" + model;
    const std::string hulls = model == last ? "" : html_image(name + kHullsPicture, model + " and its hulls");
    last = model;
    if (hulls.empty()) continue;
    html += "<figure>" + hulls + "<figcaption>" + escaped(model) +
            ": the model, and its hulls at levels 1 and 2, a colour each</figcaption></figure>\n";
    if (const std::string boxes = html_image(name + kBoxesPicture, model + " and its inner boxes"); !boxes.empty()) {
      html += "<figure>" + boxes + "<figcaption>" + escaped(model) +
              ": the model, and inner boxes, which the rival uses</figcaption></figure>\n";
    }
  }
  return html.empty() ? html
                      : "<details><summary>Pictures of the models and their hulls</summary>" + html + "</details>\n";
}

}  // namespace

std::string convex_approximation_section(const FoundResults& found) {
  const std::vector<Column> readings = {
      {"model", "model"},       {"level", "level"},        {"count", "limit counts"},
      {"order", "way down"},    {"limit", "limit"},        {"hulls", "hulls"},
      {"distinct", "vertices"}, {"sum", "sum over hulls"}, {"error_percent", "error %", 2}};
  const std::vector<Column> columns = {{"model", "model"},
                                       {"level", "level"},
                                       {"paper_hulls", "paper's hulls"},
                                       {"paper_vertices", "paper's vertices"},
                                       {"paper_error", "paper's error %", 2},
                                       {"hulls", "our hulls"},
                                       {"distinct", "our vertices"},
                                       {"error_percent", "our error %", 2},
                                       {"over_axes_percent", "axes: too much %", 1},
                                       {"under_axes_percent", "axes: too little %", 1},
                                       {"over_random_percent", "anywhere: too much %", 1},
                                       {"under_random_percent", "anywhere: too little %", 1}};
  const std::vector<Column> times = {{"model", "model"},           {"seconds", "seconds", 2},
                                     {"weld_s", "welding", 3},     {"area_s", "silhouettes", 3},
                                     {"cluster_s", "clusters", 3}, {"partition_s", "way down", 3},
                                     {"hulls_s", "hulls", 3}};
  const std::vector<Row> all = beside_the_paper(found.summary), rows = main_reading(all);
  return std::string(kExplanation) + findings(rows) + html_table(rows, columns) + pictures(found, rows) +
         "<details><summary>Other readings of the paper</summary>" + kReadings + html_table(all, readings) +
         "</details>\n<h3>Time to make them</h3>\n" + growth(found.summary) +
         html_table(main_reading(found.times), times);
}

}  // namespace lode::experiments
