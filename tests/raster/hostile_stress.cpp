// Hostile input at size: the largest targets and textures, 10^5 coincident layers, many hostile frames.
#include <sys/resource.h>

#include <chrono>
#include <fstream>

#include "hostile_values.h"
#include "stress_count.h"

namespace lode::raster::test {
namespace {

/// Most memory this process has had, since it was started: unlike getrusage's, not its parent's before that.
double peak_mib() {
  std::ifstream status("/proc/self/status");
  for (std::string word; status >> word;) {
    if (word == "VmHWM:") {
      double kib = 0.0;
      status >> kib;
      return kib / 1024.0;
    }
  }
  rusage usage{};
  getrusage(RUSAGE_SELF, &usage);
  return double(usage.ru_maxrss) / 1024.0;
}

class Clock {
 public:
  double seconds() const { return std::chrono::duration<double>(std::chrono::steady_clock::now() - start_).count(); }

 private:
  std::chrono::steady_clock::time_point start_ = std::chrono::steady_clock::now();
};

/// Ends this process, which is a child of the test: 0 if `right` and memory stays below the limit.
[[noreturn]] void report(const char* what, bool right, double limit_mib, double seconds) {
  const double peak = peak_mib();
  std::printf("[ MEASURED ] %s: peak %.0f MiB of %.0f allowed, render %.1f s, picture %s\n", what, peak, limit_mib,
              seconds, right ? "right" : "WRONG");
  std::fflush(stdout);
  std::exit(right && peak <= limit_mib ? 0 : 1);
}

/// Exactly-placed triangle and point on the largest target of 16384² with 16 bytes a pixel.
[[noreturn]] void draw_largest_target() {
  constexpr int kSize = 16384;
  SmallScene scene({kSize, kSize});
  scene.window(Topology::triangles, {{0, 0, 0.25}, {0, kSize, 0.25}, {kSize, 0, 0.25}}).color = glm::vec4(1, 2, 3, 4);
  scene.window(Topology::points, {{kSize - 0.5, kSize - 0.5, 0.5}});
  scene.frame.draws = scene.draws;
  const Clock clock;
  render(scene.frame, scene.image, {.threads = 0});  // one pipeline, one image: its memory is measured
  const double seconds = clock.seconds();
  bool right = true;
  for (int y = 0; y < kSize; ++y) {  // the diagonal is a right edge: row y has kSize − 1 − y samples
    for (int x = 0; x < kSize; ++x) {
      const std::size_t i = std::size_t(y) * kSize + std::size_t(x);
      const bool inside = x + y < kSize - 1, last = x == kSize - 1 && y == kSize - 1;
      right = right && scene.image.ids[i] == (inside ? Ids{0, 0} : last ? Ids{1, 0} : Ids{kNoId, kNoId});
      right = right && scene.image.depth[i] == (inside ? 0.25f : last ? 0.5f : 0.0f);
      right = right && scene.image.rgba8[i] == (inside ? glm::u8vec4(1, 2, 3, 4) : glm::u8vec4(last ? 255 : 0));
    }
  }
  report("16384 x 16384 target", right, 1.3 * 16.0 * kSize * kSize / (1 << 20) + 200.0, seconds);
}

TEST(LargestTarget, IsRightAndStaysWithinItsMemory) {
  GTEST_FLAG_SET(death_test_style, "threadsafe");  // a process of its own
  EXPECT_EXIT(draw_largest_target(), testing::ExitedWithCode(0), "");
}

/// Texel (x, y) is (x/64, y/64, 7, 255). On 64×64 pixels, nearest reads texel 256·p + 128: 4·p + 2. Trilinear reads
/// level 8: blocks of 256 hold 4p … 4p + 3, rounded half up at levels 7 and 8: 4p + 2 again.
[[noreturn]] void draw_largest_texture() {
  constexpr int kSize = 16384;
  const Clock clock;
  Texture texture;
  {
    std::vector<glm::u8vec4> texels(std::size_t(kSize) * kSize);
    for (int y = 0; y < kSize; ++y) {
      for (int x = 0; x < kSize; ++x)
        texels[std::size_t(y) * kSize + std::size_t(x)] = glm::u8vec4(x / 64, y / 64, 7, 255);
    }
    texture = make_raw_texture({kSize, kSize}, texels, Mips::all);
  }
  bool right = texture.levels.size() == 15;
  for (const Filter filter : {Filter::nearest, Filter::trilinear, Filter::anisotropic}) {
    SmallScene scene({64, 64});
    Draw& draw = scene.rect({0, 0}, {64, 64}, 0.5, glm::vec4(255));
    draw.uvs = scene.keep<glm::vec2>({{0, 0}, {1, 0}, {1, 1}, {0, 1}});
    draw.texture = &texture;
    draw.sampler.filter = filter;
    scene.render({.threads = 1});
    for (int i = 0; i < 64 * 64; ++i) {
      right = right && scene.image.rgba8[std::size_t(i)] == glm::u8vec4(4 * (i % 64) + 2, 4 * (i / 64) + 2, 7, 255);
    }
  }
  // The caller's texels and the texture with its mips.
  report("16384 x 16384 texture", right, (1.0 + 4.0 / 3.0) * 4.0 * kSize * kSize / (1 << 20) + 200.0, clock.seconds());
}

TEST(LargestTexture, IsReadRightAtEveryLevel) {
  GTEST_FLAG_SET(death_test_style, "threadsafe");
  EXPECT_EXIT(draw_largest_texture(), testing::ExitedWithCode(0), "");
}

TEST(CoincidentLayersStress, GoToTheLowestKey) {
  SmallScene scene({64, 64});
  add_layers(scene, 64);
  const Clock clock;
  const FrameStats stats = scene.render({.threads = 0, .tile_size_px = 32});
  std::printf("[ MEASURED ] %zu layers of 64 x 64: %.1f s\n", kLayers, clock.seconds());
  EXPECT_EQ(stats.fragments_covered, 64 * 64 * kLayers);
  EXPECT_EQ(stats.fragments_shaded, 64u * 64u);
  EXPECT_EQ(scene.image.ids, PixelPlane<Ids>(64 * 64, Ids{0, 0}));
}

TEST(CoincidentLayersStress, AreAllBlended) {
  SmallScene scene({16, 16}, ColorFormat::rgba32f);
  Draw& draw = add_layers(scene, 16);
  draw.blend = Blend::add;
  draw.color = glm::vec4(0x1p-17f, 1.0f, 3.0f, 0.0f);
  const Clock clock;
  scene.render({.threads = 0, .tile_size_px = 8});
  std::printf("[ MEASURED ] %zu blended layers of 16 x 16: %.1f s\n", kLayers, clock.seconds());
  const float n = float(kLayers);
  EXPECT_EQ(scene.image.rgba32f, PixelPlane<glm::vec4>(256, glm::vec4(n * 0x1p-17f, n, 3 * n, 0)));
}

TEST(HostileFramesStress, GiveSoundPicturesThatDoNotDependOnThreadsOrTiles) {
  draw_hostile_frames(stress_count("hostile frames", 50'000, 5'000'000), 2);
}

}  // namespace
}  // namespace lode::raster::test
