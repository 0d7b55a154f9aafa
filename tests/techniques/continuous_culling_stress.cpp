/// What promises every point of the screen, on many random scenes from many views, at 4 × 4 samples a pixel.

#include <gtest/gtest.h>

#include "techniques/inner_boxes/inner_boxes.h"
#include "tests/raster/stress_count.h"
#include "tests/techniques/continuous_pictures.h"

namespace lode::tests {
namespace {

using techniques::InnerBoxes;
using techniques::View;
using techniques::World;

constexpr std::uint64_t kViewsPerScene = 20;

TEST(ContinuousCullingStress, RandomScenesLoseNothingBetweenTheSamples) {
  const std::uint64_t n_views = raster::test::stress_count("views", 1000, 100'000);
  std::uint64_t n_culled = 0;
  for (std::uint64_t seed = 0; seed < n_views / kViewsPerScene; ++seed) {
    const bool lattice = seed % 2 == 1;
    const int n_objects = 20 + int(seed % 60);
    const geometry::Scene scene =
        lattice ? lattice_scene(2000 + seed, n_objects) : random_scene(2000 + seed, n_objects);
    const World world(scene, kRawUnlit, true, 1);
    Showing boxes(world, InnerBoxes({.boxes = {.resolution = 12}}));
    for (std::uint64_t k = 0; k < kViewsPerScene; ++k) {
      const View view = lattice ? lattice_view(2000 + seed, k) : random_view(2000 + seed, k);
      const TechniquePicture picture = boxes.picture(view);
      ASSERT_EQ(difference_at_4x4(world, picture, view), "") << "scene " << 2000 + seed << ", view " << k;
      n_culled += picture.count("culled");
    }
  }
  std::printf("[  COUNT   ] culled: %llu\n", static_cast<unsigned long long>(n_culled));
  EXPECT_GT(n_culled, n_views / 4);
}

}  // namespace
}  // namespace lode::tests
