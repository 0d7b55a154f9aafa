#pragma once
/// Random frames: a few random draws with a size, a format, a viewport, a scissor and samples, all from one seed.

#include "random_draws.h"

namespace lode::raster::test {

enum class FrameSize : std::uint8_t { one_tile, several_tiles };

/// Frame `seed`: up to six draws, at most about 200 primitives; at times a draw of several hundred without clusters.
[[nodiscard]] inline OwnedFrame random_frame(std::uint64_t seed, FrameSize size) {
  HashedNumbers random(seed);
  OwnedFrame frame;
  if (size == FrameSize::several_tiles) {
    frame.size_px = {random.between(129, 300), random.between(100, 200)};
  } else if (random.below(8) == 0) {
    frame.size_px = {random.between(1, 90), random.between(1, 90)};
  }
  if (random.below(3) == 0) frame.format = ColorFormat::rgba32f;
  const float full = frame.format == ColorFormat::rgba8 ? 255.0f : 1.0f;
  for (int c = 0; c < 4; ++c) frame.clear[c] = full * float(random.unit());
  if (random.below(6) == 0) frame.planes = {random.below(2) == 0, random.below(2) == 0, random.below(2) == 0};
  if (random.below(6) == 0) {
    frame.viewport =
        Rect{{random.between(-40, 40), random.between(-40, 40)}, {random.between(0, 200), random.between(0, 200)}};
  }
  if (random.below(8) == 0)
    frame.scissor = Rect{{random.between(-9, 20), random.between(-9, 20)}, {random.between(0, 64), 40}};
  if (random.below(6) == 0) {
    const bool several = random.below(2) == 0;
    frame.samples_fx8.resize(several ? 2 + random.below(3) : 1);
    for (glm::ivec2& s : frame.samples_fx8) s = {random.between(0, 255), random.between(0, 255)};
    if (several) frame.planes = {.color = true, .depth = false, .ids = false};
  }
  frame.ids_from_ordered_draws = random.below(8) == 0;
  const std::uint32_t n_draws = 1 + random.below(6);
  for (std::uint32_t d = 0; d < n_draws; ++d) {
    const std::uint32_t most = random.below(40) == 0 ? 700 : 200 / n_draws;
    frame.draws.push_back(RandomDraw(random, frame).make(most));
  }
  return frame;
}

}  // namespace lode::raster::test
