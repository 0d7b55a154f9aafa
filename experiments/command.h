#pragma once
/// A command of the program, as its own folder describes it. To add one: a function that returns its Command, and a
/// line in commands.cpp.

#include <functional>
#include <string>
#include <vector>

#include "experiments/common_options.h"
#include "experiments/error.h"
#include "experiments/streams.h"

namespace CLI {
class App;
}

namespace lode::experiments {

struct Command {
  std::string name;                   ///< "draw"
  std::string summary;                ///< one line for the list of commands
  std::string footer;                 ///< what its help says after the options: lines, each ended
  std::vector<std::string> examples;  ///< command lines; the program's own help has the first

  /// Adds the command's options to its part of the command line. What they are read into lives as long as `run`.
  std::function<void(CLI::App&)> add_options;

  /// Does the work: done, or check_failed. Throws Error, geometry::Error or raster::Error; then no output has appeared
  /// but what standard output had already taken.
  std::function<Status(const CommonOptions&, const Streams&)> run;
};

/// All commands, in the order in which help lists them.
[[nodiscard]] std::vector<Command> all_commands();

}  // namespace lode::experiments
