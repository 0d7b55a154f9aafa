#include "experiments/convex_culling/section.h"

#include <algorithm>
#include <filesystem>
#include <fstream>
#include <iterator>

#include "experiments/report/gnuplot.h"
#include "experiments/report/html.h"

namespace lode::experiments {
namespace {

constexpr const char* kExplanation =
    R"(<p>What hides behind houses and walls need not be drawn. Each method below decides,
object by object, what to leave out; the renderer then draws the rest, with its own skipping of hidden clusters off or on
(&ldquo;+ skips&rdquo;). A method <em>culls falsely</em> if it leaves out an object that can be seen. &ldquo;Culled&rdquo; is
of what could be culled: objects in view that own no pixel. Losses are counted at pixel centres, at 4&nbsp;&times;&nbsp;4 places
in every pixel and at random places: a method that promises to be <em>sampled</em> conservative must lose nothing at the
centres, one that is <em>continuous</em> nothing anywhere. Frames are 640&nbsp;&times;&nbsp;480. Losses of the paper's
technique are traced to their cause: the missing depth rule, corners moved to slabs, or hulls that bulge out of models.</p>
)";

const std::vector<Column> kColumns = {{"method", "method"},
                                      {"promise", "promise"},
                                      {"frame_ms_median", "ms, median", 2},
                                      {"frame_ms_p99", "p99", 2},
                                      {"technique_ms_mean", "own ms", 2},
                                      {"speedup", "times faster", 2},
                                      {"own_percent_of_saved", "own % of saved", 1},
                                      {"culled_percent", "culled %", 1},
                                      {"false_objects", "false objects"},
                                      {"false_px", "false px"},
                                      {"false_percent", "% of px", 4},
                                      {"false_samples_4x4", "at 4x4"},
                                      {"false_samples_random", "at random"},
                                      {"pictures_that_differ", "pictures that differ"},
                                      {"depth_px", "px by depth"},
                                      {"snapping_px", "by slabs"},
                                      {"bulge_px", "by bulges"}};

bool has_skips(const std::string& method) { return method.ends_with(" + skips"); }

std::vector<Row> rows_with(const std::vector<Row>& rows, std::string_view column, const std::string& value) {
  std::vector<Row> found;
  std::copy_if(rows.begin(), rows.end(), std::back_inserter(found),
               [&](const Row& row) { return row.text(column) == value; });
  return found;
}

std::vector<std::string> values_of(const std::vector<Row>& rows, std::string_view column) {
  std::vector<std::string> values;
  for (const Row& row : rows) {
    const std::string value = row.text(column);
    if (std::find(values.begin(), values.end(), value) == values.end()) values.push_back(value);
  }
  return values;
}

/// Time against error, a point a method; the front of those that nothing beats in both.
std::string time_against_error(const std::vector<Row>& summary) {
  Plot plot{.x_title = "ms a frame", .y_title = "samples falsely culled, % of all that show anything", .series = {}};
  PlotSeries off{.title = "skips off", .x = {}, .y = {}, .labels = {}},
      on{.title = "skips on", .x = {}, .y = {}, .labels = {}};
  std::vector<double> x, y;
  for (const Row& row : summary) {
    const std::string method = row.text("method");
    PlotSeries& series = has_skips(method) ? on : off;
    series.x.push_back(row.number("frame_ms_mean")), series.y.push_back(row.number("false_percent"));
    series.labels.push_back(has_skips(method) ? method.substr(0, method.size() - 8) : method);
    x.push_back(series.x.back()), y.push_back(series.y.back());
  }
  PlotSeries front{.title = "Pareto front", .x = {}, .y = {}, .labels = {}};
  for (const std::size_t i : pareto_front(x, y)) front.x.push_back(x[i]), front.y.push_back(y[i]);
  plot.series = {off, on, front};
  return "<figure>" + svg_of(plot) + "<figcaption>Run time against error</figcaption></figure>\n";
}

/// The paper's Fig. 4.
std::string times_along_the_walk(const std::vector<Row>& times) {
  Plot plot{.x_title = "frame", .y_title = "ms a frame", .series = {}};
  for (const std::string& method : values_of(times, "method")) {
    if (has_skips(method) || method == "plain") continue;
    PlotSeries series{.title = method, .x = {}, .y = {}, .labels = {}};
    for (const Row& row : rows_with(times, "method", method)) {
      series.x.push_back(row.number("frame")), series.y.push_back(row.number("frame_ms"));
    }
    plot.series.push_back(std::move(series));
  }
  return "<figure>" + svg_of(plot) +
         "<figcaption>Frame times along the walk, the renderer's skips off (the paper's Fig. "
         "4)</figcaption></figure>\n";
}

std::string file_text(const std::string& path) {
  std::ifstream in(path, std::ios::binary);
  return {std::istreambuf_iterator<char>(in), std::istreambuf_iterator<char>()};
}

/// Pictures that the run left for this walk: NAME.whole.png, NAME.drawn.png, NAME.difference.png, NAME.top.svg.
std::string pictures(const FoundResults& found, const std::string& scene, const std::string& path) {
  std::string html;
  std::vector<std::string> names;
  if (!std::filesystem::is_directory(found.images)) return html;
  for (const auto& entry : std::filesystem::directory_iterator(found.images)) {
    const std::string name = entry.path().filename().string();
    if (name.starts_with(scene + "." + path + ".") && name.ends_with(".whole.png")) {
      names.push_back(found.images + "/" + name.substr(0, name.size() - 10));
    }
  }
  std::sort(names.begin(), names.end());
  for (const std::string& name : names) {
    html += "<div class=\"pair\">" +
            html_slider(name + ".whole.png", name + ".drawn.png", "Left: everything. Right: what was not culled.");
    html += "<figure>" + html_image(name + ".difference.png", "what was lost") +
            "<figcaption>What was lost, in red</figcaption></figure></div>\n<figure>" + file_text(name + ".top.svg") +
            "<figcaption>From above. Green: drawn and seen. Yellow: drawn and not seen. Blue: culled. Red: seen, and "
            "culled. Grey: out of view.</figcaption></figure>\n";
  }
  return html;
}

}  // namespace

std::string convex_culling_section(const FoundResults& found) {
  std::string html = kExplanation;
  for (const std::string& scene : values_of(found.summary, "scene")) {
    const std::vector<Row> of_scene = rows_with(found.summary, "scene", scene);
    for (const std::string& path : values_of(of_scene, "path")) {
      const std::vector<Row> summary = rows_with(of_scene, "path", path);
      html += "<h3>" + escaped(scene + ", " + path) + "</h3>\n<p>" + summary[0].text("frames") + " frames.</p>\n";
      html += html_table(summary, kColumns) + time_against_error(summary);
      if (path != "random viewpoints") {
        html += times_along_the_walk(rows_with(rows_with(found.times, "scene", scene), "path", path));
      }
      html += pictures(found, scene, path);
    }
  }
  return html;
}

}  // namespace lode::experiments
