// Counters of the fast pipeline's skips, each derived by hand; the same for any number of threads. Positions are in
// pixels, depth as it is. A flat grid of 8 × 8 cells is 128 triangles of 81 vertices: one cluster. The two triangles of
// a rectangle lie over the same box: two clusters of one triangle.
#include <gtest/gtest.h>

#include <array>

#include "fast_difference.h"
#include "random_meshes.h"
#include "small_scene.h"

namespace lode::raster::test {
namespace {

/// A frame of cluster draws, rendered with any threads: the counters must agree, and the picture is the reference's.
struct CounterScene {
  OwnedFrame frame;

  explicit CounterScene(glm::ivec2 size_px = {128, 128}) { frame.size_px = size_px; }

  OwnedDraw& add(std::vector<glm::vec3> positions, std::vector<std::uint32_t> indices = {}) {
    auto draw = std::make_shared<OwnedDraw>();
    draw->object = std::move(positions);
    draw->indexed = !indices.empty();
    draw->indices = std::move(indices);
    draw->clip_from_object = clip_from_pixels(frame.size_px);
    draw->clustered = true;
    draw->bind();
    frame.draws.push_back(draw);
    return *draw;
  }
  OwnedDraw& rect(glm::vec2 from, glm::vec2 to, float z) {
    return add({{from, z}, {from.x, to.y, z}, {to, z}, {from, z}, {to, z}, {to.x, from.y, z}});
  }
  /// 8 × 8 cells per part, parts side by side; counter-clockwise as seen.
  OwnedDraw& grids(std::vector<glm::vec2> corners, float cell_px, float z) {
    std::vector<glm::vec3> p;
    std::vector<std::uint32_t> indices;
    for (const glm::vec2 corner : corners) {
      const auto base = std::uint32_t(p.size());
      for (std::uint32_t v = 0; v < 81; ++v) p.push_back({corner + cell_px * glm::vec2(v % 9, v / 9), z});
      for (std::uint32_t c = 0; c < 64; ++c) {
        const std::uint32_t a = base + c / 8 * 9 + c % 8, b = a + 1, below = a + 9;
        for (const std::uint32_t v : {a, below, b, b, below, below + 1}) indices.push_back(v);
      }
    }
    return add(std::move(p), std::move(indices));
  }

  FrameStats render(const Skips& skips = {}) {
    RenderOptions options;
    options.threads = 1, options.skips = skips;
    EXPECT_EQ(difference_of(frame, options), "");
    Image image = frame.image();
    const FrameStats stats = frame.render(image, options);
    for (const int threads : {2, 7}) {
      options.threads = threads;
      EXPECT_EQ(text_of(frame.render(image, options)), text_of(stats)) << threads << " threads";
    }
    return stats;
  }
};

// The rectangle's draw is the nearest and opened first: 2 boxes. Then all of the ball's draw is behind it: 1 hidden.
TEST(FastCounters, AMeshBehindARectangleIsOneHiddenBox) {
  CounterScene scene;
  scene.rect({0, 0}, {128, 128}, 0.75f);
  scene.grids({{20, 20}, {60, 60}}, 4.0f, 0.5f);
  const FrameStats stats = scene.render();
  EXPECT_EQ(stats.boxes_tested, 2u);
  EXPECT_EQ(stats.boxes_hidden, 1u);
  EXPECT_EQ(stats.clusters_drawn, 2u);
  EXPECT_EQ(stats.triangles_in, 2u);
  EXPECT_EQ(stats.triangles_rasterized, 2u);
  EXPECT_EQ(stats.fragments_covered, 128u * 128u);
  // Without the skip the mesh's 2 boxes are looked at, too, and its 256 triangles drawn.
  const FrameStats all = scene.render({.occlusion = false});
  EXPECT_EQ(all.boxes_hidden, 0u);
  EXPECT_EQ(all.boxes_tested, 4u);
  EXPECT_EQ(all.triangles_in, 2u + 256u);
}

TEST(FastCounters, AMeshOutsideTheViewIsNotLookedInto) {
  CounterScene scene;
  scene.grids({{400, 20}, {300, 60}}, 4.0f, 0.5f);
  const FrameStats stats = scene.render();
  EXPECT_EQ(text_of(stats), "draws_in 1\ndraws_culled_frustum 1\nprimitives_in 256\n");  // no box, no tile
}

TEST(FastCounters, AClusterOutsideTheViewIsOneBoxOutside) {
  CounterScene scene;
  scene.grids({{20, 20}, {300, 20}}, 4.0f, 0.5f);
  const FrameStats stats = scene.render();
  EXPECT_EQ(stats.boxes_tested, 2u);
  EXPECT_EQ(stats.boxes_outside, 1u);
  EXPECT_EQ(stats.clusters_drawn, 1u);
  EXPECT_EQ(stats.triangles_in, 128u);
  EXPECT_EQ(scene.render({.frustum = false}).boxes_outside, 0u);
}

// Pixels 96…160 of a row of two tiles of 128: one cluster, drawn by both.
TEST(FastCounters, AClusterInTwoTilesCountsTwice) {
  CounterScene scene({256, 128});
  scene.grids({{96, 32}}, 8.0f, 0.5f);
  const FrameStats stats = scene.render();
  EXPECT_EQ(stats.boxes_tested, 2u);
  EXPECT_EQ(stats.clusters_drawn, 2u);
  EXPECT_EQ(stats.triangles_in, 2u * 128u);
  EXPECT_EQ(stats.tiles, 2u);
  EXPECT_EQ(stats.fragments_covered, 64u * 64u);
  // 4 of the 8 columns of cells end or begin on the border between the tiles: 64 triangles have no sample in each.
  EXPECT_EQ(stats.triangles_without_sample, 2u * 64u);
}

TEST(FastCounters, AGridThatFacesAwayIsOneBoxFacing) {
  CounterScene scene;
  scene.grids({{20, 20}}, 4.0f, 0.5f).draw.cull = Cull::front;
  const FrameStats stats = scene.render();
  EXPECT_EQ(stats.boxes_tested, 1u);
  EXPECT_EQ(stats.boxes_facing, 1u);
  EXPECT_EQ(stats.clusters_drawn, 0u);
  const FrameStats all = scene.render({.facing = false});
  EXPECT_EQ(all.boxes_facing, 0u);
  EXPECT_EQ(all.triangles_facing, 128u);
  EXPECT_EQ(all.triangles_rasterized, 0u);
}

// One triangle of each facing, far apart, so one cluster; its cone has no use.
TEST(FastCounters, ATriangleThatFacesAwayIsCountedByItself) {
  CounterScene scene;
  scene.add({{10, 10, 0.5f}, {10, 20, 0.5f}, {20, 10, 0.5f}, {110, 110, 0.5f}, {120, 110, 0.5f}, {110, 120, 0.5f}})
      .draw.cull = Cull::back;
  const FrameStats stats = scene.render();
  EXPECT_EQ(stats.clusters_drawn, 1u);
  EXPECT_EQ(stats.triangles_facing, 1u);
  EXPECT_EQ(stats.triangles_rasterized, 1u);
}

TEST(FastCounters, ATriangleWithoutAreaIsEmpty) {
  CounterScene scene;
  scene.add({{10, 10, 0.5f}, {20, 20, 0.5f}, {30, 30, 0.5f}});
  const FrameStats stats = scene.render();
  EXPECT_EQ(stats.triangles_in, 1u);
  EXPECT_EQ(stats.triangles_empty, 1u);
  EXPECT_EQ(stats.triangles_rasterized, 0u);
}

// Cells of 1/32 px from (10, 10) on: all within (10.25, 10.25), before the sample at (10.5, 10.5).
TEST(FastCounters, TrianglesBetweenSamplesAreGoneBeforeTheirSetUp) {
  CounterScene scene;
  scene.grids({{10, 10}}, 0.03125f, 0.5f);
  const FrameStats stats = scene.render();
  EXPECT_EQ(stats.triangles_in, 128u);
  EXPECT_EQ(stats.triangles_without_sample, 128u);
  EXPECT_EQ(stats.triangles_rasterized, 0u);
  EXPECT_EQ(scene.render({.samples = false}).triangles_without_sample, 0u);
}

// Samples of the half x + y < 128: block (i, j) of 16 × 16 has one if its first, at 8 (i + j) + 1, is less than 128:
// i + j ≤ 15, 136 blocks of 256.
TEST(FastCounters, ALargeTriangleTouchesTheBlocksItCoversOfItsBox) {
  CounterScene scene;
  scene.add({{0, 0, 0.5f}, {0, 128, 0.5f}, {128, 0, 0.5f}});
  const FrameStats stats = scene.render();
  EXPECT_EQ(stats.triangles_rasterized, 1u);
  EXPECT_EQ(stats.blocks_touched, 136u);
  EXPECT_EQ(stats.blocks_outside, 120u);
  EXPECT_EQ(stats.fragments_covered, 127u * 128u / 2u);  // rows of 127, 126, … 0: the diagonal is a right edge
  EXPECT_EQ(scene.render({.blocks = false}).blocks_outside, 0u);
}

// In front, the left half: 2 triangles of 128 px height. Behind it a triangle over the whole tile: of its 256 blocks
// the 128 on the left are hidden.
TEST(FastCounters, BlocksOfALargeTriangleBehindARectangleAreHidden) {
  CounterScene scene;
  scene.rect({0, 0}, {64, 128}, 0.75f);
  const std::uint64_t in_front = scene.render().blocks_touched;
  scene.add({{0, 0, 0.5f}, {0, 256, 0.5f}, {256, 0, 0.5f}});
  const FrameStats stats = scene.render();
  EXPECT_EQ(stats.boxes_hidden, 0u);
  EXPECT_EQ(stats.blocks_hidden, 128u);
  EXPECT_EQ(stats.blocks_touched, in_front + 128u);
  EXPECT_EQ(scene.render({.blocks = false}).blocks_hidden, 0u);
}

}  // namespace
}  // namespace lode::raster::test
