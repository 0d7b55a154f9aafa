// Pictures of far objects that are kept from frame to frame (techniques/image_reuse/README.md).
#include "techniques/image_reuse/image_reuse.h"

#include <gtest/gtest.h>

#include <cmath>
#include <glm/gtc/matrix_transform.hpp>
#include <map>
#include <string>

#include "geometry/procedural.h"
#include "geometry/trigonometry.h"
#include "techniques/plain/plain.h"

namespace lode::techniques {
namespace {

using geometry::Scene;

constexpr double kDegree = geometry::kPi / 180.0;

geometry::Material colored(const glm::vec4& color) {
  geometry::Material material;
  material.color = color;
  return material;
}

glm::dmat4 moved(double x, double z) { return glm::translate(glm::dmat4(1.0), glm::dvec3(x, 0.0, z)); }

/// Balls of radius 3 around (x, 0, 0), x = −20, −10, 0, 10, 20, which no plate of another one cuts.
Scene row_of_balls() {
  Scene scene;
  for (int k = 0; k < 5; ++k) {
    const auto share = float(k) / 4.0f;
    geometry::add_instance(scene, geometry::sphere(glm::dvec3(0.0), 3.0, 24, 12),
                           colored({1.0f - share, share, 0.5f, 1}), moved(-20.0 + 10.0 * k, 0.0));
  }
  return scene;
}

View view_from(const glm::dvec3& eye, const glm::dvec3& target = glm::dvec3(0.0)) {
  View view{.camera = {}, .size_px = {320, 200}};
  geometry::look_at(view.camera, eye, target);
  return view;
}

/// `eye` turned about the vertical axis through the origin.
glm::dvec3 around(double angle_deg, double distance, double height = 4.0) {
  const geometry::SinCos turn = geometry::sin_cos(angle_deg * kDegree);
  return {distance * turn.sin, height, distance * turn.cos};
}

raster::Image drawn(Stage& stage, const View& view) {
  raster::Image image = raster::make_image(view.size_px, raster::ColorFormat::rgba32f);
  raster::render({.draws = stage.draws(), .clear = view.background, .viewport = {}, .scissor = {}}, image);
  return image;
}

/// A scene, and what the technique makes of one view after the other.
class Walk {
 public:
  explicit Walk(const Scene& scene, const ImageReuse::Params& params = {})
      : world_(scene, {}, false), stage_(world_), plain_(world_), reuse_(params) {
    reuse_.prepare(stage_);
  }

  raster::Image step(const View& view) {
    stage_.begin(view);
    counters_.clear();
    for (const Counter& counter : reuse_.draw(view, stage_)) counters_[counter.name] = counter.value;
    return drawn(stage_, view);
  }
  raster::Image whole(const View& view) {
    plain_.begin(view);
    Plain{}.draw(view, plain_);
    return drawn(plain_, view);
  }
  std::uint64_t operator[](const std::string& counter) const { return counters_.at(counter); }
  [[nodiscard]] const World& world() const { return world_; }
  [[nodiscard]] const StageWork& work() const { return stage_.work(); }
  void cut() { reuse_.cut(); }

 private:
  World world_;
  Stage stage_, plain_;
  ImageReuse reuse_;
  std::map<std::string, std::uint64_t> counters_;
};

TEST(ImageReuse, AtThePoseOfTheCaptureHasEveryBitOfThePictureItself) {
  const Scene scene = row_of_balls();
  Walk walk(scene);
  for (int pose = 0; pose < 40; ++pose) {
    walk.cut();
    const View view = view_from(around(9.0 * pose + 3.0, 60.0 + pose, 0.5 * pose), {0.3 * pose, 0.0, 0.0});
    const raster::Image whole = walk.whole(view);
    for (const char* counter : {"captured", "reused"}) {
      const raster::Image image = walk.step(view);
      EXPECT_EQ(walk[counter], walk["objects_in_view"]) << pose;
      EXPECT_EQ(walk.work().objects, 0u);
      ASSERT_EQ(image.rgba32f, whole.rgba32f) << pose << counter;
    }
  }
}

TEST(ImageReuse, CapturesWhatReachesBeyondTheView) {
  const Scene scene = row_of_balls();
  Walk walk(scene);
  const View half_out = view_from({-40.0, 0.0, 60.0}, {-57.0, 0.0, 0.0});  // the left ball at the right edge
  EXPECT_EQ(walk.step(half_out).rgba32f, walk.whole(half_out).rgba32f);
  View turned = half_out;
  geometry::look_at(turned.camera, half_out.camera.eye, {-20.0, 0.0, 0.0});
  walk.step(turned);
  EXPECT_EQ(walk["captured"], walk["objects_in_view"] - 1u);
  EXPECT_EQ(walk["reused"], 1u);  // nothing of it is missing
}

/// A box [−5, 5] × [0, 8] × [−5, 5] seen from (0, 1.7, D): its near face spans heights −1.7 to 6.3 around the eye's,
/// its centre is 2.3 above. With f px at distance 1, the rectangle's middle is 2.3·f/(D − 5) above the picture's, the
/// centre 2.3·f/D: they are 2.3·f·(1/(D − 5) − 1/D) px apart.
TEST(ImageReuse, InLiteralPlacementJumpsByTheDistanceOfTheRectanglesMiddleFromTheCentre) {
  Scene scene;
  geometry::add_instance(scene, geometry::box({-5.0, 0.0, -5.0}, {5.0, 8.0, 5.0}), colored({1, 0.5f, 0, 1}));
  Walk walk(scene, {.placement = PlatePlacement::literal, .far = {.distance = 0.0}});
  View view{.camera = {}, .size_px = {320, 240}};
  view.camera.tan_half_fov_y = 120.0 / 650.0;  // f = 650
  int n_whole = 0;
  for (int above_px = 15; above_px <= 28; ++above_px) {  // of the centre: on the grid
    const double distance = 2.3 * 650.0 / above_px;
    view.camera.eye = {0.0, 1.7, distance};
    walk.cut();
    const raster::Image whole = walk.whole(view);
    EXPECT_EQ(walk.step(view).rgba32f, whole.rgba32f);  // the frame that is copied
    EXPECT_EQ(walk["captured"], 1u);
    const std::optional<raster::Rect> window = capture_window(view, walk.world().objects()[0].bounds);
    ASSERT_TRUE(window);
    const double jump = 120.0 - above_px - (window->origin_px.y + 0.5 * window->size_px.y);  // down
    EXPECT_NEAR(jump, 2.3 * 650.0 * (1.0 / (distance - 5.0) - 1.0 / distance),
                1.0);  // the rectangle is of whole pixels
    const int down = int(jump);
    if (jump != down) continue;  // half a pixel: its rows are mixed
    ++n_whole;
    const raster::Image again = walk.step(view);
    EXPECT_EQ(walk["reused"], 1u);
    for (int y = down; y < 240; ++y) {
      for (int x = 0; x < 320; ++x) {
        const auto here = std::size_t(y * 320 + x), before = std::size_t((y - down) * 320 + x);
        ASSERT_EQ(again.rgba32f[here], whole.rgba32f[before]) << x << ' ' << y << ", down by " << down;
      }
    }
  }
  EXPECT_GE(n_whole, 3);
}

TEST(ImageReuse, ReusesUntilTheViewingAngleHasTurnedByTheThreshold) {
  Scene scene;
  geometry::add_instance(scene, geometry::sphere(glm::dvec3(0.0), 2.0, 16, 8), {});
  for (const double threshold_deg : {0.5, 2.0, 10.0, 90.0}) {
    Walk walk(scene, {.threshold_deg = threshold_deg});
    walk.step(view_from(around(10.0, 50.0, 0.0)));
    for (const double turn_deg : {0.0, 0.5, 0.999}) {
      walk.step(view_from(around(10.0 + turn_deg * threshold_deg, 50.0, 0.0)));
      EXPECT_EQ(walk["reused"], 1u) << threshold_deg << ' ' << turn_deg;
    }
    walk.step(view_from(around(10.0 - 1.001 * threshold_deg, 50.0, 0.0)));  // from the first one: the others took none
    EXPECT_EQ(walk["captured"], 1u) << threshold_deg;
  }
}

TEST(ImageReuse, NeverReusesAtZeroAndAlwaysAt180) {
  const Scene scene = row_of_balls();
  const View front = view_from({0.0, 0.0, 80.0}), back = view_from({0.0, 0.0, -80.0});
  Walk never(scene, {.threshold_deg = 0.0});
  never.step(front), never.step(front);
  EXPECT_EQ(never["captured"], 5u);
  EXPECT_EQ(never["reused"], 0u);
  Walk always(scene, {.threshold_deg = 180.0});
  always.step(front), always.step(back);
  EXPECT_EQ(always["captured"], 0u);
  EXPECT_EQ(always["reused"], 5u);
}

TEST(ImageReuse, TakesNoNewPictureOnAStraightApproachUnlessPixelsGrow) {
  Scene scene;
  geometry::add_instance(scene, geometry::sphere(glm::dvec3(0.0), 2.0, 16, 8), {});
  Walk paper(scene), guarded(scene, {.magnification = 1.25});
  std::uint64_t n_paper = 0, n_guarded = 0;
  for (double distance = 200.0; distance >= 40.0; distance -= 4.0) {
    const View view = view_from({0.0, 0.0, distance});
    paper.step(view), guarded.step(view);
    n_paper += paper["captured"], n_guarded += guarded["captured"];
  }
  EXPECT_EQ(n_paper, 1u);
  // At 200, and whenever the distance has fallen to less than 4/5 of the last one's, in steps of 4: 156, 124, 96, 76,
  // 60, 44 (156 < 160, 124 < 124.8, 96 < 99.2, 76 < 76.8, 60 < 60.8, 44 < 48).
  EXPECT_EQ(n_guarded, 7u);
}

TEST(ImageReuse, WithYawOnlyLooksAtDirectionsFromAbove) {
  Scene scene;
  geometry::add_instance(scene, geometry::sphere(glm::dvec3(0.0), 2.0, 16, 8), {});
  Walk full(scene), yaw(scene, {.angle = AngleRule::yaw});
  for (const double height : {0.0, 20.0}) {  // 22° up
    const View view = view_from({0.0, height, 50.0});
    full.step(view), yaw.step(view);
  }
  EXPECT_EQ(full["captured"], 1u);
  EXPECT_EQ(yaw["reused"], 1u);
}

TEST(ImageReuse, TakesThoseThatTurnedMostFirstWithinItsBudget) {
  const Scene scene = row_of_balls();
  Walk walk(scene, {.most_captures = 2});
  const View first = view_from({0.0, 0.0, 100.0});
  EXPECT_EQ(walk.step(first).rgba32f, walk.whole(first).rgba32f);
  EXPECT_EQ(walk["captured"], 2u);
  EXPECT_EQ(walk["postponed"], 3u);
  EXPECT_EQ(walk.work().objects, 3u);  // what has no picture is drawn
  walk.step(first), walk.step(first);
  EXPECT_EQ(walk["captured"], 1u);
  EXPECT_EQ(walk["reused"], 4u);
  // Sideways by 10: the nearer the middle, the more the direction turns: atan(x + 10) − atan(x) over 100.
  walk.step(view_from({10.0, 0.0, 100.0}, {10.0, 0.0, 0.0}));
  EXPECT_EQ(walk["captured"], 2u);
  EXPECT_EQ(walk["postponed"], 3u);
  EXPECT_EQ(walk.work().plates, 5u);  // the others show what they have
  EXPECT_EQ(walk.work().objects, 0u);
}

TEST(ImageReuse, KeepsOfAPictureWhatTheObjectCovers) {
  const Scene scene = row_of_balls();
  const World world(scene, {}, false);
  Stage stage(world);
  const View view = view_from({0.0, 0.0, 100.0});
  const std::vector<ObjectId> ball = {2};
  const raster::Rect window = *capture_window(view, world.objects()[2].bounds);
  const CapturedPicture& whole = stage.picture(stage.capture(ball, view, window));
  const CapturedPicture& covered = stage.picture(stage.capture_covered(ball, view, window));
  const glm::ivec2 begin = covered.origin_px - whole.origin_px, end = begin + covered.size_px();
  bool in_first_row = false, in_last_column = false;
  for (int y = 0; y < whole.size_px().y; ++y) {
    for (int x = 0; x < whole.size_px().x; ++x) {
      const auto i = std::size_t(y * whole.size_px().x + x);
      if (x < begin.x || y < begin.y || x >= end.x || y >= end.y) {
        ASSERT_EQ(whole.depth[i], 0.0f);
        continue;
      }
      const auto k = std::size_t((y - begin.y) * covered.size_px().x + x - begin.x);
      ASSERT_EQ(covered.depth[k], whole.depth[i]);
      ASSERT_EQ(covered.texture.levels[0].linear[k], whole.texture.levels[0].linear[i]);
      in_first_row |= y == begin.y && whole.depth[i] > 0.0f;
      in_last_column |= x == end.x - 1 && whole.depth[i] > 0.0f;
    }
  }
  EXPECT_TRUE(in_first_row && in_last_column);
  const std::vector<ObjectId> nothing;
  EXPECT_EQ(stage.picture(stage.capture_covered(nothing, view, window)).size_px(), glm::ivec2(1));
}

TEST(ImageReuse, KeepsItsLimitOfMemory) {
  const Scene scene = row_of_balls();
  const View front = view_from({0.0, 0.0, 100.0});
  Walk any(scene);
  any.step(front);
  // Room is made for all of an object's window, of which the covered part is kept: 1.5 times as much, here.
  const std::uint64_t one = any["picture_bytes"] / 5, of_two = 29 * one / 10;
  Walk walk(scene, {.most_bytes = of_two});
  const raster::Image image = walk.step(front);
  EXPECT_EQ(image.rgba32f, walk.whole(front).rgba32f);
  EXPECT_EQ(walk["captured"], 2u);
  EXPECT_EQ(walk["unfit"], 3u);
  EXPECT_LE(walk["picture_bytes"], of_two);
  // Only the rightmost ball is in the view: it takes the place of what is not shown.
  walk.step(view_from({20.0, 0.0, 100.0}, {85.0, 0.0, 0.0}));
  ASSERT_EQ(walk["objects_in_view"], 1u);
  EXPECT_EQ(walk["captured"], 1u);
  EXPECT_GE(walk["evicted"], 1u);
  EXPECT_LE(walk["picture_bytes"], of_two);
  Walk none(scene, {.most_bytes = one / 2});
  EXPECT_EQ(none.step(front).rgba32f, none.whole(front).rgba32f);
  EXPECT_EQ(none["unfit"], 5u);
  EXPECT_EQ(none["picture_bytes"], 0u);
}

TEST(ImageReuse, ForgetsAtACut) {
  const Scene scene = row_of_balls();
  Walk walk(scene);
  const View front = view_from({0.0, 0.0, 100.0});
  walk.step(front);
  walk.cut();
  walk.step(front);
  EXPECT_EQ(walk["captured"], 5u);
}

/// Near, around the eye, behind it, larger than the picture, without size: the whole scene's picture.
TEST(ImageReuse, DrawsWhateverNoPictureWouldDoFor) {
  Scene scene;
  geometry::add_instance(scene, geometry::box(glm::dvec3(-500.0), glm::dvec3(500.0)), colored({0.2f, 0.3f, 0.4f, 1}));
  geometry::add_instance(scene, geometry::sphere(glm::dvec3(0.0), 2.0, 16, 8), colored({1, 0, 0, 1}), moved(0, 60));
  geometry::add_instance(scene, geometry::sphere(glm::dvec3(0.0), 60.0, 16, 8), colored({0, 1, 0, 1}), moved(0, -80));
  geometry::add_instance(scene, geometry::box(glm::dvec3(1.0), glm::dvec3(1.0)), colored({1, 1, 1, 1}), moved(4, 0));
  for (const PlatePlacement placement : {PlatePlacement::corrected, PlatePlacement::literal}) {
    Walk walk(scene, {.placement = placement, .far = {.radii = 0.0, .distance = 0.0}});
    for (const glm::dvec3& eye :
         {glm::dvec3(0, 0, 20), glm::dvec3(0, 0, 0), glm::dvec3(5, 1, 1), glm::dvec3(0, 0, 61)}) {
      for (const glm::dvec3& target : {eye + glm::dvec3(0, 0, -1), eye + glm::dvec3(1, 2, 3)}) {
        const View view = view_from(eye, target);
        EXPECT_EQ(walk.step(view).rgba32f, walk.whole(view).rgba32f);
        walk.cut();
      }
    }
  }
}

/// The far plane cuts the object in front of its plate.
TEST(ImageReuse, DrawsWhatTheFarPlaneCutsBeforeItsMiddle) {
  const Scene scene = row_of_balls();
  for (const double far : {99.0, 100.5, 105.0}) {
    for (const geometry::Projection projection :
         {geometry::Projection::perspective, geometry::Projection::orthographic}) {
      Walk walk(scene);
      View view = view_from({0.0, 0.0, 100.0});
      view.camera.projection = projection, view.camera.height = 50.0, view.camera.far = far;
      const raster::Image whole = walk.whole(view);
      for (int frame = 0; frame < 2; ++frame) ASSERT_EQ(walk.step(view).rgba32f, whole.rgba32f) << far;
      EXPECT_EQ(walk["unfit"], far < 100.0 ? 5u : 0u);
    }
  }
}

/// A point z in front of the plate moves by f·z·sin Δ/(D − z·cos Δ) px as the eye turns by Δ, on the plate it stays:
/// the bound z·sin Δ·f/D of the report holds for z ≪ D, and for all z with D − z in place of D.
TEST(ImageReuse, MovesNoFeatureFartherThanItsDistanceFromThePlateTells) {
  const double kRadius = 5.0, kDistance = 60.0, kFocal_px = 650.0;
  Scene scene;  // a dark ball with a bright knob in front, at z = 5
  geometry::add_instance(scene, geometry::sphere(glm::dvec3(0.0), kRadius, 48, 24), colored({0, 0, 0.2f, 1}));
  geometry::Mesh knob = geometry::sphere({0.0, 0.0, kRadius}, 0.4, 16, 8);
  geometry::Material bright = colored({1, 0, 0, 1});
  bright.unlit = true;
  geometry::add_instance(scene, knob, bright);
  scene.instances[1].node = scene.instances[0].node;
  scene.objects = {{"ball", 0, 2}};
  const auto knob_px = [](const raster::Image& image) {  // its middle
    glm::dvec2 sum(0.0);
    double n = 0.0;
    for (int i = 0; i < 640 * 480; ++i) {
      if (image.rgba32f[std::size_t(i)].r < 0.5f) continue;
      sum += glm::dvec2(i % 640, i / 640), n += 1.0;
    }
    return sum / n;
  };
  for (const double turn_deg : {1.0, 2.0, 5.0}) {
    Walk walk(scene, {.threshold_deg = 1.01 * turn_deg});
    View view{.camera = {}, .size_px = {640, 480}};
    view.camera.tan_half_fov_y = 240.0 / kFocal_px;
    geometry::look_at(view.camera, around(0.0, kDistance, 0.0), glm::dvec3(0.0));
    walk.step(view);
    geometry::look_at(view.camera, around(turn_deg, kDistance, 0.0), glm::dvec3(0.0));
    const raster::Image shown = walk.step(view);
    ASSERT_EQ(walk["reused"], 1u);
    const double moved_px = glm::length(knob_px(shown) - knob_px(walk.whole(view)));
    const double bound_px = kRadius * std::sin(turn_deg * kDegree) * kFocal_px / (kDistance - kRadius);
    EXPECT_LE(moved_px, bound_px + 0.25) << turn_deg;
    EXPECT_GE(moved_px, 0.9 * bound_px - 0.25) << turn_deg;  // it is as bad as that
  }
}

}  // namespace
}  // namespace lode::techniques
