// A tile keeps the vertices of the clusters that own samples in slots: one a sample and one more, 128² + 1 = 16385.
// Frames with more clusters in a tile than that.
#include "fast_difference.h"
#include "small_scene.h"

namespace lode::raster::test {
namespace {

constexpr std::size_t kSlots = 128 * 128 + 1;
constexpr std::array<glm::vec3, 3> kCorner = {{{0, 0, 0.5f}, {2, 0, 0.5f}, {0, 2, 0.5f}}};  // covers pixel (0, 0)

/// Many draws of the one triangle, each a cluster of its own: all at equal depth, drawn in turn, so that with falling
/// draw ids each takes its samples from those before it.
struct Stack {
  Clusters clusters = make_clusters(kCorner, std::nullopt);
  std::vector<Draw> draws;
  std::uint32_t next_id = 1'000'000;

  void add(glm::ivec2 size_px, glm::ivec2 at_px, double scale) {
    Draw& draw = draws.emplace_back();
    glm::dmat4 clip_from_object(1.0);
    clip_from_object[0][0] = 2.0 * scale / size_px.x, clip_from_object[1][1] = -2.0 * scale / size_px.y;
    clip_from_object[3] = {2.0 * at_px.x / size_px.x - 1.0, 1.0 - 2.0 * at_px.y / size_px.y, 0.0, 1.0};
    draw.vertices = ObjectVertices{kCorner, clip_from_object};
    draw.clusters = &clusters;
    draw.draw_id = next_id--;
    draw.color = glm::vec4(next_id % 251, next_id % 13, next_id % 101, 255);
  }

  void expect_same_as_reference(glm::ivec2 size_px) const {
    Image fast = make_image(size_px, ColorFormat::rgba8), reference = fast;
    Frame frame;
    frame.draws = draws;
    const FrameStats stats = render(frame, fast, {.threads = 1});
    EXPECT_EQ(stats.clusters_drawn, draws.size());
    render(frame, reference, {.threads = 1, .pipeline = Pipeline::reference});
    EXPECT_EQ(first_difference(fast, reference), "");
  }
};

TEST(Slots, AreTakenBackFromClustersThatOwnNothingAnyMore) {
  Stack stack;
  for (std::size_t k = 0; k < kSlots + 600; ++k) stack.add({8, 8}, {0, 0}, 8.0);  // all pixels each time
  stack.expect_same_as_reference({8, 8});
}

TEST(Slots, AreEnoughWhereEverySampleHasAnOwnerOfItsOwn) {
  Stack stack;
  for (int y = 0; y < 128; ++y) {
    for (int x = 0; x < 128; ++x) stack.add({128, 128}, {x, y}, 1.0);  // (2, 0)–(0, 2): pixel (0, 0) alone
  }
  for (int k = 0; k < 200; ++k) stack.add({128, 128}, {(k * 37) % 128, (k * 11) % 128}, 1.0);
  stack.expect_same_as_reference({128, 128});
}

}  // namespace
}  // namespace lode::raster::test
