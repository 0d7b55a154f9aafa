// Twelve pictures of every object, taken once (techniques/twelve_views/README.md).
#include "techniques/twelve_views/twelve_views.h"

#include <gtest/gtest.h>

#include <cmath>
#include <glm/gtc/matrix_transform.hpp>

#include "geometry/trigonometry.h"
#include "techniques/parallel_picture.h"
#include "tests/techniques/impostor_scenes.h"
#include "tests/techniques/technique_pictures.h"

namespace lode::tests {
namespace {

using techniques::kTwelve;
using techniques::nearest_of_twelve;
using techniques::ParallelPicture;
using techniques::twelve_views_direction;
using techniques::TwelveViews;
using techniques::View;
using techniques::World;

constexpr techniques::FarRule kAnywhere{.radii = 0.0, .distance = 0.0};

TEST(ParallelPicture, HasTheBoxWithinItAndIsNoLargerThanItMustBe) {
  geometry::Bounds box;
  box.add({-1.0, 2.0, 3.0}), box.add({5.0, 4.0, 11.0});
  for (const glm::dvec3& direction : {glm::dvec3(0, 0, 1), glm::dvec3(3, 1, -2), glm::dvec3(0, 5, 0)}) {
    const auto picture = techniques::parallel_picture(box, direction, 100);
    ASSERT_TRUE(picture);
    EXPECT_EQ(std::max(picture->size_px.x, picture->size_px.y), 100);
    glm::dvec2 reach(0.0);
    double depth = 0.0;
    for (int k = 0; k < 8; ++k) {
      const glm::dvec3 corner(k & 1 ? box.high.x : box.low.x, k & 2 ? box.high.y : box.low.y,
                              k & 4 ? box.high.z : box.low.z);
      const glm::dvec3 p = corner - box.centre();
      reach = glm::max(reach, glm::abs(glm::dvec2(glm::dot(p, picture->camera.right),  //
                                                  glm::dot(p, picture->camera.up))));
      depth = std::max(depth, std::abs(glm::dot(p, picture->camera.back)));
    }
    const double texel = 2.0 * picture->half_extent.x / picture->size_px.x;
    EXPECT_NEAR(texel, 2.0 * picture->half_extent.y / picture->size_px.y, 1e-12 * texel);  // square
    for (int axis = 0; axis < 2; ++axis) {
      EXPECT_LE(reach[axis], picture->half_extent[axis] * (1.0 + 1e-12));
      EXPECT_GT(reach[axis], picture->half_extent[axis] - 0.5 * texel * (1.0 + 1e-9));
    }
    EXPECT_LT(depth, picture->camera.far);
  }
}

TEST(ParallelPicture, IsNoneOfWhatHasNoSize) {
  geometry::Bounds point, line, endless;
  EXPECT_FALSE(techniques::parallel_picture(point, {0, 0, 1}, 8));  // empty yet
  point.add({1.0, 2.0, 3.0});
  EXPECT_FALSE(techniques::parallel_picture(point, {0, 0, 1}, 8));
  line.add({0.0, 0.0, 0.0}), line.add({4.0, 0.0, 0.0});
  EXPECT_FALSE(techniques::parallel_picture(line, {1, 0, 0}, 8));  // a point from there
  EXPECT_EQ(techniques::parallel_picture(line, {0, 0, 1}, 8)->size_px, glm::ivec2(8, 1));
  endless.add(glm::dvec3(0.0)), endless.add(glm::dvec3(std::numeric_limits<double>::infinity()));
  EXPECT_FALSE(techniques::parallel_picture(endless, {0, 0, 1}, 8));
}

/// The angle between two directions on the ring is 0…180°; the nearest of twelve is within 15°.
TEST(TwelveViews, ChoosesTheViewWhoseDirectionIsNearest) {
  for (int k = 0; k < kTwelve; ++k) {
    for (const double beside_deg : {-14.99, -7.0, 0.0, 7.0, 14.99}) {
      for (const double height : {-20.0, 0.0, 20.0}) {
        EXPECT_EQ(nearest_of_twelve(around(30.0 * k + beside_deg, 50.0, height)), k) << beside_deg << ' ' << height;
      }
    }
    EXPECT_EQ(nearest_of_twelve(twelve_views_direction(k, 60.0)), k);
  }
  EXPECT_EQ(nearest_of_twelve({0.0, 7.0, 0.0}), 0);  // none is nearer than another
}

/// Far along a baked direction, with a pixel a texel, the plate has the pixels of the object itself.
TEST(TwelveViews, FromABakedDirectionInParallelHasEveryPixelOfTheObject) {
  const geometry::Scene scene = lopsided_object();
  const World world(scene, {}, false);
  for (const double elevation_deg : {0.0, 10.0, 45.0}) {
    Showing shown(world, TwelveViews({.elevation_deg = elevation_deg, .texels = 90, .far = kAnywhere}));
    Showing plain(world, techniques::Plain{});
    for (int k = 0; k < kTwelve; ++k) {
      const auto picture =
          techniques::parallel_picture(world.objects()[0].bounds, twelve_views_direction(k, elevation_deg), 90);
      View view{.camera = picture->camera, .size_px = picture->size_px};
      view.camera.eye += 100.0 * view.camera.back;
      view.camera.near = 1.0, view.camera.far = 200.0;
      const TechniquePicture plates = shown.picture(view), whole = plain.picture(view);
      ASSERT_EQ(plates.count("shown"), 1u);
      EXPECT_EQ(n_different(plates.image, whole.image), 0) << k << ' ' << elevation_deg;
      EXPECT_EQ(ids_seen(plates.image), 1u);
    }
  }
}

/// In perspective, at distance D along a baked direction d, a point a beside and b above the centre, z before it, is
/// seen at f·(a, b)/(D − z). Its place on the upright plate is b·tan e before the centre, e the elevation, so that it
/// is shown at f·(a, b)/(D − b·tan e). With |(a, b)|, |z| ≤ R the two are at most f·R²·(1 + tan e)/(D − R·max(1, tan
/// e))² apart.
TEST(TwelveViews, FromABakedDirectionMovesAPointByNoMoreThanItsDistanceFromThePlateTells) {
  const geometry::Scene scene = lopsided_object();
  const World world(scene, {}, false);
  const double kDistance = 60.0, kFocal_px = 650.0, kElevation_deg = 10.0;
  const double tan_e = geometry::tangent(kElevation_deg * geometry::kPi / 180.0);
  Showing shown(world, TwelveViews({.elevation_deg = kElevation_deg, .texels = 512, .far = kAnywhere}));
  Showing plain(world, techniques::Plain{});
  const geometry::Bounds& box = world.objects()[0].bounds;
  const double radius = 0.5 * box.diagonal();
  const double bound_px = kFocal_px * radius * radius * (1.0 + tan_e) / ((kDistance - radius) * (kDistance - radius));
  for (const int k : {9, 10, 11, 0, 1, 2, 3}) {  // from where all of the knob is seen
    View view{.camera = {}, .size_px = {640, 480}};
    view.camera.tan_half_fov_y = 240.0 / kFocal_px;
    const glm::dvec3 eye = box.centre() + kDistance * twelve_views_direction(k, kElevation_deg);
    geometry::look_at(view.camera, eye, box.centre());
    const auto now = knob_px(shown.picture(view).image), truly = knob_px(plain.picture(view).image);
    ASSERT_TRUE(now && truly) << k;
    const glm::dvec3 knob = kKnob - box.centre();
    const glm::dvec2 beside(glm::dot(knob, view.camera.right), glm::dot(knob, view.camera.up));
    const glm::dvec2 expected = kFocal_px * glm::dvec2(beside.x, -beside.y) / (kDistance - beside.y * tan_e);
    EXPECT_LE(glm::length(*now - glm::dvec2(319.5, 239.5) - expected), 1.0) << k;  // the middle of a few pixels
    EXPECT_LE(glm::length(*now - *truly), bound_px) << k;
  }
}

TEST(TwelveViews, ShowsAnUprightPlateAroundTheBoxThatStandsStill) {
  const geometry::Scene scene = lopsided_object();
  const World world(scene, {}, false);
  techniques::Stage stage(world);
  TwelveViews technique({.texels = 64, .far = kAnywhere});
  technique.prepare(stage);
  std::array<glm::dvec3, 4> first;
  for (const double angle_deg : {50.0, 60.0, 70.0}) {
    const View view = view_from(around(angle_deg, 40.0, 3.0));
    stage.begin(view);
    static_cast<void>(technique.draw(view, stage));
    ASSERT_EQ(stage.plates().size(), 1u);
    const auto& corners = stage.plates()[0].corners_world;
    EXPECT_EQ(corners[0].x, corners[1].x);  // upright
    EXPECT_EQ(corners[0].z, corners[1].z);
    if (angle_deg == 50.0) first = corners;
    EXPECT_EQ(corners, first);
  }
}

TEST(TwelveViews, CountsEveryByteOfItsPictures) {
  const geometry::Scene scene = row_of_balls();
  const World world(scene, {}, false);
  for (const int texels : {1, 7, 64}) {
    techniques::Stage stage(world);
    TwelveViews technique({.texels = texels});
    technique.prepare(stage);
    const View view = view_from(around(0.0, 60.0));
    stage.begin(view);
    const techniques::Counters counters = technique.draw(view, stage);
    EXPECT_EQ(std::string(counters.back().name), "picture_bytes");
    EXPECT_EQ(counters.back().value, stage.picture_bytes()) << texels;
    EXPECT_EQ(stage.work().captures, 0u);  // all were taken before
    // A ball's outline fills at least half of the square around it (1/√2 where its box is seen from a corner).
    EXPECT_GE(counters.back().value, 5u * 12u * std::uint64_t(texels * texels) * 20u / 2u);
  }
}

TEST(TwelveViews, DrawsWhatFindsNoRoom) {
  const geometry::Scene scene = row_of_balls();
  const World world(scene, {}, false);
  const View view = view_from(around(0.0, 60.0));
  Showing all(world, TwelveViews({.texels = 32}));
  const std::uint64_t each = all.picture(view).count("picture_bytes") / 5;
  Showing three(world, TwelveViews({.texels = 32, .most_bytes = 4 * each - 1}));
  const TechniquePicture picture = three.picture(view);
  EXPECT_EQ(picture.count("shown"), 3u);
  EXPECT_EQ(picture.count("unfit"), 2u);
  EXPECT_EQ(picture.count("picture_bytes"), 3 * each);
  EXPECT_EQ(picture.drawn, (std::vector<bool>{false, false, false, true, true}));
}

TEST(TwelveViews, ShowsSomethingOfEveryObjectWithOneTexel) {
  const geometry::Scene scene = row_of_balls();
  const World world(scene, {}, false);
  Showing shown(world, TwelveViews({.texels = 1}));
  const TechniquePicture picture = shown.picture(view_from(around(0.0, 60.0)));
  EXPECT_EQ(picture.count("shown"), 5u);
  EXPECT_EQ(ids_seen(picture.image), 5u);
}

TEST(TwelveViews, DrawsWhatIsNear) {
  const geometry::Scene scene = row_of_balls();
  const World world(scene, {}, false);
  Showing shown(world, TwelveViews({.far = {.radii = 0.0, .distance = 62.0}}));
  // 60 from the middle ball, √(60² + 10²) = 60.8 and √(60² + 20²) = 63.2 from the others.
  const TechniquePicture picture = shown.picture(view_from({0.0, 0.0, 60.0}));
  EXPECT_EQ(picture.count("near"), 3u);
  EXPECT_EQ(picture.count("shown"), 2u);
  EXPECT_EQ(picture.drawn, (std::vector<bool>{false, true, true, true, false}));
}

/// Around the eye, behind it, without size or extent: what no plate would do for is drawn, all of it.
TEST(TwelveViews, DrawsWhateverNoPictureWouldDoFor) {
  const geometry::Scene scene = awkward_objects();
  const World world(scene, {}, false);
  Showing shown(world, TwelveViews({.texels = 16, .far = kAnywhere}));
  Showing plain(world, techniques::Plain{});
  for (const glm::dvec3& eye : {glm::dvec3(0, 0, 0), glm::dvec3(0, 0, 20), glm::dvec3(400, 3, -400)}) {
    for (const glm::dvec3& target :
         {eye + glm::dvec3(0, 0, -1), eye + glm::dvec3(1, 2, 3), eye + glm::dvec3(0, 1, 0)}) {
      const View view = view_from(eye, target);
      const TechniquePicture picture = shown.picture(view);
      EXPECT_EQ(difference_from_plain(picture, plain.picture(view)), "");
      EXPECT_EQ(picture.count("shown"), 0u);
      EXPECT_EQ(picture.count("unfit"), picture.count("objects_in_view"));
    }
  }
}

TEST(TwelveViews, TakesLinearColoursOnly) {
  const geometry::Scene scene = row_of_balls();
  const World world(scene, kRawUnlit, false);
  techniques::Stage stage(world);
  EXPECT_THROW(TwelveViews().prepare(stage), raster::Error);
}

}  // namespace
}  // namespace lode::tests
