// What the experiment on reuse of pictures makes of a walk: times by threshold, crossovers, displaced features, rows.
#include <gtest/gtest.h>

#include <cmath>
#include <memory>

#include "experiments/image_reuse/cost_model.h"
#include "experiments/image_reuse/displacement.h"
#include "experiments/image_reuse/names.h"
#include "experiments/image_reuse/summary.h"
#include "experiments/image_reuse/walk.h"
#include "geometry/procedural.h"
#include "geometry/procedural/houses.h"

namespace lode::experiments {
namespace {

TEST(CostModel, FitsWhatThePaperMeasured) {
  const std::vector<double> degrees = {1.0, 2.0, 5.0}, seconds = {33.2, 27.8, 23.2};
  const CostModel model = fit_cost_model(degrees, seconds);
  EXPECT_NEAR(model.t0, 21.1, 0.05);
  EXPECT_NEAR(model.k, 12.3, 0.05);
  EXPECT_LT(model.residual, 0.025);
  ASSERT_TRUE(model.break_even_deg(32.4));
  EXPECT_NEAR(*model.break_even_deg(32.4), 1.09, 0.005);
}

TEST(CostModel, FindsTheModelThatMadeTheTimes) {
  const std::vector<double> degrees = {0.5, 2.0, 10.0}, times = {3.0 + 8.0, 3.0 + 2.0, 3.0 + 0.4};
  const CostModel model = fit_cost_model(degrees, times);
  EXPECT_NEAR(model.t0, 3.0, 1e-12);
  EXPECT_NEAR(model.k, 4.0, 1e-12);
  EXPECT_LT(model.residual, 1e-12);
  EXPECT_FALSE(model.break_even_deg(2.5));  // never
  EXPECT_NEAR(*model.break_even_deg(5.0), 2.0, 1e-12);
}

TEST(CostModel, RefusesWhatHasNoFit) {
  const std::vector<double> one = {1.0}, two = {1.0, 1.0}, bad = {0.0, 1.0};
  EXPECT_THROW(static_cast<void>(fit_cost_model(one, one)), std::logic_error);
  EXPECT_THROW(static_cast<void>(fit_cost_model(two, two)), std::logic_error);
  EXPECT_THROW(static_cast<void>(fit_cost_model(bad, two)), std::logic_error);
  EXPECT_THROW(static_cast<void>(fit_cost_model(two, one)), std::logic_error);
}

TEST(Crossover, LiesBetweenTheSizesAroundIt) {
  const std::vector<double> size = {1000, 4000, 16000};
  EXPECT_NEAR(crossover(size, std::vector<double>{0.5, 1.5, 3.0}).value(), 2000.0, 1e-6);  // half of a factor of 4
  EXPECT_EQ(crossover(size, std::vector<double>{1.0, 1.5, 3.0}), 1000.0);
  EXPECT_NEAR(crossover(size, std::vector<double>{0.5, 0.5, 1.0}).value(), 16000.0, 1e-6);
  EXPECT_FALSE(crossover(size, std::vector<double>{0.5, 0.7, 0.99}));
}

/// One ball of radius 3 around the origin and a stage with its picture from `distance` along z.
struct CapturedBall {
  static constexpr double kRadius = 3.0, kDistance = 60.0;
  geometry::Scene scene;
  std::unique_ptr<techniques::World> world;
  std::unique_ptr<techniques::Stage> stage;
  techniques::PictureId picture{};
  std::array<glm::dvec3, 4> corners;

  CapturedBall() {
    geometry::add_instance(scene, geometry::sphere(glm::dvec3(0.0), kRadius, 24, 12), geometry::Material{},
                           glm::dmat4(1.0));
    world = std::make_unique<techniques::World>(scene, techniques::SceneDraws::Params{}, false);
    stage = std::make_unique<techniques::Stage>(*world);
    const techniques::View view = view_from({0.0, 0.0, kDistance});
    const std::vector<techniques::ObjectId> ball = {0};
    const raster::Rect window_px{{140, 80}, {40, 40}};
    picture = stage->capture(ball, view, window_px);
    // The window's corners in the plane z = 0: half of the view is 200 px, or kDistance · tan.
    const double pixel = 2.0 * kDistance * view.camera.tan_half_fov_y / 200.0;
    const auto at = [&](int x, int y) { return glm::dvec3((x - 160) * pixel, (100 - y) * pixel, 0.0); };
    corners = {at(140, 80), at(140, 120), at(180, 120), at(180, 80)};
  }

  static techniques::View view_from(const glm::dvec3& eye) {
    techniques::View view{.camera = {}, .size_px = {320, 200}};
    geometry::look_at(view.camera, eye, glm::dvec3(0.0));
    return view;
  }
  Displacement seen_from(const glm::dvec3& eye) {
    const techniques::View view = view_from(eye);
    stage->begin(view);
    stage->plate(0, picture, corners, techniques::PlateEdge::cutout);
    return displacement(*world, *stage, view, 1000);
  }
};

TEST(Displacement, IsNoneAtThePoseOfTheCapture) {
  CapturedBall ball;
  const Displacement none = ball.seen_from({0.0, 0.0, CapturedBall::kDistance});
  EXPECT_GT(none.n, 100u);
  EXPECT_LT(none.max_px, 1e-9);
}

TEST(Displacement, GrowsWithTheAngleAndStaysBelowItsBound) {
  CapturedBall ball;
  const double f_px = 100.0 / CapturedBall::view_from({0, 0, 1}).camera.tan_half_fov_y;
  double before = 0.0;
  for (const double degrees : {0.5, 1.0, 2.0, 5.0}) {
    const double angle = degrees * 3.141592653589793 / 180.0;
    const Displacement moved =
        ball.seen_from({CapturedBall::kDistance * std::sin(angle), 0.0, CapturedBall::kDistance * std::cos(angle)});
    const double z = CapturedBall::kRadius, bound = z * std::sin(angle) * f_px / (CapturedBall::kDistance - z);
    EXPECT_GT(moved.max_px, before);
    EXPECT_GT(moved.max_px, 0.7 * bound);
    EXPECT_LT(moved.max_px, 1.15 * bound);  // the bound is of first order: lines of sight are not parallel
    EXPECT_LT(moved.mean_px(), moved.max_px);
    before = moved.max_px;
  }
}

TEST(Displacement, OfNoPlatesIsNone) {
  CapturedBall ball;
  ball.stage->begin(CapturedBall::view_from({0, 0, 60}));
  EXPECT_EQ(displacement(*ball.world, *ball.stage, CapturedBall::view_from({0, 0, 60})).n, 0u);
}

Row row_of(const char* method, double frame, const char* column, double value) {
  Row row;
  row.add("scene", std::string("houses24:each=4000")).add("path", std::string("sideways")).add("frame", frame);
  row.add("method", std::string(method)).add(column, value);
  return row;
}

TEST(ReuseSummary, HoldsTheFastestOfTheOthersAgainstReuseAtEqualError) {
  CaseResult walk;
  const auto add = [&](const std::string& method, double ms, double flip) {
    walk.results.push_back(row_of(method.c_str(), 0.0, "flip", flip));
    walk.times.push_back(row_of(method.c_str(), 0.0, "frame_ms", ms));
  };
  add(kNoCache, 9.0, 0.0);
  add(reuse_at("1"), 6.0, 0.01);
  add(reuse_at("5"), 7.0, 0.02);  // slower than 1 degree, whose error is smaller
  add("close", 5.0, 0.01);
  add("far", 1.0, 0.03);
  add("close + skips", 2.0, 0.01);
  std::vector<Row> summary;
  add_summary(walk, 4000.0, summary);
  const std::vector<Row> equal = rows_with(summary, "kind", kOfEqualError);
  ASSERT_EQ(equal.size(), 2u);
  for (const Row& row : equal) {
    EXPECT_EQ(row.text("method"), reuse_at("1"));
    EXPECT_EQ(row.text("rival"), "close");
    EXPECT_EQ(row.number("ratio"), 6.0 / 5.0);
  }
  EXPECT_EQ(equal[1].number("flip"), 0.02);
}

TEST(ReuseSummary, HasSpeedupsAgainstTheSameSkipsAndTheModel) {
  CaseResult walk;
  const auto add = [&](const std::string& method, double ms) {
    for (const double frame : {0.0, 1.0}) {
      walk.results.push_back(row_of(method.c_str(), frame, "captures", 2.0 * frame));
      walk.times.push_back(row_of(method.c_str(), frame, "frame_ms", ms + (frame == 0.0 ? 1.0 : -1.0)));
    }
  };
  add(kNoCache, 12.0);
  for (const char* degrees : kThresholds_deg) add(reuse_at(degrees), 4.0 + 4.0 / std::stod(degrees));
  add(std::string(kNoCache) + " + skips", 6.0);
  add(reuse_at("1") + " + skips", 8.0);
  std::vector<Row> summary;
  add_summary(walk, 4000.0, summary);
  const auto of = [&](const std::string& method) { return rows_with(summary, "method", method).at(0); };
  EXPECT_NEAR(of(reuse_at("1")).number("speedup"), 1.5, 1e-12);
  EXPECT_NEAR(of(reuse_at("1") + " + skips").number("speedup"), 0.75, 1e-12);
  EXPECT_NEAR(of(kNoCache).number("seconds"), 24.0, 1e-12);
  EXPECT_NEAR(of(kNoCache).number("frame_ms_max"), 13.0, 1e-12);
  EXPECT_NEAR(of(kNoCache).number("captures_per_frame"), 1.0, 1e-12);
  const std::vector<Row> fits = rows_with(summary, "kind", kOfFit);
  ASSERT_EQ(fits.size(), 1u);  // with skips there are too few thresholds
  EXPECT_NEAR(fits[0].number("t0_ms"), 4.0, 1e-9);
  EXPECT_NEAR(fits[0].number("break_even_deg"), 0.5, 1e-9);
}

TEST(ReuseWalk, RowsAreTheSameEveryTimeAndPlainHasNoError) {
  const geometry::Scene scene = geometry::houses({.n_rows = 2, .n_in_row = 2, .n_each = 700, .seed = 1});
  const techniques::World world(scene, {}, true);
  Walk walk{.scene = "houses", .path = "sideways", .frames = {}, .cameras = {}, .size_px = {96, 64}};
  for (std::uint32_t k = 0; k < 6; ++k) {
    walk.frames.push_back(990 + 2 * k);
    walk.cameras.push_back(geometry::camera_at(scene.paths.at(1), int(990 + 2 * k)));
  }
  walk.error_every = 2, walk.n_steady = 4;
  std::vector<std::string> csv;
  for (int again = 0; again < 2; ++again) {
    PreparedMethod plain(make_method(kNoCache), world, {}), reuse(make_method("image_reuse:threshold=3"), world, {});
    const std::vector<PreparedMethod*> methods = {&plain, &reuse};
    int n_steps = 0;
    const CaseResult result = run_walk(walk, world, methods, 1, [&] { ++n_steps; });
    EXPECT_EQ(n_steps, 12);
    ASSERT_EQ(result.results.size(), 12u);
    ASSERT_EQ(result.times.size(), 12u);
    csv.push_back(csv_text(result.results));
    for (const Row& row : rows_with(result.results, "method", kNoCache)) {
      EXPECT_EQ(row.number("flip"), 0.0);
      EXPECT_EQ(row.number("pop"), 0.0);
    }
    const std::vector<Row> reused = rows_with(result.results, "method", "image_reuse:threshold=3");
    EXPECT_GT(reused[0].number("captures"), 0.0);
    EXPECT_EQ(reused[5].number("captures"), 0.0);  // the walk is short
    EXPECT_GT(reused[5].number("reused"), 0.0);
    EXPECT_GT(reused[3].number("displacement_px"), 0.0);
    EXPECT_NE(reused[3].find("flip"), nullptr);
    EXPECT_EQ(reused[2].find("flip"), nullptr);  // every second, from the second on
    EXPECT_NE(reused[3].find("pop"), nullptr);
  }
  EXPECT_EQ(csv[0], csv[1]);
}

}  // namespace
}  // namespace lode::experiments
