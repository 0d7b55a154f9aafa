// The fast pipeline against the reference, byte for byte: a few hundred random frames, and every target, thread count
// and skip on a few of them. fast_equality_stress.cpp has the full counts.
#include "fast_equality.h"

#include <gtest/gtest.h>

namespace lode::raster::test {
namespace {

TEST(FastEquality, OfRandomFramesWithTheReference) {
  FrameMemory memory;
  for (std::uint64_t seed = 0; seed < 250; ++seed) expect_same_as_reference(seed, FrameSize::one_tile, memory);
}

TEST(FastEquality, OfRandomFramesOfSeveralTilesWithTheReference) {
  FrameMemory memory;
  for (std::uint64_t seed = 0; seed < 4; ++seed) expect_same_as_reference(seed, FrameSize::several_tiles, memory);
}

TEST(FastEquality, OnEveryTargetWithAnyThreadsAndSkips) {
  FrameMemory memory;
  for (std::uint64_t seed = 1000; seed < 1003; ++seed) expect_same_every_way(seed, FrameSize::one_tile, memory);
}

}  // namespace
}  // namespace lode::raster::test
