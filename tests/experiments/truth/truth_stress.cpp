/// The rasterizer against Embree with the exact arbiter, over random scenes and cameras: nothing is left unexplained.

#include <gtest/gtest.h>

#include <array>
#include <cstdio>

#include "experiments/truth/check_view.h"
#include "tests/experiments/truth/random_view.h"
#include "tests/experiments/truth/small_view.h"
#include "tests/raster/counter_random.h"

namespace lode::experiments::truth {
namespace {

constexpr glm::ivec2 kSize{128, 128};

TEST(TruthStress, EveryDifferenceIsExplained) {
  const std::uint64_t n_rays = tests::stress_count(10'000'000);
  std::printf("[  COUNT   ] rays over random scenes: %llu\n", static_cast<unsigned long long>(n_rays));
  std::array<std::uint64_t, kVerdicts> pixels{};
  double edge_px = 0.0;
  std::uint64_t n_scenes = 0;
  for (; n_scenes * kSize.x * kSize.y < n_rays; ++n_scenes) {
    Random random(4, 1, n_scenes);
    const geometry::Scene scene = random_scene(random);
    const geometry::Bounds bounds = scene.bounds();
    std::string name = std::to_string(n_scenes) + ":" + scene.name;
    const geometry::Camera camera = random_camera(random, bounds, kSize, name);
    const ViewCheck view = check_view(techniques::SceneDraws(scene, {}), camera, bounds, kSize, {});
    for (std::size_t v = 0; v < kVerdicts; ++v) pixels[v] += view.picture.pixels[v];
    edge_px += view.edges.length_px;
    for (const Unexplained& u : view.picture.examples) {
      ADD_FAILURE() << name << ", pixel " << u.px.x << "," << u.px.y << ": raster " << u.raster.draw << " "
                    << u.raster.primitive << ", rays " << u.rays.draw << " " << u.rays.primitive << ": " << u.why;
    }
    ASSERT_EQ(view.picture.of(Verdict::unexplained), 0u) << name;
  }
  for (std::size_t v = 0; v < kVerdicts; ++v) {
    std::printf("[  COUNT   ] %s: %llu\n", verdict_name(Verdict(v)), static_cast<unsigned long long>(pixels[v]));
  }
  std::printf("[  COUNT   ] scenes: %llu, visible edges: %.0f px, edge bound: %.0f\n",
              static_cast<unsigned long long>(n_scenes), edge_px, kEdgeBand_px * edge_px);
  EXPECT_LE(double(pixels[std::size_t(Verdict::edge)]), kEdgeBand_px * edge_px);
}

TEST(TruthStress, AFarAwayBallShowsNoBackgroundFromInside) {
  geometry::Material material;
  material.double_sided = true;
  const glm::dvec3 centre(148376.0, 1234.0, -223423.0);
  for (const glm::dvec3& to : {glm::dvec3(0.3, 0.2, -1.0), {1.0, 0.0, 0.0}, {0.01, 1.0, 0.02}, {-0.5, -0.7, 0.6}}) {
    geometry::Scene scene = geometry::scene_of(geometry::sphere(centre, 2.0, 200, 100), material);
    const SmallView view(std::move(scene), camera_at(centre, centre + to, 0.001), {512, 512});
    std::uint64_t n_raster = 0, n_rays = 0;
    for (std::size_t i = 0; i < view.ray_ids.size(); ++i) {
      n_raster += view.image.ids[i].draw == raster::kNoId;
      n_rays += view.ray_ids[i].draw == raster::kNoId;
    }
    EXPECT_EQ(n_raster, 0u);
    EXPECT_EQ(n_rays, 0u);
    EXPECT_EQ(view.check().of(Verdict::unexplained), 0u);
  }
}

}  // namespace
}  // namespace lode::experiments::truth
