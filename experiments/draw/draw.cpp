#include "experiments/draw/draw.h"

#include <istream>
#include <ostream>
#include <span>
#include <vector>

#include "experiments/draw/draw_stats.h"
#include "experiments/draw/picture.h"
#include "experiments/draw/print_picture.h"
#include "experiments/draw/read_picture.h"
#include "experiments/error.h"
#include "experiments/make_target.h"
#include "raster/error.h"
#include "raster/parallel.h"
#include "raster/render.h"

namespace lode::experiments {
namespace {

void check_usage(const DrawOptions& options) {
  if (options.print && options.outputs.stats == "-") {
    throw Error(Status::wrong_usage, "--print --stats -: two outputs on one standard output");
  }
  check_output_paths(options.outputs, options.picture);
}

/// What errors call the picture.
std::string shown_name(const DrawOptions& options) {
  return options.picture == "-" ? "standard input" : options.picture;
}

/// What can be wrong only when both the picture and the options are known.
void check_picture(const DrawOptions& options, const Picture& picture) {
  if (picture.samples_fx8.size() > 1 && (options.outputs.depth || options.outputs.ids || options.print)) {
    throw Error(Status::wrong_usage, shown_name(options) + ": " + std::to_string(picture.samples_fx8.size()) +
                                         " samples a pixel have no depth and no ids: expected \"samples\": 1 for "
                                         "--depth, --ids and --print");
  }
  if (options.print && picture.size_px.x > kMaxPrintedColumns) {
    throw Error(Status::bad_input, shown_name(options) + ": size: --print takes at most " +
                                       std::to_string(kMaxPrintedColumns) + " columns, found " +
                                       std::to_string(picture.size_px.x));
  }
}

/// A picture with a name for errors, ready to be rendered any number of times.
struct Rendering {
  const Picture& picture;
  std::string name;
  std::vector<raster::Draw> draws;
  const CommonOptions& common;

  /// `more` has what concerns this render alone.
  raster::Image render(raster::Planes planes, const raster::RenderOptions& more, raster::FrameStats* stats) const {
    const raster::Frame frame{.draws = draws,
                              .clear = picture.clear,
                              .viewport = {},
                              .scissor = picture.scissor,
                              .samples_fx8 = picture.samples_fx8};
    raster::RenderOptions options = common.render_options();
    options.per_draw = more.per_draw;
    options.ids_from_ordered_draws = more.ids_from_ordered_draws;
    try {
      raster::Image image = make_target(picture.size_px, raster::ColorFormat::rgba8, planes);
      const raster::FrameStats counted = raster::render(frame, image, options);
      if (stats) *stats = counted;
      return image;
    } catch (const raster::Error& error) {
      const bool memory = error.kind() == raster::ErrorKind::out_of_memory;
      throw Error(memory ? Status::machine_failed : Status::bad_input, name + ": " + error.what());
    }
  }
};

}  // namespace

void draw(const DrawOptions& options, const CommonOptions& common, std::istream& in, std::ostream& out) {
  check_usage(options);

  OutputFiles files(options.outputs);
  const Picture picture = read_picture(read_text(options.picture, in), shown_name(options));
  check_picture(options, picture);
  const Rendering rendering{picture, shown_name(options), bound_draws(picture), common};

  // Text shows draws that write no ids, too: a render of its own, of ids alone.
  std::string text;
  if (options.print) {
    const raster::Image image = rendering.render({.color = false, .depth = false, .ids = true},
                                                 {.per_draw = {}, .ids_from_ordered_draws = true}, nullptr);
    text = printed_picture(picture.size_px, image.ids);
  }

  // With no output at all the picture is drawn all the same: its errors are found, nothing is written.
  raster::Planes planes = files.planes();
  if (!options.print || planes.color || planes.depth || planes.ids || options.outputs.stats) {
    // Statistics have hashes of all planes, so far as they exist.
    const bool single = picture.samples_fx8.size() == 1;
    if (options.outputs.stats) planes = {.color = true, .depth = single, .ids = single};
    DrawReport report{.picture = options.picture,
                      .threads = raster::worker_count(common.threads),
                      .pipeline = common.pipeline,
                      .target = common.target,
                      .counters = {},
                      .per_draw = {}};
    std::vector<raster::DrawStats> per_draw(picture.draws.size());
    report.per_draw = per_draw;
    const raster::Image image = rendering.render(planes, {}, &report.counters);
    // Draws are counted in a render of its own, without any plane: only the reference pipeline can.
    if (options.outputs.stats) {
      static_cast<void>(
          rendering.render({.color = false, .depth = false, .ids = false}, {.per_draw = per_draw}, nullptr));
    }
    files.write(image);
    if (options.outputs.stats) files.write_stats(draw_stats_json(report, image), out);
  }
  out << text;
  files.publish(out);
}

}  // namespace lode::experiments
