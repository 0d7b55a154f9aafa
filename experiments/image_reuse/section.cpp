#include "experiments/image_reuse/section.h"

#include <algorithm>
#include <cmath>
#include <cstdlib>
#include <filesystem>

#include "experiments/harness/method.h"
#include "experiments/image_reuse/names.h"
#include "experiments/image_reuse/summary.h"
#include "experiments/report/gnuplot.h"
#include "experiments/report/html.h"

namespace lode::experiments {
namespace {

constexpr const char* kExplanation =
    R"(<p>A far house looks almost the same from frame to frame: it is drawn once, and its picture is shown on a plate until the
direction in which it is seen has turned by more than a threshold. The paper measured the time of 2000 frames on two walks,
straight to the houses and back (case 1) and sideways (case 2), and no error. How the tables are read:</p>
<ul>
<li><b>Seconds</b>: of 2000 frames of 640&nbsp;&times;&nbsp;480, from the mean of the frames that were timed. <b>Times faster</b>:
than drawing everything with the same skips of the renderer. The paper's renderer had none; &ldquo;with skips&rdquo; ours
leaves out what is hidden.</li>
<li><b>Reused %</b>: of the houses that are far enough to be. <b>Taken a frame</b>: pictures, anew.</li>
<li><b>FLIP</b>, SSIM, PSNR: against the picture of everything, means over views. <b>Pop</b>: how much more the picture changes
from one frame to the next than the picture of everything does, in code values; a jump when a picture is taken anew shows
there, and nowhere else.</li>
<li><b>Off by</b>: how far vertices on plates are shown from where they are, in pixels, in the mean and at most.</li>
</ul>
)";

/// Ohno et al., table 1: seconds of 2000 frames. 0: not measured.
struct PaperRow {
  std::string_view path;
  double plain, at_1, at_2, at_5;
};
constexpr PaperRow kPaper[] = {{kApproach, 61.4, 38.4, 0.0, 0.0}, {kSideways, 32.4, 33.2, 27.8, 23.2}};

const std::vector<Column> kTable1 = {{"walk", "walk"},     {"who", "who"},      {"plain", "3-D", 2}, {"at_0.5", "0.5°", 2},
                                     {"at_1", "1°", 2},    {"at_2", "2°", 2},   {"at_3", "3°", 2},   {"at_5", "5°", 2},
                                     {"at_10", "10°", 2}};

const std::vector<Column> kMethods = {{"name", "method"},
                                      {"seconds", "seconds", 2},
                                      {"speedup", "times faster", 2},
                                      {"speedup_with_skips", "with skips", 2},
                                      {"frame_ms_p99", "p99 ms", 2},
                                      {"reused_percent", "reused %", 1},
                                      {"captures_per_frame", "taken a frame", 2},
                                      {"picture_mib", "MiB kept", 1},
                                      {"flip", "FLIP", 4},
                                      {"ssim", "SSIM", 4},
                                      {"psnr_db", "PSNR dB", 1},
                                      {"pop", "pop", 2},
                                      {"pop_max", "at most", 2},
                                      {"displacement_px", "off by px", 2},
                                      {"displacement_max_px", "at most", 1}};

const std::vector<Column> kEqualError = {{"flip", "FLIP at most", 4}, {"reuse", "reuse"},     {"frame_ms_mean", "ms", 2},
                                         {"other", "others"},         {"rival_ms", "ms", 2}, {"ratio", "times faster", 2}};

std::string walk_name(std::string_view path) {
  if (path == kApproach) return "case 1, straight";
  return path == kSideways ? "case 2, sideways" : std::string(path);
}

std::string spoken(const std::string& method) {
  if (method == kNoCache) return "everything drawn (3-D)";
  std::string text(without_skips(method));
  if (text.starts_with("image_reuse:threshold=")) {
    text = "reuse, " + text.substr(std::string("image_reuse:threshold=").size());
    const std::size_t comma = text.find(',', 7);
    text.insert(comma == std::string::npos ? text.size() : comma, "°");
  }
  if (text.starts_with("predicted_reuse")) {
    text.replace(0, std::string("predicted_reuse").size(), "predicted,");
    if (text.find("cell=0") == std::string::npos) text.insert(std::string("predicted,").size(), " relief");
    if (const std::size_t flat = text.find("cell=0"); flat != std::string::npos) text.replace(flat, 6, "flat");
    if (const std::size_t px = text.find("error="); px != std::string::npos) text = text.replace(px, 6, "") + " px";
  }
  if (text.starts_with("mesh_lod")) text.replace(0, std::string("mesh_lod").size(), "levels of detail");
  std::replace(text.begin(), text.end(), '_', ' ');
  for (const char from : {':', '='}) std::replace(text.begin(), text.end(), from, ' ');
  std::size_t at = 0;
  while ((at = text.find(',', at)) != std::string::npos) {
    if (at + 1 < text.size() && text[at + 1] != ' ') text.insert(at + 1, " ");
    ++at;
  }
  return text;
}

const Row* find_row(const std::vector<Row>& rows, const std::string& method) {
  const auto found = std::find_if(rows.begin(), rows.end(), [&](const Row& r) { return r.text("method") == method; });
  return found == rows.end() ? nullptr : &*found;
}

const Row* find_row(std::vector<Row>&& rows, const std::string& method) = delete;  // it would not outlive the call

std::vector<Row> of_walk(const std::vector<Row>& rows, std::string_view kind, const std::string& scene,
                         const std::string& path) {
  return rows_with(rows_with(rows_with(rows, "kind", std::string(kind)), "scene", scene), "path", path);
}

/// Rows without those with skips, whose speedup stands beside.
std::vector<Row> with_skips_beside(const std::vector<Row>& rows) {
  std::vector<Row> beside;
  for (const Row& row : rows) {
    const std::string method = row.text("method");
    if (method.ends_with(kWithSkips)) continue;
    Row& one = beside.emplace_back(row);
    one.add("name", spoken(method));
    if (const Row* skips = find_row(rows, method + std::string(kWithSkips)); skips && skips->find("speedup")) {
      one.add("speedup_with_skips", skips->number("speedup"));
    }
  }
  return beside;
}

Row table_row(const std::vector<Row>& rows, std::string_view path, const std::string& who, std::string_view skips,
              std::string_view column) {
  Row to;
  to.add("walk", walk_name(path)).add("who", who);
  const auto add = [&](const std::string& name, const std::string& method) {
    const Row* row = find_row(rows, method + std::string(skips));
    if (row && row->find(column)) to.add(name, row->number(column));
  };
  add("plain", kNoCache);
  for (const char* degrees : kThresholds_deg) add("at_" + std::string(degrees), reuse_at(degrees));
  return to;
}

Row paper_row(const PaperRow& paper, bool speedups) {
  Row row;
  row.add("walk", walk_name(paper.path)).add("who", speedups ? "paper, times faster" : "paper, seconds");
  const auto add = [&](const char* name, double seconds) {
    if (seconds > 0.0) row.add(name, speedups ? paper.plain / seconds : seconds);
  };
  add("plain", paper.plain), add("at_1", paper.at_1), add("at_2", paper.at_2), add("at_5", paper.at_5);
  return row;
}

/// The paper's table 1 beside ours.
std::string table_1(const std::vector<Row>& summary, const std::string& scene) {
  std::vector<Row> rows;
  for (const PaperRow& paper : kPaper) {
    const std::vector<Row> ours = of_walk(summary, kOfMethod, scene, std::string(paper.path));
    if (ours.empty()) continue;
    rows.push_back(paper_row(paper, false));
    rows.push_back(table_row(ours, paper.path, "ours, seconds", "", "seconds"));
    rows.push_back(paper_row(paper, true));
    rows.push_back(table_row(ours, paper.path, "ours, times faster", "", "speedup"));
    if (find_row(ours, kNoCache + std::string(kWithSkips))) {
      rows.push_back(table_row(ours, paper.path, "ours, seconds, with skips", kWithSkips, "seconds"));
      rows.push_back(table_row(ours, paper.path, "ours, times faster, with skips", kWithSkips, "speedup"));
    }
  }
  if (rows.empty()) return {};
  return "<h3>The paper's table 1, and ours (" + escaped(scene) + ")</h3>\n" + html_table(rows, kTable1) +
         "<p>The paper does not say at which threshold its case 1 was measured; it stands under 1°.</p>\n";
}

std::string cost_model_sentence(const Row& fit, double plain_ms) {
  std::string text = "<p>Fitted to these thresholds: T = " + fixed_text(fit.number("t0_ms"), 2) + " ms + " +
                     fixed_text(fit.number("k_ms_deg"), 3) + " ms·° / θ, no farther from any than " +
                     fixed_text(fit.number("residual_percent"), 1) + " %; everything drawn takes " +
                     fixed_text(plain_ms, 2) + " ms.";
  const double least_deg = std::strtod(kThresholds_deg.front(), nullptr);
  if (fit.find("break_even_deg") && fit.number("break_even_deg") > 0.1 * least_deg) {
    return text + " Reuse costs as much as none at " + fixed_text(fit.number("break_even_deg"), 2) +
           "° (in the paper's case 2: 1.09°).</p>\n";
  }
  return text + (plain_ms > fit.number("t0_ms") ? " It pays at all of them.</p>\n" : " It never pays.</p>\n");
}

std::string times_by_threshold(const std::vector<Row>& methods, const Row& fit) {
  PlotSeries measured{.title = "measured", .x = {}, .y = {}, .ringed = true}, model{.title = "T0 + k/θ", .x = {}, .y = {}},
      plain{.title = "everything drawn", .x = {}, .y = {}};
  for (const char* degrees : kThresholds_deg) {
    const Row* row = find_row(methods, reuse_at(degrees));
    if (!row || !row->find("frame_ms_mean")) continue;
    measured.x.push_back(std::strtod(degrees, nullptr)), measured.y.push_back(row->number("frame_ms_mean"));
  }
  for (double degrees = 0.5; degrees <= 10.0; degrees += 0.1) {
    model.x.push_back(degrees), model.y.push_back(fit.number("t0_ms") + fit.number("k_ms_deg") / degrees);
  }
  const double plain_ms = find_row(methods, kNoCache)->number("frame_ms_mean");
  plain.x = {0.5, 10.0}, plain.y = {plain_ms, plain_ms};
  return html_plot({.x_title = "threshold, degrees",
                    .y_title = "ms a frame, mean",
                    .height = 300,
                    .series = {measured, model, plain}},
                   "What a frame costs at each threshold, and the model");
}

/// FLIP over milliseconds: one point a method.
std::string time_against_error(const std::vector<Row>& methods) {
  PlotSeries off{.title = "skips off", .x = {}, .y = {}},
      on{.title = "the renderer skips, too", .x = {}, .y = {}, .labels = {}, .hollow = true},
      front{.title = "Pareto front", .x = {}, .y = {}, .labels = {}, .ringed = true};
  std::vector<double> x, y;
  std::string list;
  std::vector<std::string> known;
  for (const Row& row : methods) {
    if (!row.find("frame_ms_mean") || !row.find("flip")) continue;
    const std::string method = row.text("method"), base(without_skips(method));
    auto at = std::find(known.begin(), known.end(), base);
    if (at == known.end()) {
      at = known.insert(known.end(), base);
      list += (list.empty() ? "" : "; ") + std::to_string(known.size()) + " " + spoken(base);
    }
    PlotSeries& series = method.ends_with(kWithSkips) ? on : off;
    series.x.push_back(row.number("frame_ms_mean")), series.y.push_back(row.number("flip"));
    series.labels.push_back(&series == &off ? std::to_string(at - known.begin() + 1) : "");
    x.push_back(series.x.back()), y.push_back(series.y.back());
  }
  if (x.empty()) return {};
  for (const std::size_t i : pareto_front(x, y)) front.x.push_back(x[i]), front.y.push_back(y[i]);
  std::vector<PlotSeries> series = {off};
  if (!on.x.empty()) series.push_back(on);
  series.push_back(front);
  return html_plot({.x_title = "ms a frame, mean", .y_title = "FLIP", .height = 520, .series = series},
                   "Run time against error: left is faster, down is closer to the picture of everything. " + list +
                       (on.x.empty() ? "." : ". Hollow, at the height of its like: with the renderer's skips."));
}

/// The paper's technique beside the fastest of the others that is as close to the truth; each pair once, at its least FLIP.
std::string at_equal_error(std::vector<Row> rows) {
  if (rows.empty()) return {};
  const auto same_pair = [](const Row& a, const Row& b) {
    return a.text("method") == b.text("method") && a.text("rival") == b.text("rival");
  };
  rows.erase(std::unique(rows.begin(), rows.end(), same_pair), rows.end());
  for (Row& row : rows) row.add("reuse", spoken(row.text("method"))).add("other", spoken(row.text("rival")));
  return "<p>At equal error: for the FLIP of each threshold the fastest threshold that is not above it, and the fastest of "
         "the other techniques that is not above it either (the same two only once).</p>\n" +
         html_table(rows, kEqualError);
}

std::string times_along_the_walk(const std::vector<Row>& times) {
  Plot curves{.x_title = "frame of the walk", .y_title = "ms a frame", .height = 300, .series = {}};
  for (const std::string& method : {std::string(kNoCache), reuse_at("1"), reuse_at("5")}) {
    PlotSeries series{.title = spoken(method), .x = {}, .y = {}};
    for (const Row& row : rows_with(times, "method", method)) {
      series.x.push_back(row.number("frame")), series.y.push_back(row.number("frame_ms"));
    }
    if (!series.x.empty()) curves.series.push_back(std::move(series));
  }
  if (curves.series.empty()) return {};
  return html_plot(curves, "Frame times along the walk: a peak is a frame in which pictures were taken anew");
}

/// Speedup over the triangles of a house.
std::string speedups_by_size(const std::vector<Row>& summary, std::string_view path) {
  Plot plot{.x_title = "triangles of a house, thousands", .y_title = "times faster", .height = 300, .series = {}};
  const std::vector<Row> rows = rows_with(rows_with(summary, "kind", kOfMethod), "path", std::string(path));
  for (const char* degrees : kThresholds_deg) {
    std::vector<Row> of = rows_with(rows, "method", reuse_at(degrees));
    std::erase_if(of, [](const Row& row) {
      return row.number("each") <= 0.0 || !row.find("speedup") || !row.text("scene").starts_with("houses24");
    });
    std::stable_sort(of.begin(), of.end(),
                     [](const Row& a, const Row& b) { return a.number("each") < b.number("each"); });
    if (of.size() < 2) continue;
    PlotSeries& series = plot.series.emplace_back(PlotSeries{.title = degrees, .x = {}, .y = {}, .ringed = true});
    series.title += "°";
    for (const Row& row : of) {
      series.x.push_back(row.number("each") / 1000.0), series.y.push_back(row.number("speedup"));
    }
  }
  if (plot.series.empty()) return {};
  return html_plot(plot, walk_name(path) + ": where it is above 1, reuse is faster than drawing everything");
}

std::string crossovers(const std::vector<Row>& summary) {
  const std::vector<Row> found = rows_with(summary, "kind", kOfCrossover);
  if (found.empty()) return {};
  std::vector<Row> rows;
  std::vector<Column> columns = {{"walk", "walk"}};
  for (const char* degrees : kThresholds_deg) columns.push_back({degrees, std::string(degrees) + "°"});
  for (const std::string& path : values_of(found, "path")) {
    Row& to = rows.emplace_back();
    to.add("walk", walk_name(path));
    const std::vector<Row> of_path = rows_with(found, "path", path);
    for (const char* degrees : kThresholds_deg) {
      const Row* row = find_row(of_path, reuse_at(degrees));
      if (row == nullptr) continue;
      to.add(degrees, row->find("triangles") ? fixed_text(row->number("triangles"), 0) : std::string("never"));
    }
  }
  return "<h3>From how many triangles on reuse pays</h3>\n<p>Of a house, by threshold; between sizes that were measured "
         "by a straight line, the least of them if it pays there already.</p>\n" +
         html_table(rows, columns) + speedups_by_size(summary, kApproach) + speedups_by_size(summary, kSideways);
}

std::string pictures(const FoundResults& found, const std::string& scene, const std::string& path) {
  if (!std::filesystem::is_directory(found.images)) return {};
  const std::string begin = scene.substr(0, scene.find(':')) + "." + path + ".";
  std::string html;
  std::vector<std::string> names;
  for (const auto& entry : std::filesystem::directory_iterator(found.images)) {
    const std::string name = entry.path().filename().string();
    if (name.starts_with(begin) && name.ends_with(kWholePicture)) names.push_back(entry.path().string());
  }
  std::sort(names.begin(), names.end());
  for (const std::string& whole : names) {
    const std::string name = whole.substr(0, whole.size() - kWholePicture.size());
    const auto of = [&](std::string_view kind) { return name + std::string(kind); };
    html += "<div class=\"pair\">" + html_slider(whole, of(kReusedPicture), "Left: everything drawn. Right: reuse, 2°.");
    html += "<figure>" + html_image(of(kReusedFlip), "FLIP") +
            "<figcaption>What a person sees of the difference: FLIP, from black (nothing) over purple and orange to "
            "yellow (most)</figcaption></figure>";
    html += html_slider(whole, of(kLiteralPicture),
                        "Left: everything drawn. Right: reuse, 2°, as the paper prints it: what is in front of a house "
                        "and behind it is in its picture, and the plate's middle is where the box's is.");
    html += "</div>\n";
  }
  return html;
}

std::string section_of_walk(const FoundResults& found, const std::string& scene, const std::string& path) {
  const std::vector<Row> methods = of_walk(found.summary, kOfMethod, scene, path);
  const auto in_walk = [&](const std::vector<Row>& rows) { return rows_with(rows_with(rows, "scene", scene), "path", path); };
  const std::vector<Row> times = in_walk(found.times), fits = rows_with(of_walk(found.summary, kOfFit, scene, path), "skips", "0");
  std::string html = "<h3>" + escaped(scene + ", " + walk_name(path)) + "</h3>\n" +
                     html_table(with_skips_beside(methods), kMethods);
  if (!fits.empty()) {
    html += cost_model_sentence(fits[0], find_row(methods, kNoCache)->number("frame_ms_mean")) +
            times_by_threshold(methods, fits[0]);
  }
  return html + time_against_error(methods) + at_equal_error(of_walk(found.summary, kOfEqualError, scene, path)) + times_along_the_walk(times) + pictures(found, scene, path);
}

/// The scenes that all methods were asked on.
std::vector<std::string> whole_scenes(const std::vector<Row>& summary) {
  std::vector<std::string> scenes;
  for (const std::string& scene : values_of(rows_with(summary, "kind", kOfMethod), "scene")) {
    const std::vector<Row> rows = rows_with(summary, "scene", scene);
    if (find_row(rows, kLiteral)) scenes.push_back(scene);
  }
  return scenes;
}

}  // namespace

std::string image_reuse_headline(const FoundResults& found) {
  const std::vector<std::string> scenes = whole_scenes(found.summary);
  if (scenes.empty()) return {};
  std::string html = "<h3>Reuse of pictures, " + escaped(scenes.front()) + "</h3>\n<ul>\n";
  for (const std::string& path : values_of(rows_with(found.summary, "scene", scenes.front()), "path")) {
    const std::vector<Row> rows = of_walk(found.summary, kOfMethod, scenes.front(), path);
    const Row *at_2 = find_row(rows, reuse_at("2")), *skips = find_row(rows, reuse_at("2") + std::string(kWithSkips));
    if (!at_2 || !at_2->find("speedup")) continue;
    html += "<li>" + escaped(walk_name(path)) + ": at 2° " + fixed_text(at_2->number("speedup"), 2) +
            " times as fast as drawing everything";
    if (skips) html += " (" + fixed_text(skips->number("speedup"), 2) + " where the renderer skips what is hidden)";
    html += ", FLIP " + fixed_text(at_2->number("flip"), 4) + ", features off by " +
            fixed_text(at_2->number("displacement_px"), 2) + " px in the mean and " +
            fixed_text(at_2->number("displacement_max_px"), 1) + " at most.</li>\n";
  }
  return html + "</ul>\n";
}

std::string image_reuse_section(const FoundResults& found) {
  std::string html = kExplanation;
  const std::vector<std::string> scenes = whole_scenes(found.summary);
  for (const std::string& scene : scenes) html += table_1(found.summary, scene);
  html += crossovers(found.summary);
  for (const std::string& scene : scenes) {
    html += "<h2>" + escaped(scene) + "</h2>\n";
    for (const std::string& path : values_of(rows_with(found.summary, "scene", scene), "path")) {
      html += section_of_walk(found, scene, path);
    }
  }
  return html;
}

}  // namespace lode::experiments
