#include "experiments/lodestone.h"

#include <CLI/CLI.hpp>
#include <algorithm>
#include <limits>
#include <new>
#include <ostream>
#include <span>
#include <string>
#include <vector>

#include "experiments/command.h"
#include "experiments/error.h"
#include "experiments/renderer_choice.h"
#include "geometry/error.h"
#include "raster/error.h"
#include "raster/render.h"

namespace lode::experiments {
namespace {

/// Options as they stand on the command line, before they are checked.
struct CommandLine {
  CommonOptions common;
  std::string target = "best";
  std::string pipeline = "fast";
  std::string skip = "all";
};

void add_common_options(CLI::App& app, CommandLine& line) {
  app.set_version_flag("--version",
                       "lodestone " LODESTONE_VERSION ", pixel contract " + std::to_string(raster::kPixelContract));
  app.add_flag("--quiet", line.common.quiet, "No progress on standard error");
  app.add_option("--threads", line.common.threads, "Worker threads; 0: one per core (default)")
      ->check(CLI::Range(0, std::numeric_limits<int>::max()))
      ->option_text("N");
  app.add_option("--target", line.target, "best, scalar, sse4, avx2, avx512, neon or wasm (default best)")
      ->option_text("NAME");
  app.add_option("--pipeline", line.pipeline, "fast or reference (default fast)")->option_text("NAME");
  app.add_option(
         "--skip", line.skip,
         "Work that is left out where the picture needs none: all (default), none, or some of frustum, facing,\n"
         "occlusion, samples, blocks")
      ->option_text("LIST");
}

/// "Examples:" and the lines, indented.
std::string examples_text(std::span<const std::string> lines) {
  std::string text = "Examples:\n";
  for (const std::string& line : lines) text += "  " + line + "\n";
  return text;
}

/// The common options, in the help of every command.
constexpr const char* kCommonOptionsText =
    "Also, before or after the command: --quiet, --threads N, --target NAME, --pipeline NAME, --skip LIST, --version;\n"
    "lodestone --help tells more.\n\n";

std::string program_footer(std::span<const Command> commands) {
  std::vector<std::string> examples;
  for (const Command& command : commands) examples.push_back(command.examples.front());
  return "--threads, --target, --pipeline and --skip move no pixel; --stats says what ran. The last three are of the\n"
         "rasterizer: fast is made for the instruction set, reference is the plain one that it is held against.\n"
         "`lodestone COMMAND --help` tells more about each command.\n\n" +
         examples_text(examples) +
         "\nExit status: 0 done, 1 a check or comparison failed, 2 wrong usage, 3 bad input, 4 the machine failed.\n";
}

/// The part of the command line that is the command's.
CLI::App* add_command(CLI::App& app, const Command& command) {
  CLI::App* const part = app.add_subcommand(command.name, command.summary);
  part->fallthrough();  // common options may follow the command's name
  command.add_options(*part);
  part->footer((command.footer.empty() ? "" : command.footer + "\n") + kCommonOptionsText +
               examples_text(command.examples));
  return part;
}

/// Sets the common options that are words.
void read_common_options(CommandLine& line) {
  line.common.target = read_target(line.target);
  line.common.pipeline = read_pipeline(line.pipeline);
  line.common.skips = read_skips(line.skip);
}

int fail(std::ostream& err, Status status, std::string_view message) {
  err << "lodestone: " << one_line(message) << std::endl;
  return int(status);
}

/// What CLI11 found wrong, in one line.
int fail_parse(std::ostream& err, const CLI::App& app, std::span<const Command> commands,
               const CLI::ParseError& error) {
  const std::vector<std::string> rest = app.remaining();
  if (app.get_subcommands().empty() && !rest.empty() && !rest.front().starts_with("-")) {
    std::string names;
    for (const Command& command : commands) names += (names.empty() ? "" : ", ") + command.name;
    return fail(err, Status::wrong_usage, "unknown command \"" + shortened(rest.front(), 40) + "\": expected " + names);
  }
  return fail(err, Status::wrong_usage, std::string(error.what()) + " (--help tells more)");
}

int run(int argc, const char* const* argv, const Streams& streams) {
  CLI::App app("Lodestone, a deterministic rasterizer: the same bytes on every machine.", "lodestone");
  CommandLine line;
  app.require_subcommand(1);
  add_common_options(app, line);
  const std::vector<Command> commands = all_commands();
  std::vector<const CLI::App*> parts;
  for (const Command& command : commands) parts.push_back(add_command(app, command));
  app.footer(program_footer(commands));
  if (argc <= 1) {
    streams.err << app.help();
    return int(Status::wrong_usage);
  }

  const auto parsed = [](const CLI::App* part) { return part->parsed(); };
  try {
    app.parse(argc, argv);
  } catch (const CLI::Success& success) {  // --help, --version
    const auto part = std::find_if(parts.begin(), parts.end(), parsed);
    if (success.get_name() == "CallForVersion") {
      streams.out << success.what() << std::endl;
    } else {
      streams.out << (part != parts.end() ? (*part)->help("lodestone") : app.help()) << std::flush;
    }
    return streams.out ? int(Status::done)
                       : fail(streams.err, Status::machine_failed, "standard output: cannot be written");
  } catch (const CLI::ParseError& error) {
    return fail_parse(streams.err, app, commands, error);
  }
  read_common_options(line);
  const auto chosen = std::find_if(parts.begin(), parts.end(), parsed) - parts.begin();
  return int(commands[std::size_t(chosen)].run(line.common, streams));
}

}  // namespace

int run_lodestone(int argc, const char* const* argv, const Streams& streams) {
  std::ostream& err = streams.err;
  try {
    return run(argc, argv, streams);
  } catch (const Error& error) {
    return fail(err, error.status(), error.what());
  } catch (const geometry::Error& error) {
    return fail(err, error.kind() == geometry::ErrorKind::bad_input ? Status::bad_input : Status::machine_failed,
                error.what());
  } catch (const raster::Error& error) {
    return fail(err, error.kind() == raster::ErrorKind::bad_input ? Status::bad_input : Status::machine_failed,
                error.what());
  } catch (const std::bad_alloc&) {
    return fail(err, Status::machine_failed, "out of memory");
  } catch (const std::exception& error) {
    return fail(err, Status::machine_failed, error.what());
  }
}

}  // namespace lode::experiments
