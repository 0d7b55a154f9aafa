#pragma once
/// render(frame, image) is a pure function of the frame: the same bytes for any number of threads, any tile
/// size, any processor, compiler and build type. notes/rasterization.md has the rules.

#include <cstddef>
#include <cstdint>
#include <functional>
#include <memory>
#include <span>

#include "raster/frame.h"
#include "raster/image.h"
#include "raster/stats.h"

namespace lode::raster {

/// Changes only when a rule that decides pixels changes; notes/pixel_contract.md says which pixels moved.
inline constexpr int kPixelContract = 1;

/// Two ways to the same bytes: the fast one, and the plain one that it is held against.
enum class Pipeline : std::uint8_t { fast, reference };

/// Instruction sets that the fast pipeline's kernels are built for; best: the widest that this processor has.
enum class Target : std::uint8_t { best, scalar, sse4, avx2, avx512, neon, wasm };
[[nodiscard]] const char* name_of(Target target);
/// True if this build has the target and this processor can run it; `best` always can.
[[nodiscard]] bool can_run(Target target);
/// What `best` stands for here.
[[nodiscard]] Target best_target();

/// What the fast pipeline need not do, each to be switched off for comparison. None moves a pixel.
struct Skips {
  bool frustum = true;    ///< clusters outside the view or the tile
  bool facing = true;     ///< clusters that face away as a whole
  bool occlusion = true;  ///< clusters behind what is drawn already
  bool samples = true;    ///< triangles without a sample, before their set-up
  bool blocks = true;     ///< blocks of samples beside a triangle, or in front of it
};

/// What one frame leaves for the next: memory, no contents. One frame at a time may use it.
class FrameMemory {
 public:
  FrameMemory();
  ~FrameMemory();
  FrameMemory(FrameMemory&&) noexcept;
  FrameMemory& operator=(FrameMemory&&) noexcept;

  struct Parts;
  std::unique_ptr<Parts> parts;  ///< of the fast pipeline
};

/// Neither the number of threads nor the tile size, pipeline, target or skips move a pixel.
struct RenderOptions {
  int threads = 0;        ///< 0: one per processor; at most 256 are used
  int tile_size_px = 64;  ///< of the reference pipeline: 8…256, a power of two; the fast one's is fixed
  Pipeline pipeline = Pipeline::fast;
  Target target = Target::best;  ///< bad input if it cannot run here
  Skips skips = {};
  FrameMemory* memory = nullptr;  ///< null: the frame's own. Kept, it saves frames like those before all allocations
  std::span<DrawStats> per_draw = {};   ///< empty, or one element a draw, overwritten
  bool ids_from_ordered_draws = false;  ///< draws that write no depth leave their ids too (for `draw --print`)
  /// Called once for each finished tile, from any worker; must not throw. n_tiles(…) says how many there are.
  std::function<void()> on_tile = {};
};

/// Side of the fast pipeline's tiles. Counters depend on it, so it is fixed.
inline constexpr int kFastTile_px = 128;

/// Tiles that a picture of this size is drawn in.
[[nodiscard]] inline std::size_t n_tiles(glm::ivec2 size_px, const RenderOptions& options) {
  const int tile = options.pipeline == Pipeline::fast ? kFastTile_px : options.tile_size_px;
  return std::size_t((size_px.x + tile - 1) / tile) * std::size_t((size_px.y + tile - 1) / tile);
}

/// Clears the image and draws the frame into it. On an exception the image is as it was before.
/// Throws Error: bad_input (the message names draw and element), out_of_memory.
FrameStats render(const Frame& frame, Image& image, const RenderOptions& options = {});

}  // namespace lode::raster
