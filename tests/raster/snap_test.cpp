// Snapping (C1) and clipping (C4) against integers and rationals; snap_stress.cpp has the large counts.

#include <gtest/gtest.h>

#include <limits>

#include "clip_cases.h"
#include "frames.h"

namespace lode::raster {
namespace {

using namespace test;

constexpr double kInf = std::numeric_limits<double>::infinity();
constexpr double kNaN = std::numeric_limits<double>::quiet_NaN();

std::int32_t snapped(double px) { return reference::window_vertex(glm::dvec3{px, 0.0, 0.5}).p_fx8.x; }

TEST(Snap, RoundsHalfToEven) {
  const double e = 1.0 / 256.0;
  EXPECT_EQ(snapped(0.5 * e), 0);
  EXPECT_EQ(snapped(1.5 * e), 2);
  EXPECT_EQ(snapped(2.5 * e), 2);
  EXPECT_EQ(snapped(-0.5 * e), 0);
  EXPECT_EQ(snapped(-1.5 * e), -2);
  EXPECT_EQ(snapped(-2.5 * e), -2);
  EXPECT_EQ(snapped(0.50001 * e), 1);
  EXPECT_EQ(snapped(-0.99 * e), -1);
}

TEST(Snap, StaysInTheGuardBand) {
  EXPECT_EQ(snapped(32768.0), reference::kGuard_fx8);
  EXPECT_EQ(snapped(32767.999), reference::kGuard_fx8);
  EXPECT_EQ(snapped(1e300), reference::kGuard_fx8);
  EXPECT_EQ(snapped(-kInf), -reference::kGuard_fx8);
}

TEST(Snap, OfAFloatEqualsTheIntegerOracleOnItsBits) {
  HashedNumbers random(30);
  for (int i = 0; i < 300'000; ++i) {
    auto bits = std::uint32_t(random.bits());
    if (i % 2 == 0) bits = (bits & 0x807F'FFFF) | ((112 + random.below(32)) << 23);  // 2^-15 to 2^16 px
    if (i % 8 == 0) bits &= 0xFFFF'F000;                                             // ties
    const float value = std::bit_cast<float>(bits);
    if (std::isnan(value)) continue;
    const glm::ivec2 p = reference::window_vertex(glm::dvec3{double(value), -double(value), 0.0}).p_fx8;
    ASSERT_EQ(p.x, snapped_bits(bits)) << std::hex << bits;
    ASSERT_EQ(p.y, snapped_bits(bits ^ 0x8000'0000)) << std::hex << bits;
  }
}

TEST(Snap, OfADoubleEqualsTheIntegerOracleOnItsBits) {
  HashedNumbers random(31);
  for (int i = 0; i < 300'000; ++i) {
    const double near_tie = (random.between(-200'000, 200'000) + 0.5) / 256.0;
    const double value =
        i % 2 == 0 ? random_number(random, -20, 17) : std::nextafter(near_tie, random.between(-1, 1) * 1e9);
    ASSERT_EQ(snapped(value), snapped_bits(value)) << value;
  }
}

TEST(Snap, OfClipVerticesIsWithinTheBoundOfTheRationalPosition) {
  HashedNumbers random(32);
  for (int i = 0; i < 20'000; ++i) {
    const Rect viewport = random_viewport(random);
    const reference::Viewport v = reference::make_viewport(viewport);
    const glm::dvec4 p = random_inside(random, v);
    const ExactWindow exact = exact_window(viewport, mpq_class(p.x), mpq_class(p.y), mpq_class(p.w));
    ASSERT_TRUE(within_bound(exact, reference::window_vertex(v, p).p_fx8)) << "case " << i;
  }
}

// 2^20/256 px right of the middle of a viewport 16384 px wide, and 2^-30 of a sub-pixel more than a tie: added to the
// middle in double, 2^-30 is lost.
TEST(Snap, DoesNotDependOnWhereTheViewportLies) {
  const glm::dvec4 p{(0.5 + 0x1p-36) / 0x1p21, (0.5 - 0x1p-36) / 0x1p21, 0.5, 1.0};
  for (const glm::ivec2 origin :
       {glm::ivec2(0), glm::ivec2(-8192), glm::ivec2(-8191, 1234), glm::ivec2(20000, -30000)}) {
    const reference::Viewport v = reference::make_viewport({origin, {16384, 16384}});
    const glm::ivec2 middle = 256 * (origin + 8192);
    EXPECT_EQ(reference::window_vertex(v, p).p_fx8, middle + glm::ivec2(1, 0)) << origin.x;
  }
}

TEST(Snap, DepthIsClampedAndHasOneZero) {
  EXPECT_EQ(reference::window_vertex(glm::dvec3{0.0, 0.0, 7.0}).z, 1.0);
  EXPECT_EQ(reference::window_vertex(glm::dvec3{0.0, 0.0, -7.0}).z, 0.0);
  EXPECT_FALSE(std::signbit(reference::window_vertex(glm::dvec3{0.0, 0.0, -0.0}).z));
}

// ---- Clipping.

TEST(Clip, NewVerticesHaveTheSameBitsFromBothSidesOfTheirEdge) {
  HashedNumbers random(33);
  std::array<int, reference::kClipPlanes> n_cut{};
  int n_wrong = 0;
  for (int i = 0; i < 20'000; ++i) {
    const reference::Viewport v = reference::make_viewport(random_viewport(random));
    const int spread = i % 2 == 0 ? 3 : 20;
    const glm::dvec4 a = random_clip_point(random, spread), b = random_clip_point(random, spread);
    const glm::dvec4 c = random_clip_point(random, spread), d = random_clip_point(random, spread);
    n_wrong += !same_from_both_sides(random, v, a, b, c, d);
    const std::uint32_t crossed = reference::outside_planes(v, a) ^ reference::outside_planes(v, b);
    for (std::size_t k = 0; k < n_cut.size(); ++k) n_cut[k] += int((crossed >> k) & 1u);
  }
  EXPECT_EQ(n_wrong, 0);
  for (const int n : n_cut) EXPECT_GT(n, 1000);
}

// The ends mirror each other in the plane: both are equally near, so the lexicographic order decides.
TEST(Clip, EndsEquallyFarFromThePlaneAreTakenInLexicographicOrder) {
  HashedNumbers random(34);
  const reference::Viewport v = reference::make_viewport({{0, 0}, {64, 64}});
  int n_wrong = 0;
  for (int i = 0; i < 5000; ++i) {
    glm::dvec4 a = random_clip_point(random, 2), b = random_clip_point(random, 2);
    a.w = 3.0;
    b.w = 2.0;
    const double d = std::ldexp(double(random.between(1, 1000)), -10);
    a.z = 3.0 - d;  // exactly representable: w − z = ±d
    b.z = 2.0 + d;
    const glm::dvec4 c = random_clip_point(random, 2), e = random_clip_point(random, 2);
    n_wrong += !same_from_both_sides(random, v, a, b, c, e);
  }
  EXPECT_EQ(n_wrong, 0);
}

/// A vertex of `polygon` within the bound of the exact point, after the snap.
bool has_vertex_at(const reference::ClipPolygon& polygon, const reference::Viewport& v, const ExactWindow& exact) {
  for (int i = 0; i < polygon.n; ++i) {
    if (within_bound(exact, reference::window_vertex(v, polygon.vertices[std::size_t(i)].position).p_fx8)) return true;
  }
  return false;
}

/// Edges that cross plane k alone, w up to `ratio` apart: wrong ones, and those not found.
int wrong_cuts(std::uint64_t seed, int k, double ratio, int n_cases) {
  HashedNumbers random(seed);
  int n_wrong = 0;
  int n_done = 0;
  for (int n_tries = 0; n_done < n_cases && n_tries < 1000 * n_cases; ++n_tries) {
    const Rect viewport{{random.between(-100, 100), random.between(-100, 100)},
                        {random.between(1, 2000), random.between(1, 2000)}};
    const reference::Viewport v = reference::make_viewport(viewport);
    const double w_a = std::exp2(std::log2(ratio) * random.unit());
    const auto point = [&](double w, bool outside) -> glm::dvec4 {
      const double x = w * (2.0 * random.unit() - 1.0), y = w * (2.0 * random.unit() - 1.0), z = w * random.unit();
      const double far = (2.0 + 10.0 * random.unit()) * 0x1p17 / std::min(v.half_fx8.x, v.half_fx8.y) * 128.0 * w;
      switch (outside ? k : -1) {
        case 0:
          return {x, y, w * (1.0 + random.unit()), w};
        case 2:
          return {x, y, -z, w};
        case 3:
          return {-far, y, z, w};
        case 4:
          return {far, y, z, w};
        case 5:
          return {x, far, z, w};
        case 6:
          return {x, -far, z, w};
        default:
          return {x, y, z, w};
      }
    };
    const glm::dvec4 a = point(w_a, false), b = point(w_a / ratio, true), c = point(1.0, false);
    if (reference::outside_planes(v, a) != 0 || reference::outside_planes(v, b) != 1u << k) continue;
    if (reference::outside_planes(v, c) != 0) continue;
    ++n_done;
    const ExactPoint cut = exact_cut(k, viewport, a, b);
    n_wrong += !has_vertex_at(reference::clip_triangle(v, {a, b, c}), v, exact_window(viewport, cut.x, cut.y, cut.w));
  }
  return n_wrong + (n_cases - n_done);
}

TEST(Clip, CutsAreWithinTheSnapsBoundOfTheRationalCutAtAWRatioOfAMillion) {
  for (const int k : {0, 2, 3, 4, 5, 6}) {
    EXPECT_EQ(wrong_cuts(35 + std::uint64_t(k), k, 1e6, 300), 0) << "plane " << k;
    EXPECT_EQ(wrong_cuts(45 + std::uint64_t(k), k, 1e-6, 300), 0) << "plane " << k;
    EXPECT_EQ(wrong_cuts(55 + std::uint64_t(k), k, 1.0, 300), 0) << "plane " << k;
  }
}

// Later cuts round z and w apart, so z may end a little above w: the window's depth is clamped.
TEST(Clip, NothingIsLeftBehindAPlane) {
  HashedNumbers random(36);
  const reference::Viewport v = reference::make_viewport({{0, 0}, {64, 64}});
  for (int i = 0; i < 5000; ++i) {
    const std::array<glm::dvec4, 3> corners = {random_clip_point(random, 3), random_clip_point(random, 3),
                                               random_clip_point(random, 3)};
    const reference::ClipPolygon polygon = reference::clip_triangle(v, corners);
    for (int k = 0; k < polygon.n; ++k) {
      const glm::dvec4& p = polygon.vertices[std::size_t(k)].position;
      ASSERT_GE(p.w, reference::kMinW);
      ASSERT_GE(p.z, 0.0);
      const reference::WindowVertex at = reference::window_vertex(v, p);
      ASSERT_LE(at.z, 1.0);
      ASSERT_LE(std::max(std::abs(at.p_fx8.x), std::abs(at.p_fx8.y)), reference::kGuard_fx8);
    }
  }
}

// ---- Hostile vertices, through render.

struct Drawn {
  int n_px = 0;
  FrameStats stats;
};

Drawn draw_px(const Vertices& vertices, glm::ivec2 size_px = {16, 16}) {
  const Draw draw = triangles_of(vertices);
  Image image = make_image(size_px, ColorFormat::rgba8, {.color = false, .depth = true, .ids = true});
  Drawn drawn;
  drawn.stats = render_by_both(frame_of(draw), image);
  for (const Ids& ids : image.ids) drawn.n_px += ids.draw != kNoId;
  return drawn;
}

TEST(HostileVertices, ANaNDiscardsItsPrimitiveAndIsCounted) {
  for (int c = 0; c < 4; ++c) {
    std::vector<glm::dvec4> p = {{-1, -1, 0.5, 1}, {3, -1, 0.5, 1}, {-1, 3, 0.5, 1},
                                 {-1, -1, 0.5, 1}, {3, -1, 0.5, 1}, {-1, 3, 0.5, 1}};
    p[std::size_t(c) % 3][c] = kNaN;
    const Drawn drawn = draw_px(ClipVertices{p});
    EXPECT_EQ(drawn.stats.primitives_not_finite, 1u);
    EXPECT_EQ(drawn.n_px, 256);  // the other triangle
    p.resize(3);
    EXPECT_EQ(draw_px(ClipVertices{p}).n_px, 0);
  }
  for (int c = 0; c < 3; ++c) {
    std::vector<glm::vec3> p = {{-1, -1, 0.5f}, {3, -1, 0.5f}, {-1, 3, 0.5f}};
    p[1][c] = float(kNaN);
    EXPECT_EQ(draw_px(ObjectVertices{p}).stats.primitives_not_finite, 1u);
    std::vector<glm::dvec3> window = {{0, 0, 0.5}, {16, 0, 0.5}, {0, 16, 0.5}};
    window[2][c] = kNaN;
    EXPECT_EQ(draw_px(WindowVertices{window}).stats.primitives_not_finite, 1u);
  }
}

// From (0, 0) to infinity on one side: the half of the target on that side, whichever it is.
TEST(HostileVertices, InfiniteAndHugeCoordinatesAreClippedAlikeOnEverySide) {
  for (const double far : {1e6, 1e30, double(std::numeric_limits<float>::max()), kInf}) {
    const auto f = float(far);
    const std::vector<glm::vec3> right = {{0, -2, 0.5f}, {f, 0, 0.5f}, {0, 2, 0.5f}};
    const std::vector<glm::vec3> left = {{0, -2, 0.5f}, {-f, 0, 0.5f}, {0, 2, 0.5f}};
    const std::vector<glm::vec3> above = {{-2, 0, 0.5f}, {0, f, 0.5f}, {2, 0, 0.5f}};
    const std::vector<glm::vec3> below = {{-2, 0, 0.5f}, {0, -f, 0.5f}, {2, 0, 0.5f}};
    EXPECT_EQ(draw_px(ObjectVertices{right}).n_px, 128) << far;
    EXPECT_EQ(draw_px(ObjectVertices{left}).n_px, 128) << far;
    EXPECT_EQ(draw_px(ObjectVertices{above}).n_px, 128) << far;
    EXPECT_EQ(draw_px(ObjectVertices{below}).n_px, 128) << far;
  }
  const std::vector<glm::dvec4> behind = {{-1e300, 0, 0.25, 1}, {1, -2, 0.25, 1}, {1, 2, 0.25, 1}};
  EXPECT_EQ(draw_px(ClipVertices{behind}).n_px, 256);
}

TEST(HostileVertices, WOfZeroNegativeTinyAndMixedIsClippedAtTheNearPlane) {
  const auto triangle = [](double w0, double w1, double w2) {
    return std::vector<glm::dvec4>{{-1 * std::abs(w0), -1 * std::abs(w0), 0, w0}, {3, -1, 0, w1}, {-1, 3, 0, w2}};
  };
  EXPECT_EQ(draw_px(ClipVertices{triangle(1, 1, 1)}).n_px, 256);
  EXPECT_EQ(draw_px(ClipVertices{triangle(-1, -1, -1)}).n_px, 0);
  EXPECT_EQ(draw_px(ClipVertices{triangle(0, 0, 0)}).n_px, 0);
  EXPECT_EQ(draw_px(ClipVertices{triangle(1e-30, 1, 1)}).n_px, 256);
  EXPECT_EQ(
      draw_px(ClipVertices{triangle(std::numeric_limits<double>::denorm_min(), 1, 1)}).stats.primitives_not_finite, 0u);
  // One w of 0: the vertex lies at infinity in direction (3, −1). Left of x = −1 and up to y = −1 … 3 nothing is
  // missing.
  EXPECT_EQ(draw_px(ClipVertices{triangle(1, 0, 1)}).n_px, 256);
  // w = −1 at the right: the point seen is beyond infinity; what is left is the part in front of the eye.
  EXPECT_GT(draw_px(ClipVertices{triangle(1, -1, 1)}).n_px, 0);
}

TEST(HostileVertices, DenormalsAndSignedZerosAreNumbersLikeOthers) {
  const double d = std::numeric_limits<double>::denorm_min();
  const std::vector<glm::dvec4> p = {{-1, -1, d, 1}, {3, -1, -0.0, 1}, {-1, 3, 0.0, 1}};
  EXPECT_EQ(draw_px(ClipVertices{p}).n_px, 256);
  const std::vector<glm::dvec4> small = {{-d, -d, d, d}, {d, -d, d, d}, {-d, d, d, d}};  // w below the smallest kept
  EXPECT_EQ(draw_px(ClipVertices{small}).n_px, 0);
}

TEST(HostileVertices, AnyBitsInAnyComponentAreDrawnWithoutFault) {
  HashedNumbers random(37);
  const double special[] = {0.0, -0.0, 1.0, -1.0, kInf, -kInf, kNaN, 1e-310, 1e300, -1e300, 0x1p-149, 0.5};
  for (int i = 0; i < 3000; ++i) {
    std::array<glm::dvec4, 3> clip;
    std::array<glm::vec3, 3> object;
    for (std::size_t k = 0; k < 3; ++k) {
      for (int c = 0; c < 4; ++c) {
        clip[k][c] = random.below(2) == 0 ? special[random.below(12)] : std::bit_cast<double>(random.bits());
        if (c < 3) object[k][c] = std::bit_cast<float>(std::uint32_t(random.bits()));
      }
    }
    EXPECT_LE(draw_px(ClipVertices{clip}, {9, 7}).n_px, 63);
    EXPECT_LE(draw_px(ObjectVertices{object}, {9, 7}).n_px, 63);
  }
}

}  // namespace
}  // namespace lode::raster
