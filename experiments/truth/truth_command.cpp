#include "experiments/truth/truth_command.h"

#include <CLI/CLI.hpp>
#include <memory>

#include "experiments/truth/truth.h"

namespace lode::experiments {
namespace {

constexpr const char* kFooter =
    "The same pictures as lodestone render, by ray tracing (Embree). Lines and points are left out.\n"
    "\n"
    "--check rasterizes, too, compares ids and depth at every pixel's centre and prints a JSON object: pixels,\n"
    "different, explained by edge, depth_tie, range, embree, and unexplained. Every difference is judged in exact\n"
    "arithmetic over all placements of the vertices within the snap, 1/512 + 2^-20 px; notes/truth.md tells how.\n"
    "Alpha-tested draws count as solid on both sides; blended draws, lines and points are left out (left_out).\n"
    "Status 1 unless unexplained is 0; then up to ten pixels are named on standard error, each with the command\n"
    "that explains it. edge_bound is how many differences edges are expected to explain at most: 0.0055 px x\n"
    "visible_edge_px, the length of the visible edges, measured on a grid of visible_edge_grid lines a pixel (a\n"
    "lower bound); edge_on_line of them lie exactly on an edge.\n"
    "\n"
    "--tour checks from eight cameras: front, diagonal_1, diagonal_2, above, inside, near_cut (the near plane\n"
    "cuts the scene), far_away (a thousand diagonals) and orthographic; the sums are as above, each view is under\n"
    "cameras.\n"
    "\n"
    "--map: grey where both agree; edge yellow, depth_tie blue, range green, embree magenta, unexplained red,\n"
    "each with its neighbours in half of its colour.\n";

void add_options(CLI::App& app, truth::TruthOptions& options) {
  add_scene_options(app, options.scene);
  add_look_options(app, options.look);
  add_output_options(app, options.outputs,
                     "Times and hashes, or the check's figures, as JSON to F (- is standard output)");
  app.add_flag("--check", options.check, "Rasterize, too, and explain every difference");
  app.add_flag("--tour", options.tour, "Check from eight cameras around and inside the scene");
  app.add_option("--map", options.map, "With --check: a picture of the differences to F (.png, .exr, .npy)")
      ->option_text("F");
}

}  // namespace

Command truth_command() {
  const auto options = std::make_shared<truth::TruthOptions>();
  return {.name = "truth",
          .summary = "Ray-trace a scene; check the rasterizer against it",
          .footer = kFooter,
          .examples = {"lodestone truth model.glb --check", "lodestone truth model.glb --tour --size 512x512",
                       "lodestone truth terrain --out truth.png --ids ids.npy",
                       "lodestone truth spheres --check --map differences.png"},
          .add_options = [options](CLI::App& app) { add_options(app, *options); },
          .run = [options](const CommonOptions& common,
                           const Streams& streams) { return run_truth(*options, common, streams); }};
}

}  // namespace lode::experiments
