#include "experiments/make_target.h"

#include <unistd.h>

#include <algorithm>
#include <fstream>
#include <limits>

#include "experiments/error.h"

namespace lode::experiments {

std::uint64_t machine_memory_bytes() {
  const long pages = ::sysconf(_SC_PHYS_PAGES), page_bytes = ::sysconf(_SC_PAGESIZE);
  std::uint64_t bytes = std::numeric_limits<std::uint64_t>::max();
  if (pages > 0 && page_bytes > 0) bytes = std::uint64_t(pages) * std::uint64_t(page_bytes);
  std::ifstream group("/sys/fs/cgroup/memory.max");  // a number, or "max"
  std::uint64_t limit = 0;
  if (group >> limit) bytes = std::min(bytes, limit);
  return bytes;
}

raster::Image make_target(glm::ivec2 size_px, raster::ColorFormat format, raster::Planes planes) {
  const std::uint64_t color_bytes = format == raster::ColorFormat::rgba8 ? 4 : 16;
  const std::uint64_t pixel_bytes =
      (planes.color ? color_bytes : 0) + (planes.depth ? 4 : 0) + (planes.ids ? sizeof(raster::Ids) : 0);
  const std::uint64_t n_px = std::uint64_t(std::max(size_px.x, 0)) * std::uint64_t(std::max(size_px.y, 0));
  const std::uint64_t memory = machine_memory_bytes();
  if (pixel_bytes > 0 && n_px > memory / pixel_bytes) {
    throw Error(Status::machine_failed, "out of memory: " + std::to_string(size_px.x) + " x " +
                                            std::to_string(size_px.y) + " pixels take " +
                                            std::to_string((n_px * pixel_bytes) >> 30) + " GiB, this machine has " +
                                            std::to_string(memory >> 30));
  }
  return raster::make_image(size_px, format, planes);
}

}  // namespace lode::experiments
