// Pictures of models and of what stands for them.
#include "experiments/convex_approximation/model_pictures.h"

#include <gtest/gtest.h>

#include <filesystem>

#include "geometry/image_file/read_picture.h"
#include "geometry/procedural.h"
#include "tests/geometry/temporary_folder.h"

namespace lode::experiments {
namespace {

/// In the middle of the panel, 0 the left one.
glm::ivec4 middle_of_panel(const geometry::Picture& picture, int panel, int n_panels) {
  const int x = (2 * panel + 1) * picture.size_px.x / (2 * n_panels), y = picture.size_px.y / 2;
  return picture.texels[std::size_t(y) * std::size_t(picture.size_px.x) + std::size_t(x)];
}

techniques::Shape cube() {
  const geometry::Mesh mesh = geometry::box({-1, -1, -1}, {1, 1, 1});
  return {mesh.positions, mesh.indices};
}

// A cube is its own hull: grey as a model, in the first colour, a blue, as a hull. A level without hulls is empty.
TEST(HullsPicture, ShowsTheModelAndEachLevelSideBySide) {
  const tests::TemporaryFolder folder;
  techniques::convex_culling::ConvexApproximation approximation;
  approximation.levels.resize(2);
  const techniques::Shape model = cube();
  approximation.levels[0].hulls = {model.positions};
  write_hulls_picture(folder.path("cube.png"), model, approximation, {.threads = 1});
  const geometry::Picture picture = geometry::read_picture(folder.path("cube.png"));
  const glm::ivec4 grey = middle_of_panel(picture, 0, 3), blue = middle_of_panel(picture, 1, 3);
  EXPECT_EQ(grey.a, 255);
  EXPECT_EQ(grey.r, grey.b);
  EXPECT_EQ(blue.a, 255);
  EXPECT_GT(blue.b, blue.r + 50);
  EXPECT_EQ(middle_of_panel(picture, 2, 3).a, 0);
}

TEST(BoxesPicture, ShowsTheModelAndItsInnerBoxes) {
  const tests::TemporaryFolder folder;
  write_boxes_picture(folder.path("cube.png"), cube(), {.threads = 1});
  EXPECT_GT(middle_of_panel(geometry::read_picture(folder.path("cube.png")), 1, 2).b, 100);
  techniques::Shape nothing;
  write_boxes_picture(folder.path("nothing.png"), nothing, {.threads = 1});
  EXPECT_FALSE(std::filesystem::exists(folder.path("nothing.png")));
}

}  // namespace
}  // namespace lode::experiments
