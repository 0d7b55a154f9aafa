#pragma once
/// One random frame drawn by the fast pipeline and by the reference.

#include <gtest/gtest.h>

#include <array>

#include "fast_difference.h"
#include "random_frame.h"
#include "small_scene.h"

namespace lode::raster::test {

inline constexpr std::array kTargets = {Target::scalar, Target::sse4, Target::avx2,
                                        Target::avx512, Target::neon, Target::wasm};
inline constexpr std::array kThreads = {1, 2, 3, 7, 16};

/// All on, all off, each one off by itself.
[[nodiscard]] inline std::vector<Skips> ways_to_skip() {
  std::vector<Skips> ways(7);
  ways[1] = {false, false, false, false, false};
  ways[2].frustum = ways[3].facing = ways[4].occlusion = ways[5].samples = ways[6].blocks = false;
  return ways;
}

/// True if the best target on two threads gives the reference's bytes.
inline bool expect_same_as_reference(std::uint64_t seed, FrameSize size, FrameMemory& memory) {
  RenderOptions options;
  options.threads = 2, options.memory = &memory;
  const std::string difference = bisected_difference(random_frame(seed, size), options);
  EXPECT_TRUE(difference.empty()) << "random_frame(" << seed << ", FrameSize(" << int(size) << "))\n" << difference;
  return difference.empty();
}

/// True if every target, number of threads and choice of skips gives the reference's bytes, and the counters depend on
/// the skips alone.
inline bool expect_same_every_way(std::uint64_t seed, FrameSize size, FrameMemory& memory) {
  const OwnedFrame frame = random_frame(seed, size);
  Image reference = frame.image(), fast = frame.image();
  RenderOptions options;
  options.threads = 1, options.pipeline = Pipeline::reference;
  frame.render(reference, options);
  options.pipeline = Pipeline::fast, options.memory = &memory;
  for (const Skips& skips : ways_to_skip()) {
    options.skips = skips;
    std::string first_counters;
    for (const Target target : kTargets) {
      if (!can_run(target)) continue;
      options.target = target;
      for (const int threads : kThreads) {
        options.threads = threads;
        const std::string counters = text_of(frame.render(fast, options));
        if (first_counters.empty()) first_counters = counters;
        const bool same = first_difference(fast, reference).empty();
        if (same && counters == first_counters) continue;
        EXPECT_EQ(counters, first_counters) << "seed " << seed << ", " << threads << " threads, " << name_of(target);
        const std::string difference = bisected_difference(frame, options);
        EXPECT_TRUE(difference.empty()) << "random_frame(" << seed << ", FrameSize(" << int(size) << ")), "
                                        << name_of(target) << ", " << threads << " threads, skips " << skips.frustum
                                        << skips.facing << skips.occlusion << skips.samples << skips.blocks << "\n"
                                        << difference;
        return false;
      }
    }
  }
  return true;
}

}  // namespace lode::raster::test
