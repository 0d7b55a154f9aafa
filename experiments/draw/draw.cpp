#include "experiments/draw/draw.h"

#include <filesystem>
#include <istream>
#include <ostream>
#include <span>
#include <vector>

#include "experiments/draw/draw_stats.h"
#include "experiments/draw/picture.h"
#include "experiments/draw/print_picture.h"
#include "experiments/draw/read_picture.h"
#include "experiments/error.h"
#include "experiments/whole_file.h"
#include "geometry/image_file.h"
#include "raster/error.h"
#include "raster/parallel.h"
#include "raster/render.h"

namespace lode::experiments {
namespace {

/// An image file to be written, or nothing.
struct ImageOutput {
  std::optional<WholeFile> file;
  geometry::ImageFormat format{};
  explicit operator bool() const { return file.has_value(); }
  WholeFile* get() { return file ? &*file : nullptr; }
};

void open(const std::optional<std::string>& path, ImageOutput& output) {
  if (!path) return;
  output.format = *geometry::image_format(*path);
  output.file.emplace(*path);
}

void check_ending(const char* option, const std::optional<std::string>& path, bool png_too) {
  if (!path) return;
  const auto format = geometry::image_format(*path);
  if (format && (png_too || *format != geometry::ImageFormat::png)) return;
  throw Error(Status::wrong_usage, std::string(option) + " " + *path + ": expected a file ending in " +
                                       (png_too ? ".png, .exr or .npy" : ".exr or .npy"));
}

/// No file is named twice, the picture itself included.
void check_distinct(const DrawOptions& options) {
  std::vector<std::filesystem::path> seen;
  const auto check = [&](const std::string& path) {
    if (path == "-") return;
    std::error_code error;
    const auto resolved = std::filesystem::weakly_canonical(std::filesystem::absolute(path, error), error);
    for (const auto& other : seen) {
      if (other != resolved) continue;
      throw Error(Status::wrong_usage, path + ": named twice: expected a file of its own for each");
    }
    seen.push_back(resolved);
  };
  check(options.picture);
  for (const auto* path : {&options.out, &options.depth, &options.ids, &options.stats}) {
    if (*path) check(**path);
  }
}

void check_usage(const DrawOptions& options) {
  if (options.print && options.stats == "-") {
    throw Error(Status::wrong_usage, "--print --stats -: two outputs on one standard output");
  }
  check_ending("--out", options.out, true);
  check_ending("--depth", options.depth, false);
  check_ending("--ids", options.ids, false);
  check_distinct(options);
}

/// What errors call the picture.
std::string shown_name(const DrawOptions& options) {
  return options.picture == "-" ? "standard input" : options.picture;
}

/// What can be wrong only when both the picture and the options are known.
void check_picture(const DrawOptions& options, const Picture& picture) {
  if (picture.samples_fx8.size() > 1 && (options.depth || options.ids || options.print)) {
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
  int threads;

  raster::Image render(raster::Planes planes, raster::RenderOptions options, raster::FrameStats* stats) const {
    const raster::Frame frame{.draws = draws,
                              .clear = picture.clear,
                              .viewport = {},
                              .scissor = picture.scissor,
                              .samples_fx8 = picture.samples_fx8};
    options.threads = threads;
    try {
      raster::Image image = raster::make_image(picture.size_px, raster::ColorFormat::rgba8, planes);
      const raster::FrameStats counted = raster::render(frame, image, options);
      if (stats) *stats = counted;
      return image;
    } catch (const raster::Error& error) {
      const bool memory = error.kind() == raster::ErrorKind::out_of_memory;
      throw Error(memory ? Status::machine_failed : Status::bad_input, name + ": " + error.what());
    }
  }
};

std::span<const std::uint32_t> as_numbers(const std::vector<raster::Ids>& ids) {
  static_assert(sizeof(raster::Ids) == 2 * sizeof(std::uint32_t));
  return {reinterpret_cast<const std::uint32_t*>(ids.data()), 2 * ids.size()};
}

}  // namespace

void draw(const DrawOptions& options, const CommonOptions& common, std::istream& in, std::ostream& out) {
  check_usage(options);

  // Temporary files first: a place that cannot be written is known before any work is done.
  ImageOutput color, depth, ids;
  std::optional<WholeFile> stats_file;
  open(options.out, color);
  open(options.depth, depth);
  open(options.ids, ids);
  if (options.stats && options.stats != "-") stats_file.emplace(*options.stats);

  const Picture picture = read_picture(read_text(options.picture, in), shown_name(options));
  check_picture(options, picture);
  const Rendering rendering{picture, shown_name(options), bound_draws(picture), common.threads};

  // Text shows draws that write no ids, too: a render of its own, of ids alone.
  std::string text;
  if (options.print) {
    const raster::Image image = rendering.render({.color = false, .depth = false, .ids = true},
                                                 {.per_draw = {}, .ids_from_ordered_draws = true}, nullptr);
    text = printed_picture(picture.size_px, image.ids);
  }

  // With no output at all the picture is drawn all the same: its errors are found, nothing is written.
  if (!options.print || color || depth || ids || options.stats) {
    // Statistics have hashes of all planes, so far as they exist.
    const bool all = options.stats.has_value();
    const bool single = picture.samples_fx8.size() == 1;
    DrawReport report{
        .picture = options.picture, .threads = raster::worker_count(common.threads), .counters = {}, .per_draw = {}};
    std::vector<raster::DrawStats> per_draw(picture.draws.size());
    report.per_draw = per_draw;
    const raster::Image image =
        rendering.render({.color = all || color, .depth = single && (all || depth), .ids = single && (all || ids)},
                         {.per_draw = per_draw}, &report.counters);

    if (color) geometry::write_color(color.file->file(), color.format, image.size_px, image.rgba8);
    if (depth) geometry::write_depth(depth.file->file(), depth.format, image.size_px, image.depth);
    if (ids) geometry::write_ids(ids.file->file(), ids.format, image.size_px, as_numbers(image.ids));
    if (options.stats) {
      const std::string json = draw_stats_json(report, image);
      if (stats_file) {
        stats_file->file().write(json.data(), json.size());
      } else {
        text = json;
      }
    }
  }

  out << text << std::flush;
  if (!out) throw Error(Status::machine_failed, "standard output: cannot be written");
  publish({color.get(), depth.get(), ids.get(), stats_file ? &*stats_file : nullptr});
}

}  // namespace lode::experiments
