#include "experiments/output_files.h"

#include <CLI/CLI.hpp>
#include <filesystem>
#include <ostream>
#include <span>
#include <vector>

#include "experiments/display_bytes.h"
#include "experiments/error.h"

namespace lode::experiments {
namespace {

void check_ending(const char* option, const std::optional<std::string>& path, bool png_too) {
  if (!path) return;
  const auto format = geometry::image_format(*path);
  if (format && (png_too || *format != geometry::ImageFormat::png)) return;
  throw Error(Status::wrong_usage, std::string(option) + " " + *path + ": expected a file ending in " +
                                       (png_too ? ".png, .exr or .npy" : ".exr or .npy"));
}

std::span<const std::uint32_t> as_numbers(std::span<const raster::Ids> ids) {
  static_assert(sizeof(raster::Ids) == 2 * sizeof(std::uint32_t));
  return {reinterpret_cast<const std::uint32_t*>(ids.data()), 2 * ids.size()};
}

}  // namespace

void add_output_options(CLI::App& app, OutputPaths& paths, const std::string& stats_help) {
  app.add_option("--out", paths.out, "Colour to F (.png, .exr, .npy)")->option_text("F");
  app.add_option("--depth", paths.depth, "Depth to F (.exr, .npy)")->option_text("F");
  app.add_option("--ids", paths.ids, "Draw and primitive of each pixel to F (.exr, .npy)")->option_text("F");
  app.add_option("--stats", paths.stats, stats_help)->option_text("F|-");
}

void check_output_paths(const OutputPaths& paths, const std::string& input, const std::optional<std::string>& another) {
  check_ending("--out", paths.out, true);
  check_ending("--depth", paths.depth, false);
  check_ending("--ids", paths.ids, false);

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
  check(input);
  for (const auto* path : {&paths.out, &paths.depth, &paths.ids, &paths.stats, &another}) {
    if (*path) check(**path);
  }
}

void refuse_to_replace(const std::vector<std::string>& files_read, const OutputPaths& paths,
                       const std::optional<std::string>& another) {
  for (const auto* path : {&paths.out, &paths.depth, &paths.ids, &paths.stats, &another}) {
    if (!*path || **path == "-") continue;
    for (const std::string& file : files_read) {
      std::error_code not_there;
      if (!std::filesystem::equivalent(**path, file, not_there)) continue;
      throw Error(Status::wrong_usage,
                  **path + ": the scene is read from this file: expected another place for the output");
    }
  }
}

OutputFiles::OutputFiles(const OutputPaths& paths) {
  open(paths.out, color_);
  open(paths.depth, depth_);
  open(paths.ids, ids_);
  if (paths.stats && paths.stats != "-") stats_.emplace(*paths.stats);
}

raster::Planes OutputFiles::planes() const {
  return {.color = color_.file.has_value(), .depth = depth_.file.has_value(), .ids = ids_.file.has_value()};
}

void OutputFiles::write(const raster::Image& image) {
  if (color_.file) write_color(image);
  if (depth_.file) geometry::write_depth(depth_.file->file(), depth_.format, image.size_px, image.depth);
  if (ids_.file) geometry::write_ids(ids_.file->file(), ids_.format, image.size_px, as_numbers(image.ids));
}

void OutputFiles::write_color(const raster::Image& image) {
  geometry::OutputFile& file = color_.file->file();
  if (image.format == raster::ColorFormat::rgba8) {
    geometry::write_color(file, color_.format, image.size_px, image.rgba8);
  } else if (color_.format != geometry::ImageFormat::png) {
    geometry::write_color(file, color_.format, image.size_px, image.rgba32f);
  } else {
    geometry::write_color(file, color_.format, image.size_px, display_bytes(image.rgba32f));
  }
}

void OutputFiles::write_stats(const std::string& json, std::ostream& out) {
  if (stats_) {
    stats_->file().write(json.data(), json.size());
  } else {
    out << json;
  }
}

void OutputFiles::publish(std::ostream& out, WholeFile* another) {
  out << std::flush;
  if (!out) throw Error(Status::machine_failed, "standard output: cannot be written");
  experiments::publish({color_.get(), depth_.get(), ids_.get(), stats_ ? &*stats_ : nullptr, another});
}

void OutputFiles::open(const std::optional<std::string>& path, ImageOutput& output) {
  if (!path) return;
  output.format = *geometry::image_format(*path);
  output.file.emplace(*path);
}

}  // namespace lode::experiments
