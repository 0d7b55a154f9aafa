// True pictures: the mean of a pixel's samples, kept whole, made again when damaged.
#include "experiments/harness/true_picture.h"

#include <gtest/gtest.h>

#include <filesystem>
#include <fstream>

#include "experiments/harness/scene_hash.h"
#include "geometry/procedural.h"
#include "tests/geometry/temporary_folder.h"

namespace lode::experiments {
namespace {

constexpr glm::ivec2 kSize{16, 12};

geometry::Scene ball() {
  geometry::Scene scene;
  geometry::add_instance(scene, geometry::sphere({0.0, 0.0, -3.0}, 1.0, 24, 12));
  return scene;
}

techniques::View view() {
  techniques::View view;
  view.size_px = kSize;
  geometry::look_at(view.camera, {0, 0, 0}, {0, 0, -1});
  return view;
}

TEST(TruePicture, IsTheMeanOfSixtyFourSamples) {
  const geometry::Scene scene = ball();
  const techniques::World world(scene, {}, true, 1);
  const TruePicture picture = true_picture(world, look_hash_of(scene), view(), {.threads = 1}, KeptResults(""));
  std::vector<glm::dvec4> sum(picture.size());
  const auto draws = world.draws().draws(view().camera, kSize);
  raster::Image image = raster::make_image(kSize, raster::ColorFormat::rgba32f, {.depth = false, .ids = false});
  for (int k = 0; k < 64; ++k) {
    const glm::ivec2 samples[] = {{16 + 32 * (k % 8), 16 + 32 * (k / 8)}};
    static_cast<void>(raster::render(
        {.draws = draws, .clear = glm::vec4(0.0f), .viewport = {}, .scissor = {}, .samples_fx8 = samples}, image));
    for (std::size_t i = 0; i < sum.size(); ++i) sum[i] += glm::dvec4(image.rgba32f[i]);
  }
  int n_mixed = 0;
  for (std::size_t i = 0; i < sum.size(); ++i) {
    EXPECT_EQ(picture[i], glm::vec4(sum[i] / 64.0)) << i;
    n_mixed += picture[i].a > 0.0f && picture[i].a < 1.0f;
  }
  EXPECT_GT(n_mixed, 10);  // the ball's edge
}

TEST(TruePicture, IsKeptAndMadeAgainWhenDamaged) {
  const tests::TemporaryFolder folder;
  const KeptResults kept(folder.path("kept"));
  geometry::Scene scene = ball();
  const techniques::World world(scene, {}, true, 1);
  const std::string look = look_hash_of(scene);
  const TruePicture made = true_picture(world, look, view(), {.threads = 1}, kept);
  const auto entry = std::filesystem::directory_iterator(folder.path("kept"))->path();
  const auto time = std::filesystem::last_write_time(entry);
  EXPECT_EQ(true_picture(world, look, view(), {.threads = 1}, kept), made);
  EXPECT_EQ(std::filesystem::last_write_time(entry), time);
  std::filesystem::resize_file(entry, std::filesystem::file_size(entry) - 16);
  EXPECT_EQ(true_picture(world, look, view(), {.threads = 1}, kept), made);
  EXPECT_EQ(std::distance(std::filesystem::directory_iterator(folder.path("kept")), {}), 1);
}

TEST(LookHash, ChangesWithColoursThatDoNotChangeWhoIsSeen) {
  geometry::Scene scene = ball();
  const std::string seen = hash_of(scene), look = look_hash_of(scene);
  scene.meshes[0].normals[3].x += 0.25f;
  EXPECT_EQ(hash_of(scene), seen);
  EXPECT_NE(look_hash_of(scene), look);
  scene.meshes[0].positions[3].x += 0.25f;
  EXPECT_NE(hash_of(scene), seen);
}

}  // namespace
}  // namespace lode::experiments
