#pragma once
/// What a command that makes a picture writes: --out, --depth, --ids and --stats. All of it appears whole, together, or
/// not at all.

#include <iosfwd>
#include <optional>
#include <string>
#include <vector>

#include "experiments/whole_file.h"
#include "geometry/image_file.h"
#include "raster/image.h"

namespace CLI {
class App;
}

namespace lode::experiments {

/// Paths as they stand on the command line.
struct OutputPaths {
  std::optional<std::string> out{}, depth{}, ids{};  ///< image files
  std::optional<std::string> stats{};                ///< a path, or "-" for standard output
};

void add_output_options(CLI::App& app, OutputPaths& paths, const std::string& stats_help);

/// Throws Error (wrong_usage): an ending that cannot hold the picture, or a file that is named twice, `input` (what the
/// command reads; "-" is standard input) and another file that it writes included.
void check_output_paths(const OutputPaths& paths, const std::string& input,
                        const std::optional<std::string>& another = {});

/// Throws Error (wrong_usage) if an output would replace one of the files that the scene was read from.
void refuse_to_replace(const std::vector<std::string>& files_read, const OutputPaths& paths,
                       const std::optional<std::string>& another = {});

class OutputFiles {
 public:
  /// Makes the temporary files: a place that cannot be written is known before any work is done.
  explicit OutputFiles(const OutputPaths& paths);

  /// The planes that are asked for; --stats, which hashes all there are, is up to the command.
  [[nodiscard]] raster::Planes planes() const;

  /// Writes the planes asked for; the image has them. Linear colours become straight-alpha sRGB bytes in a .png file:
  /// one encode, alpha as it is. Bytes are written as they are.
  void write(const raster::Image& image);

  /// To its file, or as it is to `out`.
  void write_stats(const std::string& json, std::ostream& out);

  /// All files appear, `another` one with them. Throws Error (machine_failed) before any does where `out` could not
  /// take all that it was given.
  void publish(std::ostream& out, WholeFile* another = nullptr);

 private:
  struct ImageOutput {
    std::optional<WholeFile> file;
    geometry::ImageFormat format{};
    [[nodiscard]] WholeFile* get() { return file ? &*file : nullptr; }
  };
  static void open(const std::optional<std::string>& path, ImageOutput& output);
  void write_color(const raster::Image& image);

  ImageOutput color_, depth_, ids_;
  std::optional<WholeFile> stats_;
};

}  // namespace lode::experiments
