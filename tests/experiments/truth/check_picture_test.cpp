/// The check passes what is right and fails what is wrong: pictures falsified by one id, one pixel, one place of a
/// float.

#include "experiments/truth/check_picture.h"

#include <algorithm>
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <cmath>

#include "experiments/truth/triangle_table.h"
#include "tests/experiments/truth/small_view.h"

namespace lode::experiments::truth {
namespace {

using testing::HasSubstr;

constexpr raster::Ids kNothing{raster::kNoId, raster::kNoId};
const geometry::Camera kCamera = camera_at({1.1, 1.7, 3.9}, {0.0, 0.0, 0.0}, 0.1);

/// Pixels whose four neighbours show the same triangle, and where both sides agree.
std::vector<std::size_t> calm_pixels(const SmallView& view) {
  std::vector<std::size_t> calm;
  for (int y = 1; y + 1 < view.size_px.y; ++y) {
    for (int x = 1; x + 1 < view.size_px.x; ++x) {
      const raster::Ids here = view.image.ids[view.at(x, y)];
      const bool same = here == view.image.ids[view.at(x - 1, y)] && here == view.image.ids[view.at(x + 1, y)] &&
                        here == view.image.ids[view.at(x, y - 1)] && here == view.image.ids[view.at(x, y + 1)] &&
                        here == view.ray_ids[view.at(x, y)];
      if (same) calm.push_back(view.at(x, y));
    }
  }
  return calm;
}

TEST(CheckPicture, ExplainsEveryPixelOfARightPicture) {
  const SmallView view(ball_in_box(), kCamera, {128, 96});
  const PictureCheck check = view.check();
  EXPECT_EQ(check.of(Verdict::unexplained), 0u);
  EXPECT_EQ(check.of(Verdict::same) + check.different(), 128u * 96u);
  EXPECT_TRUE(check.examples.empty());
}

TEST(CheckPicture, IsTheSameForAnyNumberOfThreads) {
  SmallView view(ball_in_box(), kCamera, {64, 64});
  for (std::size_t i = 0; i < view.image.ids.size(); i += 7) view.image.ids[i] = kNothing;
  const PictureCheck one = check_picture(view.pair(), 1), three = check_picture(view.pair(), 3);
  EXPECT_EQ(one.verdicts, three.verdicts);
  ASSERT_EQ(one.examples.size(), three.examples.size());
  for (std::size_t i = 0; i < one.examples.size(); ++i) EXPECT_EQ(one.examples[i].why, three.examples[i].why);
}

TEST(CheckPicture, AnotherIdIsUnexplained) {
  SmallView view(ball_in_box(), kCamera, {64, 64});
  const std::vector<std::size_t> calm = calm_pixels(view);
  ASSERT_GT(calm.size(), 100u);
  for (const std::size_t i : calm) view.image.ids[i].primitive ^= 1;  // the neighbour, with the right one's depth
  EXPECT_EQ(view.check().of(Verdict::unexplained), calm.size());
}

TEST(CheckPicture, AnotherIdIsUnexplainedEvenIfTheRaysSayTheSame) {
  SmallView view(ball_in_box(), kCamera, {64, 64});
  const std::vector<std::size_t> calm = calm_pixels(view);
  for (const std::size_t i : calm) {
    view.image.ids[i].primitive ^= 1;
    view.ray_ids[i] = view.image.ids[i];
  }
  EXPECT_EQ(view.check().of(Verdict::unexplained), calm.size());
}

TEST(CheckPicture, AHoleIsUnexplained) {
  SmallView view(ball_in_box(), kCamera, {64, 64});
  const std::vector<std::size_t> calm = calm_pixels(view);
  std::uint64_t n_holes = 0;
  for (const std::size_t i : calm) {
    if (view.image.ids[i] == kNothing) continue;
    view.image.ids[i] = kNothing;
    view.image.depth[i] = 0.0f;
    ++n_holes;
  }
  const PictureCheck check = view.check();
  EXPECT_EQ(check.of(Verdict::unexplained), n_holes);
  EXPECT_THAT(check.examples.front().why, HasSubstr("covers it in every placement"));
}

TEST(CheckPicture, ATriangleThatDoesNotExistIsUnexplained) {
  SmallView view(ball_in_box(), kCamera, {64, 64});
  const std::size_t i = calm_pixels(view).front();
  view.image.ids[i] = {7, 0};
  EXPECT_EQ(view.check().of(Verdict::unexplained), 1u);
  view.image.ids[i] = {0, 1'000'000};
  EXPECT_EQ(view.check().of(Verdict::unexplained), 1u);
}

/// The picture moved by a pixel is wrong wherever it is not flat.
TEST(CheckPicture, APictureMovedByOnePixelIsUnexplained) {
  SmallView view(ball_in_box(), kCamera, {64, 64});
  const SmallView right(ball_in_box(), kCamera, {64, 64});
  std::uint64_t n_changed = 0;
  for (int y = 0; y < 64; ++y) {
    for (int x = 1; x < 64; ++x) {
      view.image.ids[view.at(x, y)] = right.image.ids[view.at(x - 1, y)];
      view.image.depth[view.at(x, y)] = right.image.depth[view.at(x - 1, y)];
      n_changed += view.image.ids[view.at(x, y)] != right.image.ids[view.at(x, y)];
    }
  }
  EXPECT_GE(view.check().of(Verdict::unexplained), n_changed * 9 / 10);
}

/// Moved by 1/100 px, five times the snap, it shows at the edges alone, and in depth.
TEST(CheckPicture, APictureMovedByAHundredthOfAPixelIsUnexplained) {
  SmallView view(ball_in_box(), kCamera, {128, 128});
  std::vector<raster::Draw> moved = view.solid.draws;
  for (raster::Draw& draw : moved) {
    glm::dmat4& m = std::get<raster::ObjectVertices>(draw.vertices).clip_from_object;
    for (int c = 0; c < 4; ++c) m[c][0] += 0.01 / 64.0 * m[c][3];  // x + 0.01 px · w
  }
  static_cast<void>(raster::render({.draws = moved, .viewport = {}, .scissor = {}}, view.image, {.threads = 1}));
  EXPECT_GT(view.check().of(Verdict::unexplained), 1000u);
}

/// At each calm pixel the ends of the interval pass, and the floats beyond them do not.
TEST(CheckPicture, ADepthOnePlaceBeyondTheIntervalIsUnexplained) {
  SmallView view(ball_in_box(), kCamera, {64, 64});
  const auto right = view.image.depth;
  const TriangleTable table(view.solid.draws, view.size_px);
  for (const bool beyond : {false, true}) {
    std::uint64_t n_changed = 0;
    for (const std::size_t i : calm_pixels(view)) {
      const std::optional<SourceTriangle> source = table.find(view.image.ids[i]);
      if (!source) continue;
      const glm::dvec2 sample(double(i % 64) + 0.5, double(i / 64) + 0.5);
      const DepthInterval depth = judge_depth(table.prepared(*source), sample);
      const float end = float(n_changed % 2 ? depth.high : depth.low);
      view.image.depth[i] = beyond ? std::nextafter(end, n_changed % 2 ? 2.0f : 0.0f) : end;
      ++n_changed;
    }
    EXPECT_EQ(view.check().of(Verdict::unexplained), beyond ? n_changed : 0u);
    view.image.depth = right;
  }
}

/// The box's far side at a pixel of its near side, with the far side's own depth: possible but for what hides it.
TEST(CheckPicture, AHiddenSurfaceIsUnexplained) {
  SmallView view(ball_in_box(), kCamera, {64, 64});
  const TriangleTable table(view.solid.draws, view.size_px);
  std::uint64_t n_changed = 0;
  for (const std::size_t i : calm_pixels(view)) {
    const glm::dvec2 sample(double(i % 64) + 0.5, double(i / 64) + 0.5);
    for (std::uint32_t k = 0; k < table.n_triangles(1); ++k) {
      const Judgement j = judge(table.prepared(table.source(1, k)), sample);
      if (j.coverage != Coverage::in || !(float(j.depth.high) < view.image.depth[i])) continue;
      view.image.ids[i] = {1, k};
      view.image.depth[i] = float(0.5 * (j.depth.low + j.depth.high));
      ++n_changed;
      break;
    }
  }
  EXPECT_GT(n_changed, 500u);
  const PictureCheck check = view.check();
  EXPECT_EQ(check.of(Verdict::unexplained), n_changed);
  EXPECT_THAT(check.examples.front().why, HasSubstr("nearer than"));
}

TEST(CheckPicture, WrongRaysAreTheRaysFault) {
  SmallView view(ball_in_box(), kCamera, {64, 64});
  const PictureCheck before = view.check();
  std::uint64_t n_changed = 0;
  for (const std::size_t i : calm_pixels(view)) {
    if (view.ray_ids[i] == kNothing) continue;
    view.ray_ids[i] = kNothing;
    ++n_changed;
  }
  const PictureCheck check = view.check();
  EXPECT_EQ(check.of(Verdict::embree), before.of(Verdict::embree) + n_changed);
  EXPECT_EQ(check.of(Verdict::unexplained), 0u);
}

/// Two squares in one place: the rasterizer shows the first, the rays either; that is a tie.
TEST(CheckPicture, CoincidentTrianglesTie) {
  geometry::Scene scene;
  const geometry::Mesh square = geometry::terrain(2.0, 1, 0.0, 0);
  geometry::add_instance(scene, square);
  geometry::add_instance(scene, square);
  SmallView view(std::move(scene), camera_at({0.3, 3.0, 0.4}, {0.0, 0.0, 0.0}, 0.1), {64, 64});
  std::uint64_t n_second = 0;
  view.ray_ids.assign(view.image.ids.begin(), view.image.ids.end());  // whichever they saw
  for (const std::size_t i : calm_pixels(view)) {
    if (view.image.ids[i] == kNothing) continue;
    EXPECT_EQ(view.image.ids[i].draw, 0u);
    view.ray_ids[i].draw = 1;
    ++n_second;
  }
  ASSERT_GT(n_second, 100u);
  const PictureCheck check = view.check();
  EXPECT_EQ(check.of(Verdict::unexplained), 0u);
  EXPECT_GE(check.of(Verdict::depth_tie), n_second);

  // The other way round it is not: at equal depth the lower ids win.
  std::swap_ranges(view.image.ids.begin(), view.image.ids.end(), view.ray_ids.begin());
  EXPECT_GE(view.check().of(Verdict::unexplained), n_second);
}

TEST(CheckPicture, NamesTheFirstTenInReadingOrder) {
  SmallView view(ball_in_box(), kCamera, {64, 64});
  const std::vector<std::size_t> calm = calm_pixels(view);
  for (std::size_t k = 0; k < 20; ++k) view.image.ids[calm[k]] = {9, 9};
  const PictureCheck check = view.check();
  ASSERT_EQ(check.examples.size(), kMaxExamples);
  for (std::size_t k = 0; k < kMaxExamples; ++k) {
    EXPECT_EQ(view.at(check.examples[k].px.x, check.examples[k].px.y), calm[k]);
  }
}

}  // namespace
}  // namespace lode::experiments::truth
