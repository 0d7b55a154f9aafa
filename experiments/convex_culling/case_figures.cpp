#include "experiments/convex_culling/case_figures.h"

#include <algorithm>
#include <filesystem>

#include "experiments/convex_culling/method_rows.h"
#include "experiments/convex_culling/names.h"
#include "experiments/error.h"
#include "experiments/file_bytes.h"
#include "experiments/harness/method.h"
#include "experiments/report/gnuplot.h"
#include "experiments/report/html.h"

namespace lode::experiments {
namespace {

constexpr std::string_view kWhole = ".whole.png";

/// Few enough to be told apart.
constexpr std::string_view kCurves[] = {kBaseline, kOracle, "hierarchical_z", "inner_boxes", kPaper};

constexpr const char* kLegend =
    "<p class=\"keys\"><span><i class=\"seen\"></i>drawn, and seen</span> <span><i class=\"kept\"></i>drawn in vain"
    "</span> <span><i class=\"culled\"></i>culled rightly</span> <span><i class=\"lost\"></i>culled, but seen</span> "
    "<span><i class=\"out\"></i>out of view</span></p>";

std::string picture(const std::string& file, const std::string& caption) {
  return "<figure>" + html_image(file, caption) + "<figcaption>" + escaped(caption) + "</figcaption></figure>\n";
}

/// A drawing that the experiment wrote, as it is in the page; nothing if there is none.
std::string drawing(const std::string& file) {
  std::string svg = file_bytes(file).value_or("");
  if (svg.find("<script") != std::string::npos) {
    throw Error(Status::bad_input, file + ": expected a drawing that lodestone run wrote, found a script in it");
  }
  return svg;
}

/// What the rivals cull in the same view.
std::string rivals_from_above(const std::string& name) {
  std::string html;
  for (const char* rival : kRivals) {
    const std::string svg = drawing(name + "." + rival + ".top.svg");
    if (!svg.empty())
      html += "<figure>" + svg + "<figcaption>" + escaped(spoken_name(rival)) + "</figcaption></figure>";
  }
  if (html.empty()) return html;
  return "<details><summary>What its rivals cull in this view, from above</summary><div class=\"three\">" + html +
         "</div></details>\n";
}

/// `name`: of its files, without what tells them apart. `frame`: as `lodestone render` takes it.
std::string pictures_of_view(const std::string& name, const std::string& scene, const std::string& path,
                             const std::string& frame) {
  const bool lost = std::filesystem::is_regular_file(name + ".drawn.png");
  std::string html = "<div class=\"pair\">";
  if (lost) {
    html += html_slider(name + std::string(kWhole), name + ".drawn.png",
                        "View " + frame + ". Left: everything. Right: convex culling, safe.");
    html += picture(name + ".difference.png", "What was lost, in red, framed");
    html += picture(name + ".flip.png",
                    "What a person sees of it: FLIP, from black (nothing) over purple and orange to yellow (most)");
  } else {
    html += picture(name + std::string(kWhole),
                    "View " + frame + ". Convex culling, safe, draws the same picture to the byte.");
  }
  html += "<figure>" + drawing(name + ".top.svg") + "<figcaption>The same view from above: objects, by their boxes" +
          kLegend + "</figcaption></figure></div>\n";
  html += rivals_from_above(name);
  if (path == kRandomViewpoints) return html;
  return html + "<p class=\"again\">Again: <code>" +
         escaped("lodestone render " + scene + " --camera \"" + path + " " + frame +
                 "\" --size 640x480 --technique convex_culling:mode=safe --out drawn.png") +
         "</code></p>\n";
}

}  // namespace

std::string time_against_error(const std::vector<Row>& summary) {
  PlotSeries off{.title = "skips off", .x = {}, .y = {}},
      on{.title = "the renderer skips, too", .x = {}, .y = {}, .labels = {}, .hollow = true},
      front{.title = "Pareto front (without the oracle)", .x = {}, .y = {}, .labels = {}, .ringed = true};
  std::vector<double> x, y;
  std::vector<std::string> methods;
  std::string list;
  for (const Row& row : summary) {
    const std::string method = row.text("method");
    const bool skips = method.ends_with(kWithSkips);
    const std::string base(without_skips(method));
    auto known = std::find(methods.begin(), methods.end(), base);
    if (known == methods.end()) {
      known = methods.insert(known, base);
      list += (list.empty() ? "" : "; ") + std::to_string(methods.size()) + " " + spoken_name(base);
    }
    PlotSeries& series = skips ? on : off;
    series.x.push_back(row.number("frame_ms_mean")), series.y.push_back(row.number("false_percent"));
    // The oracle is a bound, not to be beaten.
    if (base != kOracle) x.push_back(series.x.back()), y.push_back(series.y.back());
    series.labels.push_back(std::to_string(known - methods.begin() + 1));
  }
  for (const std::size_t i : pareto_front(x, y)) front.x.push_back(x[i]), front.y.push_back(y[i]);
  return html_plot(
      {.x_title = "ms a frame, mean", .y_title = "falsely culled, % of px", .log_y = true, .series = {off, on, front}},
      "Run time against error: left is faster, down loses less. " + list + ".");
}

std::string times_along_the_walk(const std::vector<Row>& times) {
  Plot curves{.x_title = "frame of the walk", .y_title = "ms a frame", .height = 300, .series = {}};
  for (const std::string_view name : kCurves) {
    const std::string method(name);
    PlotSeries series{.title = spoken_name(method), .x = {}, .y = {}};
    for (const Row& row : rows_with(times, "method", method)) {
      series.x.push_back(row.number("frame")), series.y.push_back(row.number("frame_ms"));
    }
    if (!series.x.empty()) curves.series.push_back(std::move(series));
  }
  if (curves.series.empty()) return {};
  return html_plot(curves, "Frame times along the walk, the renderer's skips off (the paper's Fig. 4)");
}

std::string case_pictures(const FoundResults& found, const std::string& scene, const std::string& path) {
  std::vector<std::string> frames;
  if (!std::filesystem::is_directory(found.images)) return {};
  const std::string begin = scene + "." + path + ".";
  for (const auto& entry : std::filesystem::directory_iterator(found.images)) {
    const std::string name = entry.path().filename().string();
    if (!name.starts_with(begin) || !name.ends_with(kWhole)) continue;
    frames.push_back(name.substr(begin.size(), name.size() - begin.size() - kWhole.size()));
  }
  std::sort(frames.begin(), frames.end());
  std::string html;
  for (const std::string& frame : frames) {
    html += pictures_of_view(found.images + "/" + begin + frame, scene, path, frame);
  }
  return html;
}

}  // namespace lode::experiments
