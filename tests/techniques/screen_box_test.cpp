/// The bound on where a box can be on the screen, and how near.

#include "techniques/screen_box.h"

#include <gmock/gmock.h>

#include "tests/techniques/technique_pictures.h"

namespace lode::tests {
namespace {

using geometry::Bounds;
using techniques::screen_box;

/// Looks down −z from the origin, 90° high and wide, depth 1/d: at distance d, 50 px are d world units.
techniques::View view_100px() {
  techniques::View view;
  view.camera.tan_half_fov_y = 1.0;
  view.camera.near = 1.0;
  view.size_px = {100, 100};
  return view;
}

std::optional<techniques::ScreenBox> box_in(const techniques::View& view, const glm::dvec3& low,
                                            const glm::dvec3& high) {
  Bounds box;
  box.add(low);
  box.add(high);
  return screen_box(geometry::clip_from_world(view.camera, view.size_px), view.size_px, box);
}

TEST(ScreenBox, IsTheCornersRectangleOnePixelWider) {
  // At d = 10 a unit is 5 px; the front face [−2, 2]² is [40, 60]² px, wider [39, 61]: centres of pixels 39 … 60.
  const auto box = box_in(view_100px(), {-2, -2, -30}, {2, 2, -10});
  ASSERT_TRUE(box);
  EXPECT_EQ(box->first_px, glm::ivec2(39, 39));
  EXPECT_EQ(box->last_px, glm::ivec2(60, 60));
  EXPECT_GE(box->nearest, 0.1f);
  EXPECT_LE(box->nearest, std::nextafter(0.1f, 1.0f));
}

TEST(ScreenBox, IsCutToThePicture) {
  const auto box = box_in(view_100px(), {-2, -30, -10}, {30, 30, -10});
  ASSERT_TRUE(box);
  EXPECT_EQ(box->first_px, glm::ivec2(39, 0));
  EXPECT_EQ(box->last_px, glm::ivec2(99, 99));
  const auto beside = box_in(view_100px(), {20, 0, -10}, {30, 1, -10});
  ASSERT_TRUE(beside);
  EXPECT_TRUE(beside->empty());
}

TEST(ScreenBox, CannotTellAtTheNearPlaneAndBehindTheEye) {
  EXPECT_FALSE(box_in(view_100px(), {-1, -1, -5}, {1, 1, -1}));
  EXPECT_FALSE(box_in(view_100px(), {-1, -1, -5}, {1, 1, 5}));
  EXPECT_FALSE(box_in(view_100px(), {-1, -1, 4}, {1, 1, 5}));
  EXPECT_TRUE(box_in(view_100px(), {-1, -1, -5}, {1, 1, -1.001}));
}

TEST(ScreenBox, CannotTellOfWhatIsNotFiniteOrBeyondTheGuardBand) {
  const double infinity = std::numeric_limits<double>::infinity();
  EXPECT_FALSE(box_in(view_100px(), {-infinity, -1, -5}, {1, 1, -4}));
  EXPECT_FALSE(box_in(view_100px(), {-1, -1, -infinity}, {1, 1, -4}));
  EXPECT_FALSE(box_in(view_100px(), {-1e6, -1, -5}, {1, 1, -4}));
}

TEST(ScreenBox, OfNothingIsHiddenAnywhere) {
  const auto box = screen_box(glm::dmat4(1.0), {100, 100}, Bounds{});
  ASSERT_TRUE(box);
  EXPECT_TRUE(box->empty());
}

TEST(ScreenBox, HoldsEveryFragmentOfWhatIsInTheBox) {
  int n_boxes = 0;
  for (std::uint64_t k = 0; k < 60; ++k) {
    const geometry::Scene scene = random_scene(7000 + k, 1);
    const techniques::World world(scene, kRawUnlit, false);
    techniques::View view = random_view(7, k);
    const auto box =
        screen_box(geometry::clip_from_world(view.camera, view.size_px), view.size_px, world.objects()[0].bounds);
    if (!box) continue;
    ++n_boxes;
    const raster::Image image = Showing(world, techniques::Plain{}).picture(view).image;
    for (int i = 0; i < view.size_px.x * view.size_px.y; ++i) {
      if (image.ids[std::size_t(i)].draw == raster::kNoId) continue;
      const glm::ivec2 p(i % view.size_px.x, i / view.size_px.x);
      EXPECT_TRUE(p.x >= box->first_px.x && p.x <= box->last_px.x && p.y >= box->first_px.y && p.y <= box->last_px.y);
      EXPECT_LE(image.depth[std::size_t(i)], box->nearest);
    }
  }
  EXPECT_GT(n_boxes, 30);
}

}  // namespace
}  // namespace lode::tests
