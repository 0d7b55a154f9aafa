// Convex culling at run time: what its modes and rules hide, and what they must not.
#include "techniques/convex_culling/convex_culling.h"

#include <gtest/gtest.h>

#include "technique_pictures.h"

namespace lode::tests {
namespace {

using techniques::ConvexCulling;
using techniques::Fusion;
using techniques::ObjectId;
using techniques::View;
using techniques::World;
using Mode = ConvexCulling::Mode;

View front_view() {
  View view{.camera = {}, .size_px = {160, 120}};
  geometry::look_at(view.camera, {0.0, 0.0, 10.0}, {0.0, 0.0, 0.0});
  return view;
}

ConvexCulling::Params params_for(Mode mode) {
  ConvexCulling::Params params = ConvexCulling::params_for(mode);
  params.least_area_quantile = 0.0;
  return params;
}

/// A wall of two boxes side by side in front of a ball at z = −3, the last object.
geometry::Scene two_walls_and(double ball_z) {
  geometry::Scene scene;
  geometry::add_instance(scene, geometry::box({-3.0, -3.0, 0.0}, {0.0, 3.0, 0.2}));
  geometry::add_instance(scene, geometry::box({0.0, -3.0, 0.0}, {3.0, 3.0, 0.2}));
  geometry::add_instance(scene, geometry::sphere({0.0, 0.0, ball_z}, 0.5, 16, 8));
  return scene;
}

TEST(ConvexCulling, HidesWhatTheUnionOfOccludersCoversInEveryApproximateMode) {
  const geometry::Scene scene = two_walls_and(-3.0);
  const World world(scene, kRawUnlit, true, 1);
  for (const Mode mode : {Mode::literal, Mode::safe}) {
    ConvexCulling::Params params = params_for(mode);
    params.slabs.occluders.most = 2;  // the walls; literally, occluders are always drawn
    Showing technique(world, ConvexCulling(params));
    EXPECT_FALSE(technique.picture(front_view()).drawn[2]);
  }
}

// Neither wall alone covers the ball.
TEST(ConvexCulling, OfOneOccluderAtATimeHidesOnlyWhatOneCovers) {
  const geometry::Scene scene = two_walls_and(-3.0);
  const World world(scene, kRawUnlit, true, 1);
  ConvexCulling::Params params = params_for(Mode::safe);
  params.slabs.fusion = Fusion::per_occluder;
  Showing technique(world, ConvexCulling(params));
  EXPECT_TRUE(technique.picture(front_view()).drawn[2]);
}

// The ball in front of the walls: on the screen they cover it, and only the depth rule tells. The paper's angle rule
// sees eye → wall and wall → ball at more than its limit, unless that is 180°.
TEST(ConvexCulling, NeedsTheDepthRuleWhereAnglesDoNotTell) {
  const geometry::Scene scene = two_walls_and(3.0);
  const World world(scene, kRawUnlit, true, 1);
  const auto is_drawn = [&](Mode mode, double angle_deg) -> bool {
    ConvexCulling::Params params = params_for(mode);
    params.slabs.angle_limit_deg = angle_deg;
    params.slabs.occluders.most = 2;  // the walls: their boxes are larger than the ball's
    return Showing(world, ConvexCulling(params)).picture(front_view()).drawn[2];
  };
  EXPECT_TRUE(is_drawn(Mode::literal, 60.0));
  EXPECT_FALSE(is_drawn(Mode::literal, 180.0));
  EXPECT_TRUE(is_drawn(Mode::safe, 180.0));
}

// A frame around a hole: its hull covers the hole, and what is seen through it is lost. Inside the frame there is no
// hull that covers it.
TEST(ConvexCulling, LosesWhatIsSeenThroughAHollowUnlessConservative) {
  geometry::Scene scene;
  geometry::add_instance(scene, geometry::torus(glm::dvec3(0.0), 2.0, 0.5, 24, 12), {},
                         glm::rotate(glm::dmat4(1.0), 0.5 * 3.14159265358979, glm::dvec3(1.0, 0.0, 0.0)));
  geometry::add_instance(scene, geometry::sphere({0.0, 0.0, -3.0}, 0.4, 16, 8));
  const World world(scene, kRawUnlit, true, 1);
  const auto is_drawn = [&](Mode mode) -> bool {
    ConvexCulling::Params params = params_for(mode);
    params.approximation.limits = {26};  // one hull
    params.slabs.occluders.most = 1;     // the frame
    params.largest_error = 10.0;
    return Showing(world, ConvexCulling(params)).picture(front_view()).drawn[1];
  };
  EXPECT_FALSE(is_drawn(Mode::safe));
  EXPECT_TRUE(is_drawn(Mode::conservative));
}

TEST(ConvexCulling, PromisesWhatItsModeDoes) {
  using techniques::Promise;
  EXPECT_EQ(ConvexCulling(params_for(Mode::literal)).promise(), Promise::approximate);
  EXPECT_EQ(ConvexCulling(params_for(Mode::safe)).promise(), Promise::approximate);
  EXPECT_EQ(ConvexCulling(params_for(Mode::conservative)).promise(), Promise::conservative_continuous);
}

TEST(ConvexCulling, OfNothingAndOfFlatThingsDrawsThem) {
  geometry::Scene scene;
  geometry::Mesh flat = geometry::terrain(4.0, 2, 0.0, 1);
  geometry::add_instance(scene, flat);
  flat.indices.clear();
  geometry::add_instance(scene, flat);
  const World world(scene, kRawUnlit, true, 1);
  for (const Mode mode : {Mode::literal, Mode::safe, Mode::conservative}) {
    Showing technique(world, ConvexCulling(params_for(mode)));
    EXPECT_TRUE(technique.picture(front_view()).drawn[0]);
  }
}

TEST(ConvexCulling, InsideModelsLosesNothing) {
  int n_culled = 0;
  for (std::uint64_t seed = 1; seed <= 12; ++seed) {
    geometry::Scene scene;
    geometry::add_instance(scene, geometry::box({-4.0, -4.0, 0.0}, {4.0, 4.0, 0.5}));
    for (std::uint32_t k = 0; k < 14; ++k) {
      geometry::Random random(seed, 9, k);
      const glm::dvec3 at(random.uniform(-5, 5), random.uniform(-4, 4), random.uniform(-12, 6));
      const double size = random.uniform(0.2, 1.5);
      geometry::add_instance(scene,
                             k % 2 == 0 ? geometry::box(at - size, at + size) : geometry::sphere(at, size, 12, 6));
    }
    const World world(scene, kRawUnlit, true, 1);
    Showing all(world, techniques::Plain{});
    Showing technique(world, ConvexCulling(params_for(Mode::conservative)));
    const TechniquePicture picture = technique.picture(front_view()), whole = all.picture(front_view());
    EXPECT_EQ(raster::test::first_difference(picture.image, whole.image), "") << seed;
    n_culled += int(picture.count("culled"));
  }
  EXPECT_GT(n_culled, 10);
}

}  // namespace
}  // namespace lode::tests
