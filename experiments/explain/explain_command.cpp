#include "experiments/explain/explain_command.h"

#include <CLI/CLI.hpp>
#include <memory>

#include "experiments/explain/explain.h"
#include "experiments/render/render_command.h"

namespace lode::experiments {
namespace {

constexpr const char* kFooter =
    "Tells, for the pixel's sample: which primitive is shown and which ones are hidden behind it, with depth, key and\n"
    "exact edge values; which rule decided where it was close (the top-left rule on an edge, the lower key at equal\n"
    "depth, strictly nearer for what is blended); weights, texels and mip levels; the colour at each step; and what "
    "was\n"
    "dropped before the depth test, and by which test. All of it is what `lodestone render` does, to the bit.\n"
    "\n"
    "All options of render are taken, so that a command line can be reused; files and times are not made.\n";

void add_options(CLI::App& app, ExplainOptions& options) {
  add_render_options(app, options.render);
  app.add_option("PIXEL", options.pixel, "X,Y; 0,0 is the upper left pixel")->required();
  app.add_option("--sample", options.sample, "With several samples: which one is told in full (default 0)")
      ->option_text("K");
  app.add_flag("--json", options.json, "For programs: all samples and primitives");
}

}  // namespace

Command explain_command() {
  const auto options = std::make_shared<ExplainOptions>();
  return {.name = "explain",
          .summary = "Why a pixel of a scene's picture is what it is",
          .footer = kFooter,
          .examples = {"lodestone explain sphere 640,360", "lodestone explain model.glb 100,200 --size 512x512 --json",
                       "lodestone explain alpha 640,360 --samples 4 --sample 2"},
          .add_options = [options](CLI::App& app) { add_options(app, *options); },
          .run =
              [options](const CommonOptions& common, const Streams& streams) {
                explain(*options, common, streams);
                return Status::done;
              }};
}

}  // namespace lode::experiments
