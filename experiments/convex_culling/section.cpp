#include "experiments/convex_culling/section.h"

#include <algorithm>
#include <filesystem>

#include "experiments/convex_culling/case_figures.h"
#include "experiments/convex_culling/method_rows.h"
#include "experiments/convex_culling/names.h"
#include "experiments/convex_culling/truth_table.h"
#include "experiments/harness/method.h"
#include "experiments/report/html.h"
#include "experiments/scenes/builtin_scene.h"
#include "experiments/technique_list.h"

namespace lode::experiments {
namespace {

constexpr const char* kExplanation =
    R"(<p>What hides behind houses and walls need not be drawn. Each method decides, object by object, what to leave out; the
renderer then draws the rest at 640&nbsp;&times;&nbsp;480. How the tables are read:</p>
<ul>
<li><b>Times faster</b> than frustum culling, which leaves out only what is beside the view. &ldquo;With skips&rdquo;: the
renderer, too, skips clusters of triangles behind what it has drawn; held against the same frustum culling without.</li>
<li><b>Own ms</b>: what deciding takes, of a frame. <b>Own % of saved</b>: of the time that the method saves the renderer, if it saves any.</li>
<li><b>Culled %</b>: of objects in view that own no pixel, and so could be left out.</li>
<li><b>False</b> is what was left out and can be seen: objects, pixels (samples at their centres), samples at 4&nbsp;&times;&nbsp;4
places in every pixel, and at random places. A method that promises to be conservative where <em>sampled</em> must lose nothing
at the centres; where <em>continuous</em>, nothing anywhere.</li>
<li><b>FLIP to truth</b>: how much a person sees of the difference (0 to 1) between a method's pictures and true ones, of 8&nbsp;&times;&nbsp;8
samples a pixel, in one view of each walk. A picture in which nothing is culled has an error, too, by aliasing: only what a
method adds to it is lost by culling.</li>
<li>Losses of the paper's technique are traced to a <b>cause</b>: rules are taken back one after the other until the object
comes back.</li>
</ul>
)";

const std::vector<Column> kOverall = {{"name", "method"},
                                      {"promise", "promises to be"},
                                      {"speedup", "times faster", 2},
                                      {"speedups", "in any walk"},
                                      {"speedup_with_skips", "with skips", 2},
                                      {"technique_ms_mean", "own ms", 2},
                                      {"culled_percent", "culled %", 1},
                                      {"false_percent", "false % of px", 4},
                                      {"false_samples_4x4", "false at 4×4"},
                                      {"pictures_that_differ", "pictures that differ"},
                                      {"flip_true", "FLIP to truth", 5}};

const std::vector<Column> kColumns = {{"name", "method"},
                                      {"frame_ms_median", "ms, median", 2},
                                      {"frame_ms_p99", "p99", 2},
                                      {"speedup", "times faster", 2},
                                      {"speedup_with_skips", "with skips", 2},
                                      {"technique_ms_mean", "own ms", 2},
                                      {"own_percent_of_saved", "own % of saved", 0},
                                      {"culled_percent", "culled %", 1},
                                      {"false_objects", "false objects"},
                                      {"false_px", "px"},
                                      {"false_percent", "% of px", 4},
                                      {"false_samples_4x4", "at 4×4"},
                                      {"false_samples_random", "at random"}};

std::string summary_of_scene(const std::string& scene) {
  for (const BuiltinScene& one : builtin_scenes()) {
    if (one.name == scene) return one.summary + ".";
  }
  return {};
}

/// What each method does, in the words of `lodestone list techniques`.
std::string what_methods_do(const std::vector<Row>& summary) {
  std::string html = "<details><summary>What the methods do</summary><ul>\n";
  std::vector<std::string> said;
  for (const std::string& method : values_of(summary, "method")) {
    const std::string name = method.substr(0, method.find_first_of(": "));
    if (std::find(said.begin(), said.end(), name) != said.end()) continue;
    said.push_back(name);
    std::string words = name == kOracle ? "Draws just what can be seen, told for nothing: a bound, no technique" : "";
    for (const TechniqueEntry& entry : technique_list()) {
      if (entry.name == name) words = entry.summary;
    }
    html += "<li><b>" + escaped(spoken_name(name)) + "</b>: " + escaped(words) + ".</li>\n";
  }
  return html + "</ul></details>\n";
}

/// What made methods lose, where it is known.
std::string causes(const std::vector<Row>& rows) {
  std::string html;
  for (const Row& row : rows) {
    if (const std::string text = row.text("causes"); !text.empty()) {
      html += "<p>Lost by " + escaped(row.text("name")) + ": " + escaped(text) + ".</p>\n";
    }
  }
  return html;
}

std::string again(const std::string& command) {
  return "<p class=\"again\">Again: <code>" + escaped(command) + "</code></p>\n";
}

std::string section_of_walk(const FoundResults& found, const std::string& scene, const std::string& path,
                            const std::vector<Row>& summary) {
  const auto of_walk = [&](const std::vector<Row>& rows) {
    return rows_with(rows_with(rows, "scene", scene), "path", path);
  };
  const std::vector<Row> results = of_walk(found.results), times = of_walk(found.times);
  std::string html = "<h3>" + escaped(scene + ", " + path) + "</h3>\n" + findings(summary, results);
  const std::vector<Row> rows = with_skips_beside(summary);
  html += html_table(rows, kColumns) + causes(rows) + time_against_error(summary);
  if (path != kRandomViewpoints) html += times_along_the_walk(times);
  return html + case_pictures(found, scene, path) + truth_table(summary) +
         again(found.command.find(" --set scene=") == std::string::npos ? found.command + " --set scene=" + scene
                                                                        : found.command);
}

}  // namespace

std::string convex_culling_headline(const FoundResults& found) {
  const std::vector<Row> all = over_all_scenes(found);
  const std::size_t n_scenes = values_of(found.summary, "scene").size();
  return "<h3>Occlusion culling, over " + std::to_string(n_scenes) + (n_scenes == 1 ? " scene" : " scenes") +
         "</h3>\n" + findings(all, found.results) + html_table(with_skips_beside(all), kOverall) +
         "<p>&ldquo;Times faster&rdquo; is against frustum culling; the columns are explained with the tables of the "
         "scenes.</p>\n";
}

std::string convex_culling_section(const FoundResults& found) {
  std::string html = kExplanation + what_methods_do(found.summary);
  for (const std::string& scene : values_of(found.summary, "scene")) {
    html += "<h2>" + escaped(scene) + "</h2>\n<p>" + escaped(summary_of_scene(scene)) + "</p>\n";
    const std::vector<Row> of_scene = rows_with(found.summary, "scene", scene);
    for (const std::string& path : values_of(of_scene, "path")) {
      html += section_of_walk(found, scene, path, rows_with(of_scene, "path", path));
    }
  }
  return html;
}

}  // namespace lode::experiments
