#include "experiments/convex_approximation/section.h"

#include "experiments/convex_approximation/growth.h"
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

}  // namespace

std::string convex_approximation_section(const FoundResults& found) {
  const std::vector<Column> columns = {{"model", "model"},
                                       {"level", "level"},
                                       {"count", "limit counts"},
                                       {"order", "way down"},
                                       {"paper_hulls", "paper: hulls"},
                                       {"paper_vertices", "vertices"},
                                       {"paper_error", "error %", 2},
                                       {"hulls", "ours: hulls"},
                                       {"distinct", "vertices"},
                                       {"sum", "sum over hulls"},
                                       {"error_percent", "error %", 2},
                                       {"over_axes_percent", "too much %, axes", 1},
                                       {"under_axes_percent", "too little %", 1},
                                       {"over_random_percent", "too much %, anywhere", 1},
                                       {"under_random_percent", "too little %", 1}};
  const std::vector<Column> times = {
      {"model", "model"},           {"count", "limit counts"},      {"order", "way down"},
      {"seconds", "seconds", 2},    {"weld_s", "welding", 3},       {"area_s", "silhouettes", 3},
      {"cluster_s", "clusters", 3}, {"partition_s", "way down", 3}, {"hulls_s", "hulls", 3}};
  return std::string(kExplanation) + html_table(beside_the_paper(found.summary), columns) +
         "<h3>Time to make them</h3>\n" + html_table(found.times, times);
}

}  // namespace lode::experiments
