#include "experiments/compare/compare_command.h"

#include <CLI/CLI.hpp>
#include <memory>

#include "experiments/compare/compare.h"

namespace lode::experiments {
namespace {

constexpr const char* kFooter =
    "Pictures: PNG, JPEG, or .npy arrays of this program: colour (compared as stored 8-bit RGB, alpha ignored; linear\n"
    "floats are encoded first), depth (max, differing) and ids (differing).\n"
    "\n"
    "max: largest difference of a channel, of 255. differing: pixels. rmse: of all channels, of 255. psnr: dB, null "
    "for\n"
    "equal pictures. ssim: 11x11 Gaussian window, mean over channels; null below 11 px a side. ms-ssim: five scales;\n"
    "null below 176 px a side. flip: mean FLIP error at 67.0206 pixels per degree, 0 to 1. hdr-flip: its form for "
    "high\n"
    "dynamic range, A the reference, of two linear float arrays; only where it is named, null for colours that are "
    "not\n"
    "finite.\n"
    "\n"
    "--fail-if may be given several times; if any condition holds, the exit status is 1. The map is black where the\n"
    "pictures are equal; with --metrics flip or --metrics hdr-flip it shows that error, in the colour map magma.\n";

void add_options(CLI::App& app, CompareOptions& options) {
  app.add_option("A", options.a, "A picture")->required();
  app.add_option("B", options.b, "A picture of the same size")->required();
  app.add_option("--metrics", options.metrics,
                 "all (default), or some of max,differing,rmse,psnr,ssim,ms-ssim,flip,hdr-flip")
      ->option_text("LIST");
  app.add_option("--map", options.map, "Differences as a picture to F (.png)")->option_text("F");
  app.add_option("--fail-if", options.fail_if, "A condition that fails the comparison")
      ->option_text("METRIC<VALUE|METRIC>VALUE")
      ->allow_extra_args(false);
}

}  // namespace

Command compare_command() {
  const auto options = std::make_shared<CompareOptions>();
  return {.name = "compare",
          .summary = "How much two pictures differ",
          .footer = kFooter,
          .examples = {"lodestone compare a.png b.png", "lodestone compare a.png b.png --map difference.png",
                       "lodestone compare a.png golden.png --metrics max --fail-if 'max>0'",
                       "lodestone compare reference.png test.png --metrics flip --map flip.png",
                       "lodestone compare a.npy b.npy --fail-if 'psnr<40' --fail-if 'ssim<0.99'"},
          .add_options = [options](CLI::App& app) { add_options(app, *options); },
          .run = [options](const CommonOptions& common,
                           const Streams& streams) { return compare(*options, common.threads, streams); }};
}

}  // namespace lode::experiments
