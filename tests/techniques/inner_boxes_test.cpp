/// Inner boxes: nothing is lost at any point of the screen, and what they cover is culled.

#include "techniques/inner_boxes/inner_boxes.h"

#include <gtest/gtest.h>

#include "techniques/inner_shapes.h"
#include "tests/techniques/continuous_pictures.h"

namespace lode::tests {
namespace {

using geometry::box;
using techniques::InnerBoxes;
using techniques::View;
using techniques::World;

/// Looks down −z from the origin; at distance d, 40 px are d world units.
View view_80px() {
  View view;
  view.camera.tan_half_fov_y = 1.0;
  view.camera.near = 0.5;
  view.size_px = {80, 80};
  return view;
}

/// After it was found to lose nothing.
TechniquePicture checked_picture(const World& world, Showing<InnerBoxes>& boxes, const View& view) {
  TechniquePicture picture = boxes.picture(view);
  EXPECT_EQ(difference_at_4x4(world, picture, view), "");
  return picture;
}

TechniquePicture checked_picture(const geometry::Scene& scene, const View& view) {
  const World world(scene, kRawUnlit, true, 1);
  Showing boxes(world, InnerBoxes{});
  return checked_picture(world, boxes, view);
}

/// The wall's own box fills it.
geometry::Scene wall_and_boxes() {
  geometry::Scene scene;
  geometry::add_instance(scene, box({-5, -5, -11}, {5, 5, -10}));
  geometry::add_instance(scene, box({-1, -1, -21}, {1, 1, -20}));     // behind it
  geometry::add_instance(scene, box({20, 0, -30}, {21, 1, -29}));     // beside it
  geometry::add_instance(scene, box({9, 0, -20.5}, {10, 1, -19.5}));  // peeps out
  return scene;
}

TEST(InnerBoxes, AWallHidesWhatIsBehindIt) {
  const TechniquePicture picture = checked_picture(wall_and_boxes(), view_80px());
  EXPECT_EQ(picture.drawn, (std::vector<bool>{true, false, true, true}));
  EXPECT_EQ(picture.count("culled"), 1u);
  EXPECT_EQ(picture.count("boxes"), 4u);  // each object's own
}

TEST(InnerBoxes, AnOpenWallAndOneInsideOutHideNothing) {
  geometry::Scene open = wall_and_boxes();
  open.meshes[0].indices.resize(open.meshes[0].indices.size() - 3);
  EXPECT_TRUE(checked_picture(open, view_80px()).drawn[1]);
  geometry::Scene inward = wall_and_boxes();
  std::vector<std::uint32_t>& indices = inward.meshes[0].indices;
  for (std::size_t c = 0; c < indices.size(); c += 3) std::swap(indices[c + 1], indices[c + 2]);
  EXPECT_TRUE(checked_picture(inward, view_80px()).drawn[1]);
}

TEST(InnerBoxes, AMirroredWallHidesAsWell) {
  geometry::Scene scene = wall_and_boxes();
  scene.instances[0].world_from_object = glm::scale(glm::dmat4(1.0), glm::dvec3(-1, 1, 1));
  EXPECT_FALSE(checked_picture(scene, view_80px()).drawn[1]);
}

// A shape is what its object shows from outside, however its meshes are placed in it.
TEST(InnerBoxes, AShapeOfAMirroredInstanceKeepsItsFronts) {
  geometry::Scene scene;
  geometry::add_instance(scene, box({-5, -5, -9}, {-4, 5, -8}));
  geometry::add_instance(scene, box({-5, -5, -11}, {5, 5, -10}), {}, glm::scale(glm::dmat4(1.0), glm::dvec3(-1, 1, 1)));
  scene.objects.push_back({"both", 0, 2});
  const World world(scene, kRawUnlit, true, 1);
  const techniques::Shape shape = world.shape(0);
  EXPECT_EQ(geometry::Solid(shape.positions, shape.indices).parts().size(), 2u);
}

TEST(InnerBoxes, AnEyeInTheWallSeesThroughIt) {
  View view = view_80px();
  view.camera.near = 0.1;
  view.camera.eye = {0, 0, -10.5};
  EXPECT_TRUE(checked_picture(wall_and_boxes(), view).drawn[1]);
  view.camera.eye = {0, 0, -9.95};  // the near plane is in it
  EXPECT_TRUE(checked_picture(wall_and_boxes(), view).drawn[1]);
}

TEST(InnerBoxes, NoPlaceIsLikeAny) {
  geometry::Scene scene = wall_and_boxes();
  scene.instances[0].world_from_object = glm::dmat4(0.0);
  EXPECT_TRUE(checked_picture(scene, view_80px()).drawn[1]);
  EXPECT_EQ(checked_picture(geometry::Scene{}, view_80px()).count("boxes"), 0u);
}

TEST(InnerBoxes, RandomScenesLoseNothingBetweenTheSamples) {
  std::uint64_t n_culled = 0;
  for (std::uint64_t seed = 0; seed < 2; ++seed) {
    for (const bool lattice : {false, true}) {
      const geometry::Scene scene = lattice ? lattice_scene(seed, 30) : random_scene(seed, 40);
      const World world(scene, kRawUnlit, true, 1);
      Showing boxes(world, InnerBoxes({.boxes = {.resolution = 8}}));
      for (std::uint64_t k = 0; k < 4; ++k) {
        const View view = lattice ? lattice_view(seed, k) : random_view(seed, k);
        n_culled += checked_picture(world, boxes, view).count("culled");
      }
    }
  }
  EXPECT_GT(n_culled, 10u);
}

}  // namespace
}  // namespace lode::tests
