/// The masked depth buffer: its merging rule, and what it hides.

#include "techniques/masked_occlusion/masked_depth.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <vector>

#include "geometry/random.h"

namespace lode::tests {
namespace {

using techniques::MaskedDepth;

constexpr std::uint32_t kAll = ~0u, kLeft = 0x0F0F0F0Fu, kRight = ~kLeft;

MaskedDepth one_subtile() {
  MaskedDepth buffer;
  buffer.begin({8, 4});
  return buffer;
}
bool hides(const MaskedDepth& buffer, glm::ivec2 first, glm::ivec2 last, float nearest) {
  std::uint64_t n_read = 0;
  return buffer.hides({first, last, nearest}, n_read);
}

TEST(MaskedDepth, HidesNothingAtFirst) { EXPECT_FALSE(hides(one_subtile(), {0, 0}, {0, 0}, 0.0f)); }

TEST(MaskedDepth, TwoHalvesMakeAWhole) {
  MaskedDepth buffer = one_subtile();
  buffer.add({0, 0}, kLeft, 0.6f);
  EXPECT_TRUE(hides(buffer, {0, 0}, {3, 3}, 0.5f));
  EXPECT_FALSE(hides(buffer, {0, 0}, {4, 3}, 0.5f));
  buffer.add({0, 0}, kRight, 0.7f);  // the farther of the two is the reference now
  EXPECT_TRUE(hides(buffer, {0, 0}, {7, 3}, 0.5f));
  EXPECT_FALSE(hides(buffer, {4, 0}, {7, 3}, 0.65f));
}

TEST(MaskedDepth, ATieHidesNothing) {
  MaskedDepth buffer = one_subtile();
  buffer.add({0, 0}, kAll, 0.5f);
  EXPECT_FALSE(hides(buffer, {0, 0}, {7, 3}, 0.5f));
  EXPECT_TRUE(hides(buffer, {0, 0}, {7, 3}, 0.49f));
}

TEST(MaskedDepth, AMuchNearerPartStartsTheWorkingLayerAnew) {
  MaskedDepth buffer = one_subtile();
  buffer.add({0, 0}, kLeft, 0.1f);
  buffer.add({0, 0}, kRight, 0.9f);  // 0.9 − 0.1 > 0.1 − 0
  EXPECT_EQ(buffer.bound_at({0, 0}), 0.0f);
  EXPECT_EQ(buffer.bound_at({4, 0}), 0.9f);
}

TEST(MaskedDepth, WhatIsFartherThanTheReferenceChangesNothing) {
  MaskedDepth buffer = one_subtile();
  buffer.add({0, 0}, kAll, 0.5f);
  buffer.add({0, 0}, kLeft, 0.4f);
  buffer.add({0, 0}, kAll, 0.3f);
  EXPECT_EQ(buffer.bound_at({0, 0}), 0.5f);
}

TEST(MaskedDepth, AWholeSubtileKeepsANearerWorkingLayer) {
  MaskedDepth buffer = one_subtile();
  buffer.add({0, 0}, kLeft, 0.5f);
  buffer.add({0, 0}, kAll, 0.4f);
  EXPECT_EQ(buffer.bound_at({0, 0}), 0.5f);
  EXPECT_EQ(buffer.bound_at({7, 0}), 0.4f);
  buffer.add({0, 0}, kAll, 0.6f);
  EXPECT_EQ(buffer.bound_at({0, 0}), 0.6f);
}

/// Oracle: a depth for each sample. The buffer's bound is never nearer, and a box is hidden only if it
/// is by every sample.
TEST(MaskedDepth, IsNeverNearerThanADepthForEachSample) {
  constexpr glm::ivec2 kSize(19, 10);
  int n_hidden = 0;
  for (std::uint64_t seed = 0; seed < 40; ++seed) {
    MaskedDepth buffer;
    buffer.begin(kSize);
    std::vector<float> exact(24 * 12, 0.0f);
    geometry::Random random(seed, 0);
    for (int step = 0; step < 60; ++step) {
      const glm::ivec2 subtile(int(random.below(3)), int(random.below(3)));
      const std::uint32_t coverage = random.below(4) == 0 ? kAll : random.word() | random.word();
      const float depth = float(random.uniform());
      buffer.add(subtile, coverage, depth);
      for (int bit = 0; bit < 32; ++bit) {
        if ((coverage >> bit & 1u) == 0) continue;
        float& sample = exact[std::size_t((subtile.y * 4 + bit / 8) * 24 + subtile.x * 8 + bit % 8)];
        sample = std::max(sample, depth);
      }
      const glm::ivec2 first(int(random.below(19)), int(random.below(10)));
      const glm::ivec2 last = glm::min(first + glm::ivec2(int(random.below(6)), int(random.below(4))), kSize - 1);
      const float nearest = float(random.uniform(0.0, 0.6));
      const bool hidden = hides(buffer, first, last, nearest);
      n_hidden += hidden ? 1 : 0;
      for (int y = 0; y < kSize.y; ++y) {
        for (int x = 0; x < kSize.x; ++x) {
          const float sample = exact[std::size_t(y * 24 + x)];
          EXPECT_LE(buffer.bound_at({x, y}), sample);
          if (hidden && x >= first.x && x <= last.x && y >= first.y && y <= last.y) {
            EXPECT_LT(nearest, sample);
          }
        }
      }
    }
  }
  EXPECT_GT(n_hidden, 100);
}

}  // namespace
}  // namespace lode::tests
