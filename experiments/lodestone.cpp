#include "experiments/lodestone.h"

#include <CLI/CLI.hpp>
#include <istream>
#include <limits>
#include <new>
#include <ostream>
#include <string>

#include "experiments/common_options.h"
#include "experiments/draw/draw_command.h"
#include "experiments/error.h"
#include "geometry/error.h"
#include "raster/error.h"
#include "raster/render.h"

namespace lode::experiments {
namespace {

constexpr const char* kExamples =
    "Examples:\n"
    "  lodestone draw picture.json --out picture.png\n"
    "  lodestone draw picture.json --print\n"
    "  lodestone draw picture.json --depth depth.npy --ids ids.npy --stats -\n"
    "  echo '{\"size\": [9, 9], \"draws\": [{\"triangles\": [[1,1,0.5], [1,8,0.5], [8,8,0.5]]}]}' |\n"
    "    lodestone draw - --print\n"
    "\n"
    "Exit status: 0 done, 1 a check or comparison failed, 2 wrong usage, 3 bad input, 4 the machine failed.\n";

constexpr const char* kDrawFooter =
    "Files: colour .png .exr .npy; depth and ids .exr .npy. Row 0 is the top. Depth is 1 near, 0 far or nothing;\n"
    "ids are 4294967295 twice where nothing was drawn. All outputs appear whole, together, or not at all.\n"
    "Without any output the picture is only checked.\n"
    "\n"
    "A picture:\n"
    "  {\"size\": [64, 64], \"unit\": \"px\", \"clear\": [0,0,0,255], \"draws\": [\n"
    "    {\"triangles\": [[2,2,0.5], [2,60,0.5], [60,2,0.5]], \"color\": [255,0,0,255]},\n"
    "    {\"lines\": [[0,0,0.6], [64,64,0.6]], \"stipple\": {\"pattern\": 13107, \"factor\": 1}}]}\n"
    "\n"
    "At the top: size, unit (\"px\" or \"1/256\"), clear, samples, clip_from_world, scissor, draws.\n"
    "A draw has one geometry: triangles, quads, lines, line_strip, points (x, y in the unit, y down, z in [0, 1],\n"
    "1 near), the same in clip space: clip, clip_quads, clip_lines, clip_line_strip, clip_points (x, y, z, w), or\n"
    "discs {center, radius}, surfels {center, normal, radius}. Also: color, colors, uv, texture {size, rgba,\n"
    "filter, wrap, wrap_u, wrap_v, border, max_anisotropy, mips}, alpha_test, cull, blend, depth_test,\n"
    "depth_write, scissor, stipple {pattern, factor} (lines), point_size (points).\n"
    "Values: filter nearest|bilinear|trilinear|anisotropic, wrap repeat|mirror|clamp|border, cull none|back|front,\n"
    "blend none|over|add, samples a power of two up to 128. Defaults: clear [0,0,0,255], color [255,255,255,255],\n"
    "filter nearest, wrap repeat, cull and blend none, depth_test true, depth_write true without blending.\n";

/// Options as they stand on the command line, before they are checked.
struct CommandLine {
  CommonOptions common;
  std::string target = "best";
  std::string pipeline = "fast";
  std::string skip = "all";
  DrawOptions draw;
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
  app.add_option("--skip", line.skip, "all, none or a list: the renderer's skips that are on (default all)")
      ->option_text("LIST");
  app.footer(std::string("--threads, --target, --pipeline and --skip move no pixel. Today there is one pipeline, the reference;\n"
                         "--stats says what ran.\n\n") +
             kExamples);
}

CLI::App* add_draw(CLI::App& app, DrawOptions& draw) {
  CLI::App* const command = app.add_subcommand("draw", "Draw a handful of primitives from a JSON file");
  command->fallthrough();  // common options may follow the command's name
  command->add_option("PICTURE", draw.picture, "The picture's JSON; - is standard input")->required();
  command->add_option("--out", draw.out, "Colour to F (.png, .exr, .npy)")->option_text("F");
  command->add_option("--depth", draw.depth, "Depth to F (.exr, .npy)")->option_text("F");
  command->add_option("--ids", draw.ids, "Draw and primitive of each pixel to F (.exr, .npy)")->option_text("F");
  command->add_flag("--print", draw.print, "The picture as text: a letter per draw, '.' for nothing");
  command
      ->add_option("--stats", draw.stats,
                   "Samples covered and visible, counters and hashes, as JSON to F (- is stdout)")
      ->option_text("F|-");
  command->footer(kDrawFooter);
  return command;
}

/// Sets the common options that are words.
void read_common_options(CommandLine& line) {
  line.common.target = read_target(line.target);
  if (line.pipeline != "fast" && line.pipeline != "reference") {
    throw Error(Status::wrong_usage, "--pipeline: expected fast or reference, found \"" + line.pipeline + "\"");
  }
  line.common.pipeline = line.pipeline == "fast" ? Pipeline::fast : Pipeline::reference;
  if (line.skip != "all" && line.skip != "none") {
    throw Error(Status::wrong_usage, "--skip " + line.skip + ": the renderer has no such skip: expected all or none");
  }
}

int fail(std::ostream& err, Status status, std::string_view message) {
  err << "lodestone: " << one_line(message) << std::endl;
  return int(status);
}

/// What CLI11 found wrong, in one line.
int fail_parse(std::ostream& err, const CLI::App& app, const CLI::ParseError& error) {
  const std::vector<std::string> rest = app.remaining();
  if (app.get_subcommands().empty() && !rest.empty() && !rest.front().starts_with("-")) {
    return fail(err, Status::wrong_usage, "unknown command \"" + shortened(rest.front(), 40) + "\": expected draw");
  }
  return fail(err, Status::wrong_usage, std::string(error.what()) + " (--help tells more)");
}

int run(int argc, const char* const* argv, std::istream& in, std::ostream& out, std::ostream& err) {
  CLI::App app("Lodestone, a deterministic rasterizer: the same bytes on every machine.", "lodestone");
  CommandLine line;
  app.require_subcommand(1);
  add_common_options(app, line);
  const CLI::App* const draw_command = add_draw(app, line.draw);
  if (argc <= 1) {
    err << app.help();
    return int(Status::wrong_usage);
  }

  try {
    app.parse(argc, argv);
  } catch (const CLI::Success& success) {  // --help, --version
    if (success.get_name() == "CallForVersion") {
      out << success.what() << std::endl;
    } else {
      out << (draw_command->parsed() ? draw_command->help("lodestone") : app.help()) << std::flush;
    }
    return out ? int(Status::done) : fail(err, Status::machine_failed, "standard output: cannot be written");
  } catch (const CLI::ParseError& error) {
    return fail_parse(err, app, error);
  }
  read_common_options(line);
  draw(line.draw, line.common, in, out);
  return int(Status::done);
}

}  // namespace

int run_lodestone(int argc, const char* const* argv, std::istream& in, std::ostream& out, std::ostream& err) {
  try {
    return run(argc, argv, in, out, err);
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
