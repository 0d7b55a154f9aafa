// The pictures of the determinism product, and one frame with everything, byte for byte by both pipelines.
#include <algorithm>
#include <atomic>

#include "everything.h"
#include "fast_equality.h"
#include "tests/determinism/pictures.h"

namespace lode::raster::test {
namespace {

std::string difference_of(const Frame& frame, Image fast, const RenderOptions& fast_options) {
  Image reference = fast;
  render(frame, fast, fast_options);
  RenderOptions options;
  options.threads = 1, options.pipeline = Pipeline::reference;
  render(frame, reference, options);
  return first_difference(fast, reference);
}

void expect_everything_is_the_references(glm::ivec2 size_px, ColorFormat format) {
  SmallScene scene(size_px, format);
  add_everything(scene);
  scene.frame.draws = scene.draws;
  for (const Target target : kTargets) {
    if (!can_run(target)) continue;
    RenderOptions options;
    options.threads = 2, options.target = target;
    EXPECT_EQ(difference_of(scene.frame, scene.image, options), "") << name_of(target);
  }
}

TEST(FastPictures, OfTheDeterminismProductAreTheReferences) {
  FrameMemory memory;
  RenderOptions options;
  options.memory = &memory;
  for (const pictures::Picture& picture : pictures::all_pictures()) {
    for (const int threads : {1, 3}) {
      options.threads = threads;
      EXPECT_EQ(difference_of(picture.frame(), picture.image(), options), "") << picture.name << ", " << threads;
    }
  }
}

TEST(FastPictures, OfTheFrameWithEverythingAreTheReferences) {
  for (const ColorFormat format : {ColorFormat::rgba8, ColorFormat::rgba32f}) {
    expect_everything_is_the_references({150, 90}, format);
  }
}

// More than a million pixels, whole lines of the cache a row: written past the caches.
TEST(FastPictures, OfAnImageThatIsStreamedAreTheReferences) {
  expect_everything_is_the_references({1216, 903}, ColorFormat::rgba8);
}

TEST(FastPictures, OfNothingInViewAreTheClearOfEveryPlane) {
  const std::vector<glm::vec3> beside = {{3, 0, 0.5f}, {4, 0, 0.5f}, {3, 1, 0.5f}};
  const Clusters clusters = make_clusters(beside, std::nullopt);
  for (const ColorFormat format : {ColorFormat::rgba8, ColorFormat::rgba32f}) {
    SmallScene scene({301, 203}, format);
    Draw draw;
    draw.vertices = ObjectVertices{beside, glm::dmat4(1.0)};
    draw.clusters = &clusters;
    scene.frame.draws = {&draw, 1};
    scene.frame.clear = {0.25f, 0.5f, 0.75f, 1.0f};
    if (format == ColorFormat::rgba8) scene.frame.clear *= 255.0f;
    std::ranges::fill(scene.image.depth, 0.5f);  // of an earlier frame
    std::atomic<int> n_tiles = 0;
    RenderOptions options;
    options.threads = 2, options.on_tile = [&] { ++n_tiles; };
    EXPECT_EQ(difference_of(scene.frame, scene.image, options), "");
    EXPECT_EQ(n_tiles, 3 * 2);
  }
}

TEST(FastPictures, AreTheSameWithAMemoryThatWasUsedForAnotherSizeAndFormat) {
  FrameMemory memory;
  RenderOptions options;
  options.threads = 2, options.memory = &memory;
  for (const std::uint64_t seed : {11u, 12u, 13u, 14u, 15u, 16u}) {
    const OwnedFrame frame = random_frame(seed, seed % 2 == 0 ? FrameSize::several_tiles : FrameSize::one_tile);
    Image fresh = frame.image(), used = frame.image();
    frame.render(fresh, {.threads = 1});
    frame.render(used, options);
    EXPECT_EQ(first_difference(used, fresh), "") << seed;
  }
}

}  // namespace
}  // namespace lode::raster::test
