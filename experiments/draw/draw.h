#pragma once
/// What `lodestone draw` does: a picture's JSON to files, text and statistics.

#include <iosfwd>
#include <string>

#include "experiments/common_options.h"
#include "experiments/output_files.h"

namespace lode::experiments {

struct DrawOptions {
  std::string picture;  ///< a path, or "-" for standard input
  OutputPaths outputs;
  bool print = false;  ///< the picture as text, to standard output
};

/// Runs the command. Throws Error, geometry::Error or raster::Error; then no output has appeared but what
/// standard output had already taken.
void draw(const DrawOptions& options, const CommonOptions& common, std::istream& in, std::ostream& out);

}  // namespace lode::experiments
