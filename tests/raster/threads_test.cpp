// The same bytes and the same counters for any number of threads; the same bytes for any tile size.
#include <string_view>

#include "everything.h"

namespace lode::raster::test {
namespace {

struct Result {
  Image image;
  std::string stats;
};

Result render_everything(ColorFormat format, std::vector<glm::ivec2> samples, const RenderOptions& options) {
  const bool one = samples.size() == 1;
  SmallScene scene({150, 90}, format, {.color = true, .depth = one, .ids = one});
  add_everything(scene);
  scene.frame.samples_fx8 = samples;
  std::vector<DrawStats> per_draw(scene.draws.size());
  RenderOptions with_stats = options;
  with_stats.per_draw = per_draw;
  const FrameStats stats = scene.render(with_stats);
  std::string text = text_of(stats);
  for (const DrawStats& s : per_draw) text += std::to_string(s.covered) + " " + std::to_string(s.visible) + "\n";
  return {std::move(scene.image), text};
}

class AnyThreads : public testing::TestWithParam<ColorFormat> {};

TEST_P(AnyThreads, GiveTheSameBytesAndCounters) {
  for (const auto& samples : {std::vector<glm::ivec2>{{128, 128}}, {{32, 96}, {160, 200}}}) {
    for (const int tile : {8, 64}) {
      const Result one = render_everything(GetParam(), samples, {.threads = 1, .tile_size_px = tile});
      for (const int threads : {0, 2, 3, 7, 16, 64, 1000}) {
        const Result many = render_everything(GetParam(), samples, {.threads = threads, .tile_size_px = tile});
        EXPECT_TRUE(same_bytes(one.image, many.image)) << threads << " threads, tiles of " << tile;
        EXPECT_EQ(one.stats, many.stats) << threads << " threads, tiles of " << tile;
      }
    }
  }
}

TEST_P(AnyThreads, GiveTheSameBytesForAnyTileSize) {
  for (const auto& samples : {std::vector<glm::ivec2>{{128, 128}}, {{32, 96}, {160, 200}}}) {
    const Result first = render_everything(GetParam(), samples, {.threads = 1, .tile_size_px = 8});
    for (const int tile : {16, 32, 64, 128, 256}) {
      const Result other = render_everything(GetParam(), samples, {.threads = 2, .tile_size_px = tile});
      EXPECT_TRUE(same_bytes(first.image, other.image)) << "tiles of " << tile;
    }
  }
}

INSTANTIATE_TEST_SUITE_P(BothFormats, AnyThreads, testing::Values(ColorFormat::rgba8, ColorFormat::rgba32f));

TEST(EverythingFrame, UsesEveryKindOfWork) {  // else the tests that use it claim too much
  SmallScene scene({150, 90});
  add_everything(scene);
  std::vector<DrawStats> per_draw(scene.draws.size());
  const FrameStats stats = scene.render({.threads = 1, .per_draw = per_draw});
  for (std::size_t d = 0; d < per_draw.size(); ++d)
    EXPECT_GT(per_draw[d].visible, 0u) << "draw " << d << ", " << per_draw[d].covered << " covered";
  // Statistics by draw come from the reference pipeline: what only the fast one counts is fast_counters_test's.
  for_each_counter(stats, [](std::string_view name, std::uint64_t n) {
    const bool of_fast = name.starts_with("boxes_") || name.starts_with("clusters_") ||
                         name.starts_with("triangles_") || name.starts_with("blocks_") ||
                         name == "draws_culled_frustum";
    EXPECT_EQ(n > 0u, !of_fast) << name;
  });
}

}  // namespace
}  // namespace lode::raster::test
