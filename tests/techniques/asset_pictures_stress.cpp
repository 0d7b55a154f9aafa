/// Real models by both pipelines: every model file in the folder that the environment variable LODESTONE_ASSETS names,
/// at 512 × 512, seen whole and from so near that some of it is behind the eye. Every plane, byte for byte.

#include <gtest/gtest.h>

#include <algorithm>
#include <cstdlib>
#include <filesystem>

#include "geometry/model_file.h"
#include "techniques/scene_draws.h"
#include "tests/raster/fast_difference.h"

namespace lode::tests {
namespace {

using techniques::ColorSpace;
using techniques::Shading;

constexpr glm::ivec2 kSize_px{512, 512};

std::vector<std::string> model_files(const std::string& folder) {
  std::vector<std::string> paths;
  for (const auto& entry : std::filesystem::recursive_directory_iterator(folder)) {
    if (entry.is_regular_file() && geometry::is_model_file(entry.path().string()))
      paths.push_back(entry.path().string());
  }
  std::sort(paths.begin(), paths.end());
  return paths;
}

/// Seen whole, or from a third of the distance and another side.
geometry::Camera camera_of(const geometry::Bounds& bounds, bool near) {
  geometry::Camera camera = geometry::framing_camera(bounds, kSize_px);
  if (!near) return camera;
  const glm::dvec3 centre = bounds.centre();
  camera = geometry::orbited(camera, centre, 0.8);
  camera.eye = centre + (camera.eye - centre) / 3.0;
  return camera;
}

/// Empty if both pipelines draw the same.
std::string difference_of(const geometry::Scene& scene, bool near, ColorSpace space, raster::FrameMemory& memory) {
  techniques::SceneDraws scene_draws(scene, {Shading::material, space});
  scene_draws.cut_clusters();
  const std::vector<raster::Draw> draws = scene_draws.draws(camera_of(scene.bounds(), near), kSize_px);
  raster::Frame frame;
  frame.draws = draws;
  raster::Image fast = raster::make_image(kSize_px, techniques::color_format(space)), reference = fast;
  raster::RenderOptions options;
  options.memory = &memory;
  raster::render(frame, fast, options);
  options.pipeline = raster::Pipeline::reference;
  raster::render(frame, reference, options);
  return raster::test::first_difference(fast, reference);
}

TEST(AssetPictures, AreTheSameByBothPipelines) {
  const char* const folder = std::getenv("LODESTONE_ASSETS");
  if (!folder) GTEST_SKIP() << "LODESTONE_ASSETS names no folder of models";
  std::size_t n_pictures = 0;
  raster::FrameMemory memory;
  for (const std::string& path : model_files(folder)) {
    try {
      const geometry::Scene scene = geometry::read_model_file(path);
      for (const bool near : {false, true}) {
        const std::string difference = difference_of(scene, near, near ? ColorSpace::raw : ColorSpace::srgb, memory);
        EXPECT_EQ(difference, "") << path << (near ? ", near" : ", whole");
        ++n_pictures;
      }
    } catch (const std::exception& error) {
      ADD_FAILURE() << path << ": " << error.what();
    }
  }
  EXPECT_GT(n_pictures, 0u);
  std::printf("[  COUNT   ] pictures of models: %zu\n", n_pictures);
}

}  // namespace
}  // namespace lode::tests
