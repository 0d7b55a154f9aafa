#include "raster/render.h"

#include <new>

#include "raster/error.h"
#include "raster/fast/kernels.h"
#include "raster/fast/pipeline.h"
#include "raster/fp_environment.h"
#include "raster/reference/pipeline.h"
#include "raster/validate.h"

namespace lode::raster {

const char* name_of(Target target) {
  constexpr const char* kNames[] = {"best", "scalar", "sse4", "avx2", "avx512", "neon", "wasm"};
  return kNames[std::size_t(target)];
}

bool can_run(Target target) { return fast::find_kernels(target) != nullptr; }

Target best_target() { return fast::find_kernels(Target::best)->target; }

FrameStats render(const Frame& frame, Image& image, const RenderOptions& options) {
  const FpEnvironment environment;
  validate(frame, image, options);
  try {
    return options.pipeline == Pipeline::fast ? fast::render_fast(frame, image, options)
                                              : reference::render_reference(frame, image, options);
  } catch (const std::bad_alloc&) {
    throw Error(ErrorKind::out_of_memory, "out of memory for a frame of %zu draws on %d x %d pixels", frame.draws.size(),
                image.size_px.x, image.size_px.y);
  }
}

}  // namespace lode::raster
