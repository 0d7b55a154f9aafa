#include "raster/image.h"

#include <new>

#include "raster/error.h"

namespace lode::raster {

Image make_image(glm::ivec2 size_px, ColorFormat format, Planes planes) {
  if (size_px.x < 0 || size_px.y < 0 || size_px.x > kMaxTargetSize_px || size_px.y > kMaxTargetSize_px) {
    throw Error(ErrorKind::bad_input, "image size %d x %d: expected 0 to %d a side", size_px.x, size_px.y,
                kMaxTargetSize_px);
  }
  const std::size_t n_px = std::size_t(size_px.x) * std::size_t(size_px.y);
  try {
    Image image{.size_px = size_px, .format = format, .rgba8 = {}, .rgba32f = {}, .depth = {}, .ids = {}};
    if (planes.color && format == ColorFormat::rgba8) image.rgba8.resize(n_px);
    if (planes.color && format == ColorFormat::rgba32f) image.rgba32f.resize(n_px);
    if (planes.depth) image.depth.resize(n_px);
    if (planes.ids) image.ids.resize(n_px, Ids{kNoId, kNoId});
    return image;
  } catch (const std::bad_alloc&) {
    throw Error(ErrorKind::out_of_memory, "out of memory for an image of %d x %d pixels", size_px.x, size_px.y);
  }
}

}  // namespace lode::raster
