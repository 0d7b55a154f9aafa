#include "experiments/render/render_command.h"

#include <CLI/CLI.hpp>
#include <memory>

#include "experiments/render/render.h"

namespace lode::experiments {
namespace {

constexpr const char* kFooter =
    "Built-in scenes and their parameters: lodestone list scenes. Units are the scene's own; y is up.\n"
    "\n"
    "Files: colour .png (8 bit, straight alpha), .exr (float, premultiplied), .npy (the target as it is: float32\n"
    "linear premultiplied, or uint8 with --color-space raw); depth and ids .exr, .npy. Row 0 is the top. Depth is 1\n"
    "near, 0 far or nothing: n/d at view distance d with an infinite far plane, n(f-d)/(d(f-n)) with a finite one,\n"
    "(f-d)/(f-n) orthographic. Ids are the instance and the primitive in its mesh as the file has it, 4294967295\n"
    "twice where nothing was drawn. Outputs appear whole, together, or not at all; without any the scene is only\n"
    "checked.\n"
    "\n"
    "Lit surfaces are Lambert under one light that stands still in the world, towards (3, 6, 4), with a quarter of\n"
    "ambient light. Masked materials are alpha-tested; blended ones are drawn over the rest in the file's order.\n"
    "\n"
    "--stats has, as JSON: frame_ms (median, min, max of the frames of --repeat, each from clear to finished image,\n"
    "after one warm-up), prepare_ms (once per scene: colours, textures with mips, clusters of triangles), the\n"
    "renderer's counters, and the SHA-256 of each plane. Timed frames have colour and depth, and ids only with --ids.\n"
    "Every frame renders as if its camera were new, but for techniques that keep pictures from frame to frame: what\n"
    "they do after some frames of an orbit is seen with --after.\n";

}  // namespace

void add_render_options(CLI::App& app, RenderOptions& options) {
  add_scene_options(app, options.scene);
  add_look_options(app, options.look);
  app.add_flag("--no-color", options.no_color, "Depth and ids only");
  add_output_options(app, options.outputs, "Times, counters and hashes, as JSON to F (- is standard output)");
  app.add_option("--repeat", options.repeat, "Frames that are rendered and timed (default 1)")->option_text("N");
  app.add_option("--orbit", options.orbit,
                 "Turn the camera about the scene's centre from frame to frame; outputs are of the first")
      ->option_text("DEG");
  app.add_option("--after", options.after, "Frames of the orbit to draw before the first (default 0)")
      ->option_text("N");
}

Command render_command() {
  const auto options = std::make_shared<RenderOptions>();
  return {.name = "render",
          .summary = "Draw a scene: colour, depth, ids, times",
          .footer = kFooter,
          .examples = {"lodestone render model.glb --out picture.png",
                       "lodestone render sphere:segments=200 --eye 3,2,4 --look-at 0,0,0 --fov 30 --out sphere.png",
                       "lodestone render model.gltf --camera 0 --size 512x512 --depth depth.exr --ids ids.npy",
                       "lodestone render terrain --clear 0.5,0.7,0.9,1 --samples 16 --out terrain.png",
                       "lodestone render spheres --repeat 20 --orbit 5 --stats -",
                       "lodestone render houses24 --technique image_reuse --orbit 0.1 --after 10 --out later.png"},
          .add_options = [options](CLI::App& app) { add_render_options(app, *options); },
          .run =
              [options](const CommonOptions& common, const Streams& streams) {
                render(*options, common, streams);
                return Status::done;
              }};
}

}  // namespace lode::experiments
