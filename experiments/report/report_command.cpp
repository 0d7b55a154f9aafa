#include "experiments/report/report_command.h"

#include <CLI/CLI.hpp>
#include <filesystem>
#include <memory>
#include <ostream>

#include "experiments/experiment.h"
#include "experiments/report/html.h"
#include "experiments/whole_file.h"

namespace lode::experiments {
namespace {

struct ReportOptions {
  std::string folder;
  std::string out;  ///< empty: report.html in the folder
};

PageSection section_of(const Experiment& experiment, const std::string& folder) {
  const FoundResults found = read_results(folder);
  std::string html = "<p><strong>" + escaped(experiment.summary) + "</strong></p>\n" + experiment.section(found);
  html += "<p>Size: " + escaped(found.size) + ". Times were taken on: " + escaped(found.machine) +
          ".</p>\n<p>The same figures again:</p>\n<pre>" + escaped(found.command) + "</pre>\n";
  return {experiment.name, experiment.name, std::move(html)};
}

Status report(const ReportOptions& options, const Streams& streams) {
  std::vector<PageSection> sections;
  for (const Experiment& experiment : experiment_list()) {
    const std::string folder = options.folder + "/" + experiment.name;
    if (std::filesystem::is_directory(folder)) sections.push_back(section_of(experiment, folder));
  }
  if (sections.empty()) {
    throw Error(Status::bad_input,
                options.folder + ": expected the folder of an experiment, as lodestone run makes it");
  }
  const std::string out = options.out.empty() ? options.folder + "/report.html" : options.out;
  WholeFile file(out);
  const std::string page = html_page("Lodestone: experiments",
                                     "Rendering techniques, held against the whole picture: how much time they save, "
                                     "and what that costs. Figures that are "
                                     "not times are the same on every machine.",
                                     sections);
  file.file().write(page.data(), page.size());
  publish({&file});
  streams.out << out << ": " << sections.size() << (sections.size() == 1 ? " experiment\n" : " experiments\n");
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
              },
          .run = [options](const CommonOptions&, const Streams& streams) { return report(*options, streams); }};
}

}  // namespace lode::experiments
