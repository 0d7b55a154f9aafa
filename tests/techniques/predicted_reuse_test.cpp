// Pictures that stay where they were taken and are taken anew by predicted error
// (techniques/predicted_reuse/README.md).
#include "techniques/predicted_reuse/predicted_reuse.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <bit>
#include <cmath>
#include <glm/gtc/matrix_transform.hpp>
#include <map>
#include <string>

#include "geometry/procedural.h"
#include "geometry/trigonometry.h"
#include "techniques/plain/plain.h"
#include "techniques/predicted_reuse/relief.h"

namespace lode::techniques {
namespace {

using geometry::Scene;

geometry::Material colored(const glm::vec4& color) {
  geometry::Material material;
  material.color = color;
  return material;
}

/// Balls of radius 3 around (x, 0, 0), x = −20, −10, 0, 10, 20.
Scene row_of_balls() {
  Scene scene;
  for (int k = 0; k < 5; ++k) {
    const auto share = float(k) / 4.0f;
    geometry::add_instance(scene, geometry::sphere(glm::dvec3(0.0), 3.0, 24, 12),
                           colored({1.0f - share, share, 0.5f, 1}),
                           glm::translate(glm::dmat4(1.0), glm::dvec3(-20.0 + 10.0 * k, 0.0, 0.0)));
  }
  return scene;
}

View view_from(const glm::dvec3& eye, const glm::dvec3& target = glm::dvec3(0.0)) {
  View view{.camera = {}, .size_px = {320, 200}};
  geometry::look_at(view.camera, eye, target);
  return view;
}

glm::dvec3 around(double angle_deg, double distance, double height = 4.0) {
  const geometry::SinCos turn = geometry::sin_cos(angle_deg * geometry::kPi / 180.0);
  return {distance * turn.sin, height, distance * turn.cos};
}

raster::Image drawn(Stage& stage, const View& view) {
  raster::Image image = raster::make_image(view.size_px, raster::ColorFormat::rgba32f);
  raster::render({.draws = stage.draws(), .clear = view.background, .viewport = {}, .scissor = {}}, image);
  return image;
}

double squared_error(const raster::Image& a, const raster::Image& b) {
  double sum = 0.0;
  for (std::size_t i = 0; i < a.rgba32f.size(); ++i) {
    const glm::vec4 d = a.rgba32f[i] - b.rgba32f[i];
    sum += double(glm::dot(d, d));
  }
  return sum;
}

class Walk {
 public:
  explicit Walk(const Scene& scene, const PredictedReuse::Params& params = {})
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
  [[nodiscard]] Stage& stage() { return stage_; }
  [[nodiscard]] const World& world() const { return world_; }
  void cut() { reuse_.cut(); }

 private:
  World world_;
  Stage stage_, plain_;
  PredictedReuse reuse_;
  std::map<std::string, std::uint64_t> counters_;
};

TEST(PredictedReuse, PlatesHaveEveryBitAtThePoseOfTheCapture) {
  const Scene scene = row_of_balls();
  Walk walk(scene, {.most_captures = 0, .cell_px = 0});
  for (int pose = 0; pose < 12; ++pose) {
    walk.cut();
    const View view = view_from(around(30.0 * pose + 3.0, 60.0 + pose, 0.5 * pose));
    const raster::Image whole = walk.whole(view);
    for (const char* counter : {"captured", "reused"}) {
      EXPECT_EQ(walk.step(view).rgba32f, whole.rgba32f) << pose << counter;
      EXPECT_EQ(walk[counter], walk["objects_in_view"]);
    }
  }
}

TEST(PredictedReuse, PlatesStayWhereTheyWereTakenAsTheCameraTurns) {
  const Scene scene = row_of_balls();
  Walk walk(scene, {.most_captures = 0, .cell_px = 0});
  const View before = view_from({0, 4, 60});
  walk.step(before);
  const std::array<glm::dvec3, 4> corners = walk.stage().plates()[2].corners_world;
  View turned = before;
  geometry::look_at(turned.camera, before.camera.eye, {3.0, 0.0, 0.0});
  walk.step(turned);
  EXPECT_EQ(walk["reused"], walk["objects_in_view"]);  // no error is predicted: the eye has not moved
  EXPECT_EQ(walk.stage().plates()[2].corners_world, corners);
}

// A box of half extents (1, 2, 3) seen from +z at distance 100: it reaches 3 towards the eye. f = 100 / tan.
TEST(PredictedReuse, PredictsTheParallaxAndTheGrowth) {
  const geometry::Bounds box = {{-1, -2, -3}, {1, 2, 3}};
  const View view = view_from({0, 0, 100});
  const double pixel = 2.0 * 100.0 * view.camera.tan_half_fov_y / 200.0;
  EXPECT_EQ(predicted_error_px(view, box, {0, 0, 100}, pixel), 0.0);
  EXPECT_EQ(predicted_error_px(view, box, {0, 0, 70}, 0.7 * pixel), 0.0);  // pixels that have shrunk
  EXPECT_NEAR(predicted_error_px(view, box, {0, 0, 150}, 1.5 * pixel), 0.25, 1e-9);
  EXPECT_NEAR(predicted_error_px(view, box, around(5.0, 100.0, 0.0), pixel),
              3.0 * std::sin(5 * geometry::kPi / 180) / pixel, 1e-9);
  EXPECT_GT(predicted_error_px(view, box, {0, 0, -100}, pixel), 2.9 / pixel);  // from behind
  EXPECT_GT(predicted_error_px(view, box, {0, 0, 0}, pixel), 1e100);           // taken in the centre
}

TEST(PredictedReuse, TakesAnewWhatIsPredictedWorseThanTheLimit) {
  const Scene scene = row_of_balls();
  // The balls reach 3 towards any side of their boxes: of about 4.2 at 45°. Parallax of 3·sin Δ at 0.25 units a pixel.
  std::uint64_t before = 1000;
  for (const double limit_px : {0.1, 0.5, 2.0, 50.0}) {
    Walk walk(scene, {.error_px = limit_px, .most_captures = 0});
    std::uint64_t captured = 0;
    for (int k = 0; k <= 30; ++k) {
      walk.step(view_from(around(0.5 * k, 60.0)));
      captured += walk["captured"];
      EXPECT_EQ(walk["late"], 0u);
    }
    EXPECT_LT(captured, before);
    before = captured;
  }
  EXPECT_EQ(before, 5u);  // once each
}

TEST(PredictedReuse, TakesTheWorstFirstAndNoMoreThanItMay) {
  const Scene scene = row_of_balls();
  Walk walk(scene, {.error_px = 0.25, .most_captures = 2});
  const View first = view_from({0, 4, 60});
  for (const std::uint64_t captured : {2u, 2u, 1u}) {  // what has no picture yet is drawn
    walk.step(first);
    EXPECT_EQ(walk["captured"], captured);
    EXPECT_EQ(walk["late"], 0u);
  }
  walk.step(view_from(around(20.0, 60.0)));
  EXPECT_EQ(walk["captured"], 2u);
  EXPECT_EQ(walk["late"], 3u);
}

// A front with steps of 4 units: what is nearer than the plate's plane moves one way, what is behind it the other. (Of
// a ball a plate has the right outline from everywhere, and a relief lacks what the first eye did not see.)
TEST(PredictedReuse, AReliefIsCloserToTheTruthThanAPlate) {
  geometry::Mesh steps;
  for (int k = 0; k < 6; ++k) {
    const geometry::Mesh box =
        geometry::box({-6.0 + 2.0 * k, -3.0, -6.0}, {-4.0 + 2.0 * k, 3.0, k % 2 == 0 ? 2.0 : 6.0});
    const auto first = std::uint32_t(steps.positions.size());
    steps.positions.insert(steps.positions.end(), box.positions.begin(), box.positions.end());
    steps.normals.insert(steps.normals.end(), box.normals.begin(), box.normals.end());
    for (const std::uint32_t index : box.indices) steps.indices.push_back(first + index);
  }
  Scene scene;
  geometry::add_instance(scene, steps, colored({1, 0.5f, 0, 1}));
  const View first = view_from({0, 4, 60}), moved = view_from(around(6.0, 60.0));
  double error[2];
  for (const int cell_px : {0, 4}) {
    Walk walk(scene, {.error_px = 1e6, .most_captures = 0, .cell_px = cell_px});
    walk.step(first);
    const raster::Image image = walk.step(moved);
    EXPECT_EQ(walk["reused"], walk["objects_in_view"]);
    EXPECT_EQ(walk["relief_triangles"] > 0, cell_px > 0);
    error[cell_px > 0] = squared_error(image, walk.whole(moved));
  }
  EXPECT_LT(error[1], 0.5 * error[0]);
}

TEST(Relief, CornersAreSeenWhereThePictureHasThem) {
  const Scene scene = row_of_balls();
  Walk walk(scene);
  const View view = view_from({0, 4, 60});
  const std::vector<ObjectId> ball = {2};
  const raster::Rect window{{140, 80}, {41, 39}};
  const PictureId id = walk.stage().capture(ball, view, window);
  const glm::dvec3 centre = walk.world().objects()[2].bounds.centre();
  const PictureRelief relief = make_relief(walk.stage().picture(id), centre, 8);
  ASSERT_EQ(relief.positions.size(), relief.uvs.size());
  ASSERT_GT(relief.indices.size(), 3u * 8u);
  const glm::dmat4 clip_from_world = geometry::clip_from_world(view.camera, view.size_px);
  for (std::size_t k = 0; k < relief.positions.size(); ++k) {
    const glm::dvec4 p = clip_from_world * glm::dvec4(centre + glm::dvec3(relief.positions[k]), 1.0);
    const glm::dvec2 px((0.5 + 0.5 * p.x / p.w) * 320.0, (0.5 - 0.5 * p.y / p.w) * 200.0);
    const glm::dvec2 expected = glm::dvec2(window.origin_px) + glm::dvec2(relief.uvs[k]) * glm::dvec2(window.size_px);
    EXPECT_NEAR(px.x, expected.x, 1e-3);
    EXPECT_NEAR(px.y, expected.y, 1e-3);
    EXPECT_LT(glm::length(relief.positions[k]), 3.0 * 1.6);  // on the ball, or beside it as far away as its rim
  }
  for (const std::uint32_t index : relief.indices) EXPECT_LT(index, relief.positions.size());
  const std::uint64_t bytes = relief.positions.size() * 20 + relief.indices.size() * 4;
  EXPECT_LE(bytes, most_relief_bytes(window.size_px, 8));
  EXPECT_EQ(most_relief_bytes(window.size_px, 0), 0u);
}

TEST(Relief, OfAnEmptyPictureIsEmpty) {
  const Scene scene = row_of_balls();
  Walk walk(scene);
  const std::vector<ObjectId> nothing;
  const PictureId id = walk.stage().capture(nothing, view_from({0, 4, 60}), {{0, 0}, {20, 20}});
  EXPECT_TRUE(make_relief(walk.stage().picture(id), glm::dvec3(0.0), 1).indices.empty());
}

TEST(PredictedReuse, KeepsItsLimitOfMemory) {
  const Scene scene = row_of_balls();
  const View view = view_from({0, 4, 60});
  Walk all(scene, {.most_captures = 0});
  all.step(view);
  const std::uint64_t each = all["picture_bytes"] / 5;
  Walk two(scene, {.most_captures = 0, .most_bytes = 5 * each / 2});
  for (int k = 0; k < 3; ++k) {
    two.step(view);
    EXPECT_LE(two["picture_bytes"], 5 * each / 2);
    EXPECT_GE(two["unfit"], 2u);  // the others are drawn
  }
}

TEST(PredictedReuse, NothingIsShownOfWhatIsNearOrCut) {
  const Scene scene = row_of_balls();
  Walk walk(scene, {.most_captures = 0});
  const View near = view_from({0, 0, 12});
  EXPECT_EQ(walk.step(near).rgba32f, walk.whole(near).rgba32f);
  EXPECT_EQ(walk["near"], walk["objects_in_view"]);
  const View inside = view_from({0, 0, 1}, {0, 0, -1});
  EXPECT_EQ(walk.step(inside).rgba32f, walk.whole(inside).rgba32f);
  walk.step(view_from({0, 4, 60}));
  walk.cut();
  walk.step(view_from({0, 4, 60}));
  EXPECT_EQ(walk["captured"], walk["objects_in_view"]);
}

Scene one_ball() {
  Scene scene;
  geometry::add_instance(scene, geometry::sphere(glm::dvec3(0.0), 3.0, 24, 12), colored({1, 0.5f, 0.25f, 1}));
  return scene;
}

TEST(CrossFade, EachPixelIsTheOldPicturesOrTheNewOnes) {
  const Scene scene = one_ball();
  // The ball reaches 3 from its middle, and 20° of that are 4.1 px.
  Walk fading(scene, {.error_px = 2.0, .most_captures = 0, .cell_px = 0, .fade_frames = 3}),
      at_once(scene, {.error_px = 2.0, .cell_px = 0}), never(scene, {.error_px = 1e9, .cell_px = 0});
  const View before = view_from(around(0.0, 60.0)), after = view_from(around(20.0, 60.0));
  for (Walk* walk : {&fading, &at_once, &never}) walk->step(before);
  const raster::Image of_new = at_once.step(after), of_old = never.step(after);
  ASSERT_GT(squared_error(of_new, of_old), 0.0);
  for (const int share : {4, 8, 12, 16}) {
    const raster::Image shown = fading.step(after);
    EXPECT_EQ(fading["faded"], share < 16 ? 1u : 0u);
    for (int y = 0; y < after.size_px.y; ++y) {
      for (int x = 0; x < after.size_px.x; ++x) {
        const bool is_new = (dithered_pixels(share) >> (x % 4 + 4 * (y % 4)) & 1) != 0;
        const auto i = std::size_t(y * after.size_px.x + x);
        ASSERT_EQ(shown.rgba32f[i], (is_new ? of_new : of_old).rgba32f[i]) << share << ": " << x << ", " << y;
      }
    }
  }
}

TEST(CrossFade, AnOldPictureDoesNotComeBackAfterAGap) {
  const Scene scene = one_ball();
  Walk fading(scene, {.most_captures = 0, .fade_frames = 9}), at_once(scene, {});
  const View before = view_from(around(0.0, 60.0)), after = view_from(around(40.0, 60.0));
  const View away = view_from({0, 4, 60}, {0, 4, 120});
  for (const View& view : {before, after, away}) fading.step(view), at_once.step(view);
  EXPECT_EQ(fading.step(after).rgba32f, at_once.step(after).rgba32f);
  EXPECT_EQ(fading["faded"], 0u);
  EXPECT_EQ(fading["picture_bytes"], at_once["picture_bytes"]);
}

TEST(CrossFade, AnOldPictureThatIsFarOffGoesAtOnce) {
  const Scene scene = one_ball();
  Walk fading(scene, {.most_captures = 0, .fade_frames = 9}), at_once(scene, {.most_captures = 0});
  for (const double angle_deg : {0.0, 120.0, 240.0, 150.0}) {
    const View view = view_from(around(angle_deg, 60.0));
    const raster::Image expected = at_once.step(view);
    EXPECT_EQ(fading.step(view).rgba32f, expected.rgba32f) << angle_deg;
    EXPECT_EQ(fading["faded"], 0u) << angle_deg;
  }
}

TEST(CrossFade, EndsThoughPicturesAreTakenInEveryFrame) {
  const Scene scene = one_ball();
  // Each step of 4° is 0.84 px: a picture a frame; after two of them the old one is 1.7 px off, less than thrice 0.75
  // px.
  Walk walk(scene, {.error_px = 0.75, .most_captures = 0, .cell_px = 0, .fade_frames = 1});
  std::vector<std::uint64_t> faded;
  for (int k = 0; k < 5; ++k) {
    walk.step(view_from(around(4.0 * k, 60.0)));
    EXPECT_EQ(walk["captured"], 1u) << k;
    faded.push_back(walk["faded"]);
  }
  // A fade, one frame in which it is over, and so on.
  EXPECT_EQ(faded, (std::vector<std::uint64_t>{0, 1, 0, 1, 0}));
}

TEST(CrossFade, TheNewPictureIsSeenFromItsFirstFrameOn) {
  const Scene scene = one_ball();
  Walk fading(scene, {.error_px = 2.0, .most_captures = 0, .cell_px = 0, .fade_frames = 1000}),
      never(scene, {.error_px = 1e9, .cell_px = 0});
  const View before = view_from(around(0.0, 60.0)), after = view_from(around(20.0, 60.0));
  for (Walk* walk : {&fading, &never}) walk->step(before);
  EXPECT_NE(fading.step(after).rgba32f, never.step(after).rgba32f);
}

TEST(PredictedReuse, CountsEveryObjectInViewOnce) {
  const Scene scene = row_of_balls();
  Walk walk(scene, {.most_captures = 1});
  std::uint64_t most_postponed = 0, most_late = 0;
  for (int k = 0; k < 8; ++k) {
    walk.step(view_from(around(30.0 * k, 60.0)));
    const std::uint64_t sum =
        walk["near"] + walk["reused"] + walk["captured"] + walk["late"] + walk["postponed"] + walk["unfit"];
    EXPECT_EQ(sum, walk["objects_in_view"]) << k;
    most_postponed = std::max(most_postponed, walk["postponed"]), most_late = std::max(most_late, walk["late"]);
  }
  EXPECT_EQ(most_postponed, 4u);
  EXPECT_EQ(most_late, 4u);
}

TEST(CrossFade, KeepsTheLimitOfMemory) {
  const Scene scene = row_of_balls();
  Walk all(scene, {.most_captures = 0});
  all.step(view_from({0, 4, 60}));
  const std::uint64_t limit = 7 * all["picture_bytes"] / 5;
  Walk walk(scene, {.most_captures = 0, .fade_frames = 5, .most_bytes = limit});
  std::uint64_t most_faded = 0;
  for (int k = 0; k < 12; ++k) {
    walk.step(view_from(around(4.0 * k, 60.0)));
    EXPECT_LE(walk["picture_bytes"], limit);
    most_faded = std::max(most_faded, walk["faded"]);
  }
  EXPECT_GE(most_faded, 1u);
}

TEST(Dither, EachStepTakesOneMorePixel) {
  EXPECT_EQ(dithered_pixels(0), 0);
  EXPECT_EQ(dithered_pixels(16), kEveryPixel);
  for (int n = 0; n < 16; ++n) {
    EXPECT_EQ(std::popcount(dithered_pixels(n)), n);
    EXPECT_EQ(dithered_pixels(n) & ~dithered_pixels(n + 1), 0);
  }
  EXPECT_EQ(dithered_pixels(2), 1 << 0 | 1 << (2 + 4 * 2));  // as far apart as can be
}

}  // namespace
}  // namespace lode::techniques
