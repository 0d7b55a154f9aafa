#include "experiments/convex_culling/section.h"

#include <algorithm>
#include <filesystem>
#include <fstream>
#include <iterator>

#include "experiments/convex_culling/overview.h"
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
centres, one that is <em>continuous</em> nothing anywhere. Frames are 640&nbsp;&times;&nbsp;480, times without loading and
preparing. <em>Oracle</em> draws what is visible and nothing else: it is told.</p>
)";

const std::vector<Column> kOverviewColumns = {{"method", "method"},
                                              {"promise", "promise"},
                                              {"speedup", "times as fast as frustum culling", 2},
                                              {"speedup_skips", "with skips", 2},
                                              {"own_ms", "own ms a frame", 2},
                                              {"culled_percent", "culled %", 1},
                                              {"least_culled_percent", "least", 1},
                                              {"false_percent", "falsely culled, % of px", 4},
                                              {"worst_false_percent", "most", 3},
                                              {"worst_walk", "in"},
                                              {"loses", "loses"}};

const std::vector<Column> kColumns = {{"number", ""},
                                      {"method", "method"},
                                      {"frame_ms_median", "ms, median", 2},
                                      {"frame_ms_p99", "p99", 2},
                                      {"technique_ms_mean", "own ms", 2},
                                      {"speedup", "times as fast", 2},
                                      {"own_percent_of_saved", "own % of saved", 1},
                                      {"culled_percent", "culled %", 1},
                                      {"false_objects", "false objects"},
                                      {"false_px", "false px"},
                                      {"false_percent", "% of px", 4},
                                      {"false_samples_4x4", "at 4x4"},
                                      {"false_samples_random", "at random"},
                                      {"pictures_that_differ", "pictures that differ"}};

bool has_skips(const std::string& method) { return method.ends_with(kWithSkipsSuffix); }

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

/// A number for each method, the same with and without the renderer's skips.
std::vector<Row> numbered(const std::vector<Row>& rows) {
  std::vector<std::string> methods;
  std::vector<Row> all;
  for (const Row& row : rows) {
    const std::string text = row.text("method");
    const std::string method = has_skips(text) ? text.substr(0, text.size() - kWithSkipsSuffix.size()) : text;
    auto at = std::find(methods.begin(), methods.end(), method);
    if (at == methods.end()) at = methods.insert(methods.end(), method);
    all.emplace_back(row).add("number", std::int64_t(at - methods.begin() + 1));
  }
  return all;
}

/// Time against error, a point a method; the front of those that nothing beats in both.
std::string time_against_error(const std::vector<Row>& summary) {
  Plot plot{.x_title = "ms a frame", .y_title = "falsely culled, % of pixels that show anything", .series = {}};
  plot.zero_at = 1e-5;
  PlotSeries off{.title = "skips off", .x = {}, .y = {}, .labels = {}},
      on{.title = "skips on", .x = {}, .y = {}, .labels = {}};
  std::vector<double> x, y;
  for (const Row& row : summary) {
    PlotSeries& series = has_skips(row.text("method")) ? on : off;
    series.x.push_back(row.number("frame_ms_mean")), series.y.push_back(row.number("false_percent"));
    series.labels.push_back(row.text("number"));
    x.push_back(series.x.back()), y.push_back(series.y.back());
  }
  PlotSeries front{.title = "Pareto front", .x = {}, .y = {}, .labels = {}};
  for (const std::size_t i : pareto_front(x, y)) front.x.push_back(x[i]), front.y.push_back(y[i]);
  plot.series = {off, on, front};
  return "<figure>" + svg_of(plot) +
         "<figcaption>Run time against error. Numbers are those of the table. To the left and below is better; what "
         "the front joins is beaten by nothing in both.</figcaption></figure>\n";
}

/// The paper's Fig. 4.
std::string times_along_the_walk(const std::vector<Row>& times) {
  Plot plot{.x_title = "frame", .y_title = "ms a frame", .series = {}};
  for (const std::string& method : values_of(times, "method")) {
    if (has_skips(method) || method == "plain" || method.find("mode=literal") != std::string::npos ||
        method.find(":shape") != std::string::npos) {
      continue;
    }
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

constexpr const char* kTopKey = R"(<figcaption class="key">From above: <span><i style="background:#2da44e"></i>drawn and
seen</span><span><i style="background:#d4a72c"></i>drawn, not seen</span><span><i style="background:#54aeff"></i>culled</span>
<span><i style="background:#cf222e"></i>seen, and culled</span><span><i style="background:#8884"></i>out of
view</span></figcaption>)";

/// Where the paper's technique lost pixels, and why.
std::string causes(const std::vector<Row>& summary) {
  std::string html;
  for (const Row& row : summary) {
    const std::string method = row.text("method");
    if (has_skips(method) || row.find("bulge_px") == nullptr || row.number("false_px") == 0.0) continue;
    html += escaped(method) + " lost " + row.text("false_px") + " pixels: " + row.text("depth_px") +
            " that a depth rule would have kept, " + row.text("snapping_px") + " by corners moved to slabs, " +
            row.text("bulge_px") + " behind hulls that bulge out of their models. ";
  }
  return html.empty() ? html : "<p>" + html + "</p>\n";
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
    html += "<div class=\"pictures\">" +
            html_slider(name + ".whole.png", name + ".drawn.png", "Left: everything. Right: what was not culled.");
    html += "<figure>" + html_image(name + ".difference.png", "what was lost") +
            "<figcaption>What was lost, in red</figcaption></figure>\n<figure>" +
            html_image(name + ".flip.png", "FLIP error map") +
            "<figcaption>The difference that a person sees (FLIP): black none, yellow all</figcaption></figure>\n" +
            "<figure>" + file_text(name + ".top.svg") + kTopKey + "</figure></div>\n";
  }
  return html;
}

/// One walk, folded up.
std::string walk(const FoundResults& found, const std::string& scene, const std::string& path,
                 const std::vector<Row>& rows) {
  const std::vector<Row> summary = numbered(rows);
  std::string html = "<details><summary>" + escaped(scene + ", " + path) + " (" + summary[0].text("frames") +
                     " frames)</summary>\n" + html_table(summary, kColumns) + causes(summary);
  html += "<div class=\"plots\">" + time_against_error(summary);
  if (path != "random viewpoints") {
    html += times_along_the_walk(rows_with(rows_with(found.times, "scene", scene), "path", path));
  }
  return html + "</div>\n" + pictures(found, scene, path) + "</details>\n";
}

}  // namespace

std::string convex_culling_section(const FoundResults& found) {
  const std::vector<Row> overview = overview_of(found.summary);
  std::string html = kExplanation + findings_of(overview) + html_table(overview, kOverviewColumns);
  html += "<h3>Walk by walk</h3>\n";
  for (const std::string& scene : values_of(found.summary, "scene")) {
    const std::vector<Row> of_scene = rows_with(found.summary, "scene", scene);
    for (const std::string& path : values_of(of_scene, "path")) {
      html += walk(found, scene, path, rows_with(of_scene, "path", path));
    }
  }
  return html;
}

}  // namespace lode::experiments
