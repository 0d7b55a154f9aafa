#pragma once
/// An experiment, as its own folder describes it: a question, asked of techniques on scenes, answered by rows of
/// figures. To add one: a function that returns its Experiment, and a line in experiment_list.cpp.

#include <cstdint>
#include <functional>
#include <span>
#include <string>
#include <vector>

#include "experiments/common_options.h"
#include "experiments/harness/kept_results.h"
#include "experiments/harness/row.h"
#include "experiments/parameter.h"
#include "experiments/report/found_results.h"
#include "experiments/streams.h"

namespace lode::experiments {

/// What an experiment is run with.
struct ExperimentRun {
  bool full = false;  ///< all that there is, hours maybe; else the quick size: at most a few minutes
  std::uint64_t seed = 1;
  ParameterValues values;  ///< of the experiment's parameters
  CommonOptions common;
  Streams streams;
  KeptResults kept{""};  ///< truth, and finished cases of a run that was stopped
  std::string images;    ///< a folder that is there, for pictures
};

struct ExperimentResults {
  std::vector<Row> results;  ///< a row for each frame and setting: deterministic
  std::vector<Row> times;    ///< ms, of this machine
  std::vector<Row> summary;  ///< a row for each scene, walk and setting, or whatever the experiment sums up
};

struct Experiment {
  std::string name;
  std::string summary;  ///< the question, in a line
  std::vector<Parameter> parameters;
  std::function<ExperimentResults(const ExperimentRun&)> run;
  std::function<std::string(const FoundResults&)> section;        ///< of the report: HTML
  std::function<std::string(const FoundResults&)> headline = {};  ///< for the top of the report: HTML, or none
};

[[nodiscard]] std::span<const Experiment> experiment_list();

}  // namespace lode::experiments
