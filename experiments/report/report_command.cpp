#include "experiments/report/report_command.h"

#include <CLI/CLI.hpp>
#include <algorithm>
#include <cctype>
#include <filesystem>
#include <memory>
#include <ostream>

#include "experiments/experiment.h"
#include "experiments/file_bytes.h"
#include "experiments/option_values.h"
#include "experiments/report/html.h"
#include "experiments/whole_file.h"

namespace lode::experiments {
namespace {

struct ReportOptions {
  std::string folder;
  std::string out;                    ///< empty: report.html in the folder
  std::vector<std::string> sections;  ///< TITLE=FILE.html
};

PageSection section_of(const Experiment& experiment, const FoundResults& found) {
  std::string html = "<p><strong>" + escaped(experiment.summary) + ".</strong></p>\n" + experiment.section(found);
  html += "<p>Size: " + escaped(found.size) + ". Times were taken on: " + escaped(found.machine) +
          ".</p>\n<p>The same figures again:</p>\n<pre>" + escaped(found.command) + "</pre>\n";
  std::string title = experiment.name;
  std::replace(title.begin(), title.end(), '_', ' ');
  return {experiment.name, title, std::move(html)};
}

/// What another program wrote, as a section.
PageSection section_of_file(const std::string& word) {
  const std::size_t equals = word.rfind('=');
  if (equals == std::string::npos) fail_value("--section", "TITLE=FILE.html", word);
  const std::string title = word.substr(0, equals), path = word.substr(equals + 1);
  std::optional<std::string> html = file_bytes(path);
  if (!html) throw Error(Status::bad_input, path + ": cannot be read: expected the HTML of a section");
  std::string id;
  for (const char c : title) id += std::isalnum(static_cast<unsigned char>(c)) != 0 ? c : '_';
  return {id, title, *std::move(html)};
}

Status report(const ReportOptions& options, const Streams& streams) {
  std::vector<PageSection> sections;
  std::string headlines;
  for (const Experiment& experiment : experiment_list()) {
    const std::string folder = options.folder + "/" + experiment.name;
    if (!std::filesystem::is_directory(folder)) continue;
    const FoundResults found = read_results(folder);
    sections.push_back(section_of(experiment, found));
    if (experiment.headline)
      headlines += experiment.headline(found) + "<p>Taken on: " + escaped(found.machine) + ".</p>\n";
  }
  const std::size_t n_experiments = sections.size();
  for (const std::string& word : options.sections) sections.push_back(section_of_file(word));
  if (sections.empty()) {
    throw Error(Status::bad_input,
                options.folder + ": expected a folder that holds a folder of each experiment, as `lodestone run --out` makes it");
  }
  const std::string out = options.out.empty() ? options.folder + "/report.html" : options.out;
  const std::string page = html_page("Lodestone",
                                     "Rendering techniques, held against the whole picture: how much time they save, "
                                     "and what that costs. Figures that are "
                                     "not times are the same on every machine.",
                                     headlines, sections);
  write_whole_file(out, page);
  streams.out << out << ": " << n_experiments << (n_experiments == 1 ? " experiment\n" : " experiments\n");
  return Status::done;
}

}  // namespace

Command report_command() {
  const auto options = std::make_shared<ReportOptions>();
  return {.name = "report",
          .summary = "Make one self-contained page of what experiments found",
          .footer = "DIR is what `lodestone run --out DIR` wrote. Plots are made by gnuplot.\n",
          .examples = {"lodestone report out/experiments", "lodestone report results --out report.html"},
          .add_options =
              [options](CLI::App& app) {
                app.add_option("DIR", options->folder, "With a folder for each experiment")->required();
                app.add_option("--out", options->out, "The page (default DIR/report.html)")->option_text("FILE.html");
                app.add_option("--section", options->sections, "A section more, of HTML that another program wrote")
                    ->option_text("TITLE=FILE.html")
                    ->take_all();
              },
          .run = [options](const CommonOptions&, const Streams& streams) { return report(*options, streams); }};
}

}  // namespace lode::experiments
