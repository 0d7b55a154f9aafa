// Frames of several tiles on many threads, again and again: the same bytes and counters. The tsan preset runs this
// under a scheduler that yields at random (parallel_std.cpp).
#include <thread>

#include "fast_equality.h"

namespace lode::raster::test {
namespace {

TEST(FastThreads, GiveTheSameBytesAndCountersInAnyOrder) {
  for (const std::uint64_t seed : {21u, 22u, 23u}) {
    const OwnedFrame frame = random_frame(seed, FrameSize::several_tiles);
    Image one = frame.image(), many = frame.image();
    const std::string counters = text_of(frame.render(one, {.threads = 1}));
    FrameMemory memory;
    RenderOptions options;
    options.memory = &memory;
    for (int k = 0; k < 5; ++k) {
      options.threads = kThreads[std::size_t(k) % kThreads.size()];
      EXPECT_EQ(text_of(frame.render(many, options)), counters) << seed << ", " << options.threads << " threads";
      EXPECT_EQ(first_difference(many, one), "") << seed << ", " << options.threads << " threads";
    }
  }
}

// One memory a caller: two frames at a time from two threads of the application.
TEST(FastThreads, OfTheApplicationMayEachRenderWithAMemoryOfTheirOwn) {
  const OwnedFrame frame = random_frame(27, FrameSize::several_tiles);
  Image right = frame.image();
  frame.render(right, {.threads = 1});
  std::array<std::string, 2> differences;
  const auto render_often = [&](std::size_t k) {
    FrameMemory memory;
    Image image = frame.image();
    for (int i = 0; i < 4; ++i) {
      RenderOptions options;
      options.threads = 3, options.memory = &memory;
      frame.render(image, options);
      differences[k] += first_difference(image, right);
    }
  };
  std::thread other(render_often, 1);
  render_often(0);
  other.join();
  EXPECT_EQ(differences[0] + differences[1], "");
}

}  // namespace
}  // namespace lode::raster::test
