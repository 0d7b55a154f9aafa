#include "raster/render.h"

#include <new>

#include "raster/error.h"
#include "raster/fp_environment.h"
#include "raster/reference/pipeline.h"
#include "raster/validate.h"

namespace lode::raster {

FrameStats render(const Frame& frame, Image& image, const RenderOptions& options) {
  const FpEnvironment environment;
  validate(frame, image, options);
  try {
    return reference::render_reference(frame, image, options);
  } catch (const std::bad_alloc&) {
    throw Error(ErrorKind::out_of_memory, "out of memory for a frame of %zu draws on %d x %d pixels", frame.draws.size(),
                image.size_px.x, image.size_px.y);
  }
}

}  // namespace lode::raster
