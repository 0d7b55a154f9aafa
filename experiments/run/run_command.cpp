#include "experiments/run/run_command.h"

#include <CLI/CLI.hpp>
#include <memory>
#include <nlohmann/json.hpp>
#include <ostream>

#include "experiments/experiment.h"
#include "experiments/lodestone.h"
#include "experiments/option_values.h"
#include "experiments/renderer_choice.h"
#include "experiments/run/machine.h"
#include "experiments/run/results_folder.h"
#include "raster/error.h"
#include "raster/parallel.h"

namespace lode::experiments {
namespace {

using nlohmann::ordered_json;

struct RunOptions {
  std::vector<std::string> experiments;
  std::string size = "quick";
  std::vector<std::string> set;
  std::string seed = "1";
  std::string out = "out/experiments";
};

constexpr std::string_view kSizes[] = {"quick", "full"};

std::vector<const Experiment*> chosen(const RunOptions& options) {
  std::vector<std::string_view> names;
  for (const Experiment& experiment : experiment_list()) names.push_back(experiment.name);
  std::vector<const Experiment*> list;
  for (const std::string& name : options.experiments) {
    list.push_back(&experiment_list()[read_choice("run", name, names)]);
  }
  return list;
}

/// What --set says of one experiment; "experiment.name=value" is for that one alone.
ParameterValues values_of(const Experiment& experiment, const RunOptions& options, bool only_one) {
  ParameterValues values = default_values(experiment.parameters);
  for (const std::string& word : options.set) {
    const std::string prefix = experiment.name + ".";
    if (word.starts_with(prefix)) {
      read_parameter("--set", experiment.parameters, std::string_view(word).substr(prefix.size()), values);
    } else if (only_one) {
      read_parameter("--set", experiment.parameters, word, values);
    } else if (word.substr(0, word.find('=')).find('.') == std::string::npos) {
      fail_value("--set", "EXPERIMENT.NAME=VALUE, as several experiments run", word);
    }
  }
  return values;
}

ordered_json rows_as_json(const std::vector<Row>& rows) { return ordered_json::parse(rows_json(rows)); }

std::string summary_json(const Experiment& experiment, const ExperimentRun& run, const ExperimentResults& results) {
  const Machine machine = this_machine();
  ordered_json parameters = ordered_json::object();
  std::string command = "lodestone run " + experiment.name + (run.full ? " --size full" : "");
  if (run.seed != 1) command += " --seed " + std::to_string(run.seed);
  for (const Parameter& p : experiment.parameters) {
    const double value = run.values.at(p.name);
    parameters[p.name] = value_text(p, value);
    if (value != p.default_value) command += " --set " + p.name + "=" + value_text(p, value);
  }
  const ordered_json json = {{"experiment", experiment.name},
                             {"question", experiment.summary},
                             {"size", run.full ? "full" : "quick"},
                             {"seed", run.seed},
                             {"parameters", parameters},
                             {"pixel_contract", raster::kPixelContract},
                             {"machine",
                              {{"processor", machine.processor},
                               {"processors", machine.n_processors},
                               {"threads", raster::worker_count(run.common.threads)},
                               {"target", target_name(run.common.pipeline, run.common.target)},
                               {"compiler", machine.compiler},
                               {"build", machine.build}}},
                             {"command", command},
                             {"rows", {{"results", results.results.size()}, {"times", results.times.size()}}},
                             {"summary", rows_as_json(results.summary)}};
  return json.dump(1, ' ', false, ordered_json::error_handler_t::replace) + "\n";
}

/// times.csv says on every row what it was taken on.
void add_machine(const CommonOptions& common, std::vector<Row>& times) {
  const Machine machine = this_machine();
  for (Row& row : times) {
    row.add("processor", machine.processor).add("compiler", machine.compiler).add("build", machine.build);
    row.add("threads", std::int64_t(raster::worker_count(common.threads)));
    row.add("target", std::string(target_name(common.pipeline, common.target)));
  }
}

void run_one(const Experiment& experiment, ExperimentRun run, const RunOptions& options) {
  ResultsFolder folder(options.out + "/" + experiment.name);
  run.images = folder.images();
  ExperimentResults results = experiment.run(run);
  if (results.results.empty()) {
    throw Error(Status::bad_input,
                std::string(experiment.name) +
                    ": nothing was looked at, and nothing is written: expected some frames or views");
  }
  add_machine(run.common, results.times);
  folder.publish(results, summary_json(experiment, run, results));
  run.streams.out << options.out << "/" << experiment.name << ": " << results.results.size() << " rows\n";
}

Status run(const RunOptions& options, const CommonOptions& common, const Streams& streams) {
  const std::vector<const Experiment*> experiments = chosen(options);
  const std::size_t size = read_choice("--size", options.size, kSizes);
  const std::optional<std::int64_t> seed = whole_number_in(options.seed);
  if (options.out.empty()) fail_value("--out", "a folder", options.out);
  if (!seed || *seed < 0) fail_value("--seed", "a whole number from 0 on", options.seed);
  std::vector<ExperimentRun> runs;
  for (const Experiment* experiment : experiments) {
    runs.push_back({.full = size == 1,
                    .seed = std::uint64_t(*seed),
                    .values = values_of(*experiment, options, experiments.size() == 1),
                    .common = common,
                    .streams = streams,
                    .kept = KeptResults(options.out + "/.kept"),
                    .images = {}});
  }
  for (std::size_t i = 0; i < runs.size(); ++i) {
    try {
      run_one(*experiments[i], runs[i], options);
    } catch (const raster::Error& error) {
      const bool memory = error.kind() == raster::ErrorKind::out_of_memory;
      throw Error(memory ? Status::machine_failed : Status::bad_input, experiments[i]->name + ": " + error.what());
    }
  }
  return Status::done;
}

void add_options(CLI::App& app, RunOptions& o) {
  app.add_option("EXPERIMENT", o.experiments, "One or several of `lodestone list experiments`")->required();
  app.add_option("--size", o.size, "quick (default: a few minutes) or full (every frame; hours)")
      ->option_text("quick|full");
  app.add_option("--set", o.set, "A parameter of the experiment; EXPERIMENT.NAME=VALUE if several run")
      ->option_text("NAME=VALUE")
      ->take_all();
  app.add_option("--seed", o.seed, "Of viewpoints and sample positions (default 1)")->option_text("N");
  app.add_option("--out", o.out, "Results go to DIR/EXPERIMENT (default out/experiments)")->option_text("DIR");
}

}  // namespace

Command run_command() {
  const auto options = std::make_shared<RunOptions>();
  return {
      .name = "run",
      .summary = "Run an experiment: techniques on scenes, their time, work and error",
      .footer =
          "Writes DIR/EXPERIMENT/ with results.csv (a row for each frame and setting; deterministic), times.csv,\n"
          "summary.json and images/, whole or not at all. DIR/.kept/ has truth, and the finished cases of a\n"
          "run that was stopped: the next one goes on from there. Delete it to begin anew.\n",
      .examples = {"lodestone run convex_approximation", "lodestone run convex_culling --size full --out results"},
      .add_options = [options](CLI::App& app) { add_options(app, *options); },
      .run = [options](const CommonOptions& common, const Streams& streams) { return run(*options, common, streams); }};
}

}  // namespace lode::experiments
