/// The pyramid of farthest depths against the plane itself.

#include "techniques/hierarchical_z/depth_pyramid.h"

#include <gtest/gtest.h>

#include <algorithm>

#include "geometry/random.h"

namespace lode::tests {
namespace {

using techniques::DepthPyramid;
using techniques::ScreenBox;

/// Few depths, in patches, so that boxes are hidden about as often as not.
std::vector<float> patches(glm::ivec2 size, std::uint64_t seed) {
  std::vector<float> depth;
  for (int y = 0; y < size.y; ++y) {
    for (int x = 0; x < size.x; ++x) {
      geometry::Random random(seed, 0, std::uint64_t(y / 9 * 1000 + x / 7));
      depth.push_back(0.25f * float(random.below(4)));
    }
  }
  return depth;
}

ScreenBox random_box(glm::ivec2 size, geometry::Random& random) {
  ScreenBox box;
  for (int axis = 0; axis < 2; ++axis) {
    box.first_px[axis] = int(random.below(std::uint32_t(size[axis])));
    box.last_px[axis] = std::min(box.first_px[axis] + int(random.below(12)), size[axis] - 1);
  }
  box.nearest = 0.125f * float(random.below(8));
  return box;
}

/// Whether each pixel of the box, grown to whole texels of side 2^level, is nearer.
bool hidden(const std::vector<float>& depth, glm::ivec2 size, const ScreenBox& box, int level) {
  const int mask = (1 << level) - 1;
  const glm::ivec2 last = glm::min(box.last_px | mask, size - 1);
  for (int y = box.first_px.y & ~mask; y <= last.y; ++y) {
    for (int x = box.first_px.x & ~mask; x <= last.x; ++x) {
      if (!(box.nearest < depth[std::size_t(y * size.x + x)])) return false;
    }
  }
  return true;
}

TEST(DepthPyramid, ATexelIsTheFarthestOfItsPixels) {
  const std::vector<float> depth = {0.5f, 0.9f, 0.7f, 0.2f, 0.8f, 0.4f};  // 3 × 2
  DepthPyramid pyramid;
  pyramid.build(depth, {3, 2}, 0);
  ASSERT_EQ(pyramid.n_levels(), 3);
  EXPECT_EQ(pyramid.size_of(1), glm::ivec2(2, 1));
  EXPECT_EQ(pyramid.farthest(1, {0, 0}), 0.2f);
  EXPECT_EQ(pyramid.farthest(1, {1, 0}), 0.4f);
  EXPECT_EQ(pyramid.farthest(2, {0, 0}), 0.2f);
}

TEST(DepthPyramid, HidesWhatEveryTexelOfItsFinestLevelHides) {
  int n_hidden = 0;
  DepthPyramid pyramid;
  for (const glm::ivec2 size : {glm::ivec2(64, 32), glm::ivec2(61, 45), glm::ivec2(1, 33), glm::ivec2(1, 1)}) {
    const std::vector<float> depth = patches(size, std::uint64_t(size.x));
    for (const int finest : {0, 1, 3, 10}) {
      pyramid.build(depth, size, finest);
      geometry::Random random(3, std::uint32_t(finest), std::uint64_t(size.y));
      for (int k = 0; k < 500; ++k) {
        const ScreenBox box = random_box(size, random);
        std::uint64_t n_read = 0;
        const bool hides = pyramid.hides(box, n_read);
        // The level where the box is two texels wide may lie above the finest one, never below.
        EXPECT_EQ(hides, hidden(depth, size, box, std::min(finest, pyramid.n_levels() - 1)));
        EXPECT_GT(n_read, 0u);
        n_hidden += hides ? 1 : 0;
      }
    }
  }
  EXPECT_GT(n_hidden, 1000);
}

TEST(DepthPyramid, ATieHidesNothingAndABoxWithoutPixelsIsHidden) {
  const std::vector<float> depth(16, 0.5f);
  DepthPyramid pyramid;
  pyramid.build(depth, {4, 4}, 0);
  std::uint64_t n_read = 0;
  EXPECT_FALSE(pyramid.hides({{0, 0}, {3, 3}, 0.5f}, n_read));
  EXPECT_TRUE(pyramid.hides({{0, 0}, {3, 3}, 0.49f}, n_read));
  EXPECT_TRUE(pyramid.hides({{2, 0}, {1, 3}, 0.9f}, n_read));
}

}  // namespace
}  // namespace lode::tests
