// Depth (C5) and attributes (C7) at the samples of triangles and lines.
#include <bit>

#include "depth_attribute_checks.h"
#include "everything.h"
#include "rational_checks.h"

namespace lode::raster::test {
namespace {

void expect_pictures(const char* what, const Family& family, std::uint64_t n_samples) {
  const Measured m = check_pictures(family, n_samples, 1);
  print(what, m);
  expect_contract(m);
}

TEST(DepthAndAttributes, OfTrianglesInPerspectiveAreWithinTheirBounds) {
  expect_pictures("triangles, w ratio to 10^6", {.topology = Topology::triangles, .perspective = true}, 300'000);
}
TEST(DepthAndAttributes, OfTrianglesAcrossTheGuardBandAreWithinTheirBounds) {
  expect_pictures("triangles in window space", {.topology = Topology::triangles, .perspective = false}, 300'000);
}
TEST(DepthAndAttributes, OfLinesInPerspectiveAreWithinTheirBounds) {
  expect_pictures("lines, w ratio to 10^6", {.topology = Topology::lines, .perspective = true, .primitives = 100},
                  50'000);
}
TEST(DepthAndAttributes, OfLinesAcrossTheGuardBandAreWithinTheirBounds) {
  expect_pictures("lines in window space", {.topology = Topology::lines, .perspective = false, .primitives = 100},
                  50'000);
}

TEST(Attributes, AreSumsOfCorrectlyRoundedWeightsInCanonicalOrder) {
  const RationalMeasured m = check_any_numbers(3'000, 1);
  print("triangles and lines of any finite numbers", m);
  expect_contract(m);
}

TEST(TextureCoordinates, AndTheirDerivativesFollowTheExactPlane) {
  const FootprintMeasured m = check_footprints(5'000, 1);
  print(m);
  expect_contract(m);
}

TEST(ClippedTriangles, InterpolateTheAttributesOfTheirOwnVertices) {
  const ClippedMeasured m = check_clipped(5'000, 1);
  print(m);
  expect_contract(m);
}

/// A triangle of 2×2 px with z = z₀ + x·2^-32 at x sub-pixels. All products in C5's formula are exact in double (18
/// bits times 32), so its quotient is exact, too: in pixel column k it is z₀ + (2k + 1)·2^-25, half way between two
/// floats. z₀ is just below 1, where a double's places are closest for its size: there a reciprocal's rounding shows.
TEST(Depth, HalfWayBetweenTwoFloatsGoesToTheEvenOneBecauseItIsDividedNotMultiplied) {
  HashedNumbers numbers(5);
  constexpr float kZ0 = 1.0f - 0x1p-8f;
  const auto z_at = [](double x_px) { return double(kZ0) + x_px * 256.0 * 0x1p-32; };
  int n = 0;
  for (int k = 0; k < 500; ++k) {
    const double x0 = numbers.between(0, 60) / 256.0, x1 = numbers.between(440, 512) / 256.0,
                 x2 = numbers.between(0, 512) / 256.0;
    const double y1 = numbers.between(0, 60) / 256.0, y2 = numbers.between(440, 512) / 256.0;
    SmallScene scene({2, 2});
    scene.window(Topology::triangles, {{x0, 0, z_at(x0)}, {x1, y1, z_at(x1)}, {x2, y2, z_at(x2)}});
    scene.render();
    for (std::size_t i = 0; i < 4; ++i) {
      if (scene.image.ids[i].draw == kNoId) continue;
      const float even = i % 2 == 0 ? kZ0 : kZ0 + 0x1p-23f;  // + 2^-25: down; + 3·2^-25: up to + 4·2^-25
      ASSERT_EQ(scene.image.depth[i], even) << "triangle " << k << ", pixel " << i;
      ++n;
    }
  }
  EXPECT_GT(n, 1000);
}

/// The same for flat lines of at most 3 px: squared lengths of 20 bits times 32.
TEST(Depth, OfALineHalfWayBetweenTwoFloatsGoesToTheEvenOne) {
  HashedNumbers numbers(7);
  constexpr float kZ0 = 1.0f - 0x1p-8f;
  const auto z_at = [](double x_px) { return double(kZ0) + x_px * 256.0 * 0x1p-32; };
  for (int k = 0; k < 500; ++k) {
    const double a = numbers.between(0, 60) / 256.0, b = numbers.between(600, 700) / 256.0;
    SmallScene scene({2, 1});
    scene.window(Topology::lines, {{a, 0.5, z_at(a)}, {b, 0.5, z_at(b)}});
    scene.render();
    ASSERT_EQ(scene.image.depth, (PixelPlane<float>{kZ0, kZ0 + 0x1p-23f})) << "line " << k;
  }
}

/// The vertices' depth is half way between two floats: a quotient one place of a double off would round the wrong way.
TEST(Depth, OfAFlatTriangleIsThatOfItsVerticesHoweverItRounds) {
  HashedNumbers numbers(6);
  int n = 0;
  for (int k = 0; k < 1000; ++k) {
    const float low = float(0.1 + 0.8 * numbers.unit());
    const double z = 0.5 * (double(low) + double(std::nextafter(low, 1.0f)));
    // Far away, so that products with z are rounded; one corner is near, and not all triangles meet the picture.
    const auto corner = [&](double spread_px) {
      return glm::dvec3{8.0 + spread_px * (numbers.unit() - 0.5), 8.0 + spread_px * (numbers.unit() - 0.5), z};
    };
    SmallScene scene({16, 16});
    scene.window(Topology::triangles, {corner(60'000), corner(60'000), corner(100)});
    scene.window(Topology::lines, {corner(60'000), corner(20)});
    scene.render();
    for (std::size_t i = 0; i < scene.image.depth.size(); ++i) {
      if (scene.image.ids[i].draw == kNoId) continue;
      ASSERT_EQ(scene.image.depth[i], float(z)) << "triangle " << k << ", pixel " << i;
      ++n;
    }
  }
  EXPECT_GT(n, 20'000);
}

TEST(Depth, GrowsTowardsTheEyeAndEndsAtOneAndZero) {
  // Perspective, near 1: depth 1/d. A plane from d = 1 at the bottom edge to d = 2^30 at the top one; above 1 in clip
  // space it is cut, below 0 there is nothing with an infinite far plane.
  SmallScene scene({1, 64});
  scene.clip(Topology::quads,
             {{-1, -1, 1, 1}, {1, -1, 1, 1}, {0x1p30, 0x1p30, 1, 0x1p30}, {-0x1p30, 0x1p30, 1, 0x1p30}});
  scene.render();
  for (std::size_t i = 0; i + 1 < 64; ++i) {
    EXPECT_LT(scene.image.depth[i], scene.image.depth[i + 1]);
    EXPECT_NEAR(scene.image.depth[i], (double(i) + 0.5) / 64.0, 1e-6);
  }
}

TEST(Depth, HasOneZero) {
  SmallScene scene({8, 8});
  scene.window(Topology::triangles, {{0, 0, -0.0}, {0, 8, 0.0}, {8, 0, -0.0}});
  scene.clip(Topology::triangles, {{1, 1, -0.0, 1}, {-1, 1, -0.0, 1}, {1, -1, -0.0, 1}}).draw_id = 7;
  scene.window(Topology::lines, {{0, 0, -0.0}, {8, 8, -0.0}}).draw_id = 0;
  scene.window(Topology::points, {{4.5, 4.5, -0.0}}).draw_id = 0;
  scene.render();
  for (const float depth : scene.image.depth) EXPECT_EQ(std::bit_cast<std::uint32_t>(depth), 0u);
}

TEST(Attributes, AreAffineWhereTheThreeWAreBitwiseEqual) {
  // Eᵢ/ΣEⱼ to the last place of a double, though Eᵢ/3 would be rounded.
  HashedNumbers numbers(9);
  const Family family{.topology = Topology::triangles, .perspective = false};
  int n = 0;
  for (int k = 0; k < 2000; ++k) {
    const CornerData c = random_corners(numbers, family);
    std::array<reference::WindowVertex, 3> corners;
    for (std::size_t i = 0; i < 3; ++i) corners[i] = {c.p_fx8[i], 0.5, k % 2 == 0 ? 3.0 : 0.1};
    std::array<int, 3> order;
    const std::optional<reference::Triangle> triangle = reference::make_triangle(corners, order);
    const glm::ivec2 sample{16384, 16384};  // the middle of the family's picture, which many of them hold
    const EdgeValues e = triangle_edges(c.p_fx8, sample);
    if (!triangle || std::min({e[0], e[1], e[2]}) < 0) continue;
    const reference::VertexWeights weights = reference::weights_at(*triangle, sample);
    const double sum = double(e[0] + e[1] + e[2]);
    for (std::size_t i = 0; i < 3; ++i)
      ASSERT_EQ(weights[i], double(e[std::size_t(order[i])]) / sum) << "triangle " << k;
    ++n;
  }
  EXPECT_GT(n, 200);
}

/// One triangle with its vertices turned and reversed. All of a vertex's data moves with it.
Image picture_of_turned(const std::vector<glm::dvec4>& corners, const std::array<std::size_t, 3>& order, bool window) {
  const std::vector<glm::vec4> colors = {{0.9f, 0.1f, 0.3f, 1}, {-2, 0.7f, 1e9f, 0.3f}, {0.2f, 3, -0.9f, 0.4f}};
  const std::vector<glm::vec2> uvs = {{0.1f, 3.7f}, {-8, 0.33f}, {1.9f, 2.2f}};
  SmallScene scene({24, 24}, ColorFormat::rgba32f);
  std::vector<glm::dvec4> p;
  std::vector<glm::dvec3> p_window;
  std::vector<glm::vec4> c;
  std::vector<glm::vec2> uv;
  for (const std::size_t i : order) {
    p.push_back(corners[i]);
    p_window.push_back(12.0 + 12.0 * glm::dvec3(corners[i]));
    c.push_back(colors[i]);
    uv.push_back(uvs[i]);
  }
  Draw& draw = window ? scene.window(Topology::triangles, p_window) : scene.clip(Topology::triangles, p);
  draw.colors = scene.keep(c);
  draw.uvs = scene.keep(uv);
  draw.shader = pixel_shader([](const Pixel& q) { return glm::vec4(q.uv, q.color.z, q.color.w); });
  scene.render();
  return scene.image;
}

TEST(TurnedVertices, GiveTheSameBits) {
  HashedNumbers numbers(8);
  std::uint64_t n_drawn = 0;
  for (int k = 0; k < 400; ++k) {
    std::vector<glm::dvec4> corners;
    for (int i = 0; i < 3; ++i) {
      // Half of the triangles reach behind the near plane z = w, or far out of the guard band.
      const double w = k % 2 == 0 ? 0.5 + 4.0 * numbers.unit() : 3.0 * numbers.unit() - 0.7;
      const double size = k % 4 == 1 ? 1e5 : 2.0;
      corners.push_back(
          {size * (numbers.unit() - 0.5) * w, size * (numbers.unit() - 0.5) * w, 0.2 * numbers.unit(), w});
    }
    for (const bool window : {false, true}) {
      if (window && k % 4 == 1) continue;
      const Image first = picture_of_turned(corners, {0, 1, 2}, window);
      for (const Ids& id : first.ids) n_drawn += id.draw != kNoId ? 1 : 0;
      for (const auto& order : {std::array<std::size_t, 3>{1, 2, 0}, {2, 0, 1}, {0, 2, 1}, {2, 1, 0}, {1, 0, 2}}) {
        ASSERT_TRUE(same_bytes(first, picture_of_turned(corners, order, window)))
            << k << (window ? " window" : " clip");
      }
    }
  }
  EXPECT_GT(n_drawn, 10'000u);
}

}  // namespace
}  // namespace lode::raster::test
