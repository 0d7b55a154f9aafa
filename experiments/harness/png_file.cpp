#include "experiments/harness/png_file.h"

#include "experiments/whole_file.h"
#include "geometry/image_file.h"

namespace lode::experiments {

void write_png(const std::string& path, glm::ivec2 size_px, std::span<const glm::u8vec4> colors) {
  WholeFile file(path);
  geometry::write_color(file.file(), geometry::ImageFormat::png, size_px, colors);
  publish({&file});
}

}  // namespace lode::experiments
