/// Hierarchical Z and masked occlusion culling on many random scenes from many views: the picture of the whole scene,
/// byte for byte, every time.

#include <gtest/gtest.h>

#include "techniques/hierarchical_z/hierarchical_z.h"
#include "techniques/masked_occlusion/masked_occlusion.h"
#include "tests/raster/stress_count.h"
#include "tests/techniques/technique_pictures.h"

namespace lode::tests {
namespace {

using techniques::HierarchicalZ;
using techniques::MaskedOcclusion;
using techniques::View;
using techniques::World;

constexpr std::uint64_t kViewsPerScene = 20;

template <class SceneOf, class ViewOf>
void expect_the_same_pictures(std::uint64_t n_views, const SceneOf& scene_of, const ViewOf& view_of) {
  std::uint64_t n_culled[4] = {0, 0, 0, 0};
  for (std::uint64_t seed = 0; seed < n_views / kViewsPerScene; ++seed) {
    const geometry::Scene scene = scene_of(1000 + seed, 20 + int(seed % 80));
    const World world(scene, kRawUnlit, seed % 2 == 0, 1);
    Showing plain(world, techniques::Plain{});
    Showing exact(world, HierarchicalZ{});
    Showing coarse(world, HierarchicalZ({.occluders = {.most = 8}, .scale = 4}));
    Showing masked(world, MaskedOcclusion{});
    Showing boxes(
        world,
        MaskedOcclusion({.occluders = {}, .shape = techniques::MaskedShape::inner_boxes, .boxes = {.resolution = 4}}));
    for (std::uint64_t k = 0; k < kViewsPerScene; ++k) {
      const View view = view_of(1000 + seed, k);
      const TechniquePicture expected = plain.picture(view);
      const TechniquePicture pictures[] = {exact.picture(view), coarse.picture(view), masked.picture(view),
                                           boxes.picture(view)};
      for (std::size_t i = 0; i < std::size(pictures); ++i) {
        ASSERT_EQ(difference_from_plain(pictures[i], expected), "")
            << "technique " << i << ", scene " << 1000 + seed << ", view " << k;
        n_culled[i] += pictures[i].count("culled");
      }
    }
  }
  std::printf(
      "[  COUNT   ] culled: hierarchical_z %llu, scale=4 of 8 occluders %llu, masked_occlusion %llu, of inner boxes "
      "%llu\n",
      static_cast<unsigned long long>(n_culled[0]), static_cast<unsigned long long>(n_culled[1]),
      static_cast<unsigned long long>(n_culled[2]), static_cast<unsigned long long>(n_culled[3]));
  for (const std::uint64_t n : n_culled) EXPECT_GT(n, n_views / 2);
}

TEST(SampledCullingStress, RandomScenesLookTheSame) {
  expect_the_same_pictures(raster::test::stress_count("views", 5000, 1'000'000), random_scene, random_view);
}

TEST(SampledCullingStress, EdgesThroughSamplesAndSharedPlanesLookTheSame) {
  expect_the_same_pictures(raster::test::stress_count("views", 5000, 1'000'000), lattice_scene, lattice_view);
}

}  // namespace
}  // namespace lode::tests
