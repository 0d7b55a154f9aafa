#include "experiments/draw/draw_command.h"

#include <CLI/CLI.hpp>
#include <memory>

#include "experiments/draw/draw.h"

namespace lode::experiments {
namespace {

constexpr const char* kFooter =
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

void add_options(CLI::App& app, DrawOptions& draw) {
  app.add_option("PICTURE", draw.picture, "The picture's JSON; - is standard input")->required();
  add_output_options(app, draw.outputs,
                     "Samples covered and visible (counted by drawing once more, by the reference), counters and "
                     "hashes, as JSON to F (- is stdout)");
  app.add_flag("--print", draw.print, "The picture as text: a letter per draw, '.' for nothing");
}

}  // namespace

Command draw_command() {
  const auto options = std::make_shared<DrawOptions>();
  return {.name = "draw",
          .summary = "Draw a handful of primitives from a JSON file",
          .footer = kFooter,
          .examples = {"lodestone draw picture.json --out picture.png", "lodestone draw picture.json --print",
                       "lodestone draw picture.json --depth depth.npy --ids ids.npy --stats -",
                       "echo '{\"size\": [9, 9], \"draws\": [{\"triangles\": [[1,1,0.5], [1,8,0.5], [8,8,0.5]]}]}' |\n"
                       "    lodestone draw - --print"},
          .add_options = [options](CLI::App& app) { add_options(app, *options); },
          .run =
              [options](const CommonOptions& common, const Streams& streams) {
                draw(*options, common, streams.in, streams.out);
                return Status::done;
              }};
}

}  // namespace lode::experiments
