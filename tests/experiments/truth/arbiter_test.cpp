/// Triangles by hand: cut, seen from behind, edge-on, beside each other, far away.

#include "experiments/truth/arbiter.h"

#include <gtest/gtest.h>

#include <cmath>
#include <glm/gtc/matrix_transform.hpp>

#include "geometry/camera.h"
#include "geometry/random.h"

namespace lode::experiments::truth {
namespace {

constexpr glm::ivec2 kSize{64, 64};

/// Looks down −z from the origin, 90° high: a point (x, y, −d) lands at 32 + 32·x/d, 32 − 32·y/d px, depth near/d.
geometry::Camera camera(double near = 1.0, double far = HUGE_VAL) {
  geometry::Camera c;
  c.tan_half_fov_y = 1.0;
  c.near = near;
  c.far = far;
  return c;
}

/// Orthographic from z = 0 to z = −4, 4 units high: a unit is 16 px.
geometry::Camera flat_camera() {
  geometry::Camera c;
  c.projection = geometry::Projection::orthographic;
  c.height = 4.0;
  c.near = 0.0;
  c.far = 4.0;
  return c;
}

struct TriangleInView {
  glm::dmat4 clip_from_object;
  SourceTriangle source;

  TriangleInView(const geometry::Camera& c, std::array<glm::vec3, 3> p, raster::Cull cull = raster::Cull::none)
      : clip_from_object(geometry::clip_from_world(c, kSize)), source{&clip_from_object, p, cull} {}
  TriangleInView(const TriangleInView&) = delete;

  [[nodiscard]] Judgement at(double x_px, double y_px) const { return judge(prepare(source, kSize), {x_px, y_px}); }
  [[nodiscard]] Coverage coverage_at(double x_px, double y_px) const { return at(x_px, y_px).coverage; }
};

/// (4, 4), (60, 4), (4, 60) px at distance 2, so depth ½.
const std::array<glm::vec3, 3> kCorner = {{{-1.75f, 1.75f, -2.0f}, {-1.75f, -1.75f, -2.0f}, {1.75f, 1.75f, -2.0f}}};

TEST(Arbiter, JudgesInsideOutsideAndEdge) {
  const TriangleInView t(camera(), kCorner);
  EXPECT_EQ(t.coverage_at(10.5, 10.5), Coverage::in);
  EXPECT_EQ(t.coverage_at(50.5, 50.5), Coverage::out);
  EXPECT_EQ(t.coverage_at(32.5, 31.5), Coverage::uncertain);  // x + y = 64 is the diagonal
  EXPECT_EQ(t.at(32.5, 31.5).doubt, Doubt::outline);
  EXPECT_TRUE(exact_sample(t.source, kSize, {32.5, 31.5}).on_outline);
  EXPECT_FALSE(exact_sample(t.source, kSize, {10.5, 10.5}).on_outline);
  EXPECT_EQ(exact_sample(t.source, kSize, {10.5, 10.5}).depth, Rational(1, 2));
  EXPECT_TRUE(t.at(10.5, 10.5).depth.contains(0.5f));
  EXPECT_FALSE(t.at(10.5, 10.5).depth.contains(std::nextafter(0.5f, 1.0f)));
  EXPECT_FALSE(t.at(10.5, 10.5).depth.contains(std::nextafter(0.5f, 0.0f)));
}

/// The quarter of a square at (32, 32) px: both triangles at an edge, and all four at the common corner, are uncertain.
TEST(Arbiter, NeighboursAreUncertainTogether) {
  const TriangleInView left(camera(), {{{0, 0, -2}, {-2, 2, -2}, {-2, -2, -2}}});
  const TriangleInView up(camera(), {{{0, 0, -2}, {2, 2, -2}, {-2, 2, -2}}});
  for (const double x : {8.5, 20.5, 30.5}) {
    EXPECT_EQ(left.coverage_at(x, x), Coverage::uncertain);
    EXPECT_EQ(up.coverage_at(x, x), Coverage::uncertain);
    EXPECT_EQ(left.coverage_at(x, x + 1.0), Coverage::in);
    EXPECT_EQ(up.coverage_at(x, x + 1.0), Coverage::out);
  }
}

TEST(Arbiter, DropsBackFacesAndDoubtsOnesSeenEdgeOn) {
  const std::array<glm::vec3, 3> turned = {kCorner[0], kCorner[2], kCorner[1]};
  using raster::Cull;
  EXPECT_EQ(TriangleInView(camera(), kCorner, Cull::back).coverage_at(10.5, 10.5), Coverage::in);
  EXPECT_EQ(TriangleInView(camera(), kCorner, Cull::front).coverage_at(10.5, 10.5), Coverage::out);
  EXPECT_EQ(TriangleInView(camera(), turned, Cull::back).coverage_at(10.5, 10.5), Coverage::out);
  EXPECT_EQ(TriangleInView(camera(), turned, Cull::front).coverage_at(10.5, 10.5), Coverage::in);
  // In a plane through the eye: exactly no area on screen, on the column x = 32.5, and dropped or not by a rounding.
  const float x = 1.0f / 64.0f;
  const std::array<glm::vec3, 3> edge_on = {{{x, 1, -1}, {x, -1, -1}, {2 * x, 1, -2}}};
  EXPECT_EQ(TriangleInView(camera(0.5), edge_on).coverage_at(32.5, 31.5), Coverage::uncertain);
  EXPECT_EQ(TriangleInView(camera(0.5), edge_on).coverage_at(33.5, 31.5), Coverage::out);
}

TEST(Arbiter, IsUncertainByRangeAtANearCutAndByEdgeAtAnOutline) {
  // A floor 1 below the eye, from behind it to far away: the near plane at 2 cuts it at y = 32 + 16 = 48 px.
  const TriangleInView floor(camera(2.0), {{{-50, -1, 10}, {50, -1, 10}, {0, -1, -100}}});
  EXPECT_EQ(floor.coverage_at(32.5, 46.5), Coverage::in);
  EXPECT_EQ(floor.coverage_at(32.5, 49.5), Coverage::out);
  EXPECT_EQ(floor.at(32.5, 48.0).coverage, Coverage::uncertain);
  EXPECT_EQ(floor.at(32.5, 48.0).doubt, Doubt::cut);
  EXPECT_EQ(floor.at(32.5, 48.0 - 0.999 * kSnap_px).doubt, Doubt::cut);
  EXPECT_EQ(floor.at(32.5, 48.0 - 1.001 * kSnap_px).coverage, Coverage::in);
  EXPECT_EQ(floor.at(32.5, 48.0 + 1.001 * kSnap_px).coverage, Coverage::out);
  // At distance d its depth is 2/d, and it is seen at y = 32 + 32/d: 44.5 is d = 2.56.
  const DepthInterval depth = floor.at(32.5, 44.5).depth;
  EXPECT_TRUE(depth.contains(float(2.0 / 2.56)));
  EXPECT_LT(depth.high - depth.low, 1e-3);
}

TEST(Arbiter, IsUncertainByRangeAtAFarCut) {
  const TriangleInView floor(camera(1.0, 4.0), {{{-50, -1, 10}, {50, -1, 10}, {0, -1, -100}}});
  EXPECT_EQ(floor.at(32.5, 40.0).doubt, Doubt::cut);  // 32 + 32/4
  EXPECT_EQ(floor.coverage_at(32.5, 39.5), Coverage::out);
  EXPECT_EQ(floor.coverage_at(32.5, 41.5), Coverage::in);
}

/// A face that lies in the near plane, or in the far one, exactly: kept here and lost there by one rounding.
TEST(Arbiter, WhatLiesInANearOrFarPlaneIsInDoubtAsAWhole) {
  for (const float z : {-1.0f, -3.0f}) {
    geometry::Camera c = flat_camera();
    c.near = 1.0;
    c.far = 3.0;
    const TriangleInView t(c, {{{-1, 1, z}, {-1, -1, z}, {1, 1, z}}});
    EXPECT_EQ(t.coverage_at(20.5, 20.5), Coverage::uncertain);
    EXPECT_EQ(t.at(20.5, 20.5).doubt, Doubt::cut);
  }
}

TEST(Arbiter, JudgesOrthographicViews) {
  const TriangleInView t(flat_camera(), {{{-1, 1, -1}, {-1, -1, -1}, {1, 1, -3}}});  // depth ¾, ¾, ¼
  EXPECT_EQ(t.coverage_at(20.5, 24.5), Coverage::in);
  // x runs from 16 px (depth ¾) to 48 px (¼): at 24.5, ¾ − 8.5/32·½.
  EXPECT_TRUE(t.at(24.5, 24.5).depth.contains(float(0.75 - 8.5 / 64.0)));
}

/// A thousand units away, a triangle of a hundredth of a pixel: all that can be said of it is where it is.
TEST(Arbiter, ATinyTriangleIsUncertainWithItsWholeDepthRange) {
  const float x = 1000.0f / 64.0f;  // at 32.5 px
  const TriangleInView t(camera(), {{{x, -x, -1000}, {x + 0.1f, -x, -1000}, {x, -x + 0.1f, -1001}}});
  const Judgement j = t.at(32.5, 32.5);
  EXPECT_EQ(j.coverage, Coverage::uncertain);
  EXPECT_TRUE(j.depth.contains(1.0f / 1000.0f));
  EXPECT_TRUE(j.depth.contains(1.0f / 1001.0f));
  EXPECT_FALSE(j.depth.contains(1.0f / 999.0f));
}

glm::vec3 random_point(geometry::Random& random, double size) {
  const double x = random.uniform(-size, size), y = random.uniform(-size, size);
  return {float(x), float(y), float(random.uniform(-2.0 * size, 0.5 * size))};
}

TEST(Arbiter, TheDoubleProjectionIsWithinItsBoundOfTheExactOne) {
  int n_projected = 0;
  for (std::uint64_t i = 0; i < 1000; ++i) {
    geometry::Random random(21, 1, i);
    const double far = random.below(2) ? HUGE_VAL : 40.0;
    const TriangleInView t(camera(0.01, far),
                           {random_point(random, 10.0), random_point(random, 10.0), random_point(random, 10.0)});
    const PreparedTriangle prepared = prepare(t.source, kSize);
    const ExactPolygon exact = exact_polygon(t.source, kSize, prepared.two_polygons ? Planes::outer : Planes::exact);
    ASSERT_EQ(prepared.outer.n, int(exact.size())) << "case " << i;
    for (std::size_t k = 0; k < exact.size(); ++k) {
      const Vertex& v = prepared.outer.v[k];
      ASSERT_LE(abs(Rational(v.x_px) - exact[k].x_px), Rational(prepared.outer.error_px)) << "case " << i;
      ASSERT_LE(abs(Rational(v.y_px) - exact[k].y_px), Rational(prepared.outer.error_px)) << "case " << i;
      ASSERT_LE(abs(Rational(v.z) - exact[k].z), Rational(prepared.outer.error_z) + Rational(0x1p-52)) << "case " << i;
    }
    n_projected += prepared.outer.n > 0;
    EXPECT_LT(prepared.outer.error_px, 0x1p-20) << "case " << i;  // what C1 leaves for it
  }
  EXPECT_GT(n_projected, 400);
}

/// The quick test claims nothing that the interval does not hold, and settles nearly all exact depths.
TEST(Arbiter, TheQuickDepthTestAgreesWithTheInterval) {
  int n_inside = 0, n_settled = 0;
  for (std::uint64_t i = 0; i < 1500; ++i) {
    geometry::Random random(22, 1, i);
    const TriangleInView t(camera(0.01),
                           {random_point(random, 10.0), random_point(random, 10.0), random_point(random, 10.0)});
    const PreparedTriangle prepared = prepare(t.source, kSize);
    const double x = random.below(64) + 0.5;
    const glm::dvec2 s(x, random.below(64) + 0.5);
    if (judge_coverage(prepared, s).coverage != Coverage::in) continue;
    ++n_inside;
    const DepthInterval depth = judge_depth(prepared, s);
    const float exact = float(exact_sample(t.source, kSize, s).depth.get_d());
    ASSERT_TRUE(depth.contains(exact));
    n_settled += surely_has_depth(prepared, s, exact);
    for (const double z : {depth.low, depth.high, depth.low - 1e-7, depth.high + 1e-7}) {
      for (const float f : {float(z), std::nextafter(float(z), 0.0f), std::nextafter(float(z), 2.0f)}) {
        ASSERT_TRUE(depth.contains(f) || !surely_has_depth(prepared, s, f)) << "case " << i;
      }
    }
  }
  EXPECT_GT(n_inside, 100);
  EXPECT_GT(n_settled, n_inside / 4);  // most of those that are not cut
}

}  // namespace
}  // namespace lode::experiments::truth
