/// Which objects can be seen, by item buffers at 4 × 4 places in every pixel (what culling is judged by), against rays
/// of Embree through the same places: the pixels' centres of a picture four times as large. There every difference
/// between raster and rays is explained in exact arithmetic; and what only one of the two sees is a sliver.

#include <gtest/gtest.h>

#include <cstdio>

#include "experiments/harness/visible_samples.h"
#include "experiments/truth/check_view.h"
#include "geometry/procedural/interior.h"
#include "geometry/procedural/town.h"
#include "tests/raster/stress_count.h"

namespace lode::experiments::truth {
namespace {

constexpr glm::ivec2 kSize{160, 120}, kPlaces = 4 * kSize;

/// [w·h] the object at each place, or none.
std::vector<std::uint32_t> objects_by_rays(const techniques::World& world, const geometry::Camera& camera) {
  const SolidDraws solid = solid_draws(world.scene(), world.draws().draws(camera, kPlaces));
  const CameraRays rays(solid.traced(), camera, kPlaces, world.bounds());
  std::vector<std::uint32_t> objects;
  for (const raster::Ids& ids : trace_ids(rays, kPlaces, 0)) {
    objects.push_back(ids.draw == raster::kNoId ? raster::kNoId : world.object_of(ids.draw));
  }
  return objects;
}

/// Whether the place and all eight around it show the same: a thing that is more than two places wide has such.
bool is_inner(const std::vector<std::uint32_t>& objects, int x, int y) {
  if (x < 1 || y < 1 || x + 1 >= kPlaces.x || y + 1 >= kPlaces.y) return false;
  const auto at = [&](int i, int k) { return objects[std::size_t(k) * kPlaces.x + std::size_t(i)]; };
  for (int dy = -1; dy <= 1; ++dy) {
    for (int dx = -1; dx <= 1; ++dx) {
      if (at(x + dx, y + dy) != at(x, y)) return false;
    }
  }
  return true;
}

struct Sets {
  std::uint64_t both = 0, rays_only = 0, buffers_only = 0, places_of_one = 0;
};

void compare(const geometry::Scene& scene, int n_frames, Sets& sets) {
  const techniques::World world(scene, {}, true);
  for (const geometry::CameraPath& path : scene.paths) {
    for (int k = 0; k < n_frames; ++k) {
      const int frame = (2 * k + 1) * path.n_frames / (2 * n_frames);
      const std::string where = scene.name + ", " + path.name + " " + std::to_string(frame);
      const geometry::Camera camera = geometry::camera_at(path, frame);
      const ViewCheck view = check_view(world.draws(), camera, world.bounds(), kPlaces, {});
      EXPECT_EQ(view.picture.of(Verdict::unexplained), 0u) << where;

      const VisibleSamples buffers = visible_samples(world, {.camera = camera, .size_px = kSize}, 1, 0, {});
      const std::vector<std::uint32_t> objects = objects_by_rays(world, camera);
      std::vector<std::uint32_t> by_rays(world.objects().size(), 0), inner(world.objects().size(), 0);
      for (int y = 0; y < kPlaces.y; ++y) {
        for (int x = 0; x < kPlaces.x; ++x) {
          const std::uint32_t object = objects[std::size_t(y) * kPlaces.x + std::size_t(x)];
          if (object == raster::kNoId) continue;
          ++by_rays[object];
          inner[object] += is_inner(objects, x, y) ? 1 : 0;
        }
      }
      for (techniques::ObjectId id = 0; id < by_rays.size(); ++id) {
        const std::uint32_t rays = by_rays[id], samples = buffers.grid[id];
        if (rays > 0 && samples > 0) ++sets.both;
        if ((rays > 0) == (samples > 0)) continue;
        ++(rays > 0 ? sets.rays_only : sets.buffers_only);
        sets.places_of_one += rays + samples;
        EXPECT_EQ(inner[id], 0u) << where << ": only rays see " << world.objects()[id].name;
        EXPECT_LE(samples, 8u) << where << ": no ray sees " << world.objects()[id].name;
      }
    }
  }
}

TEST(VisibleSetStress, ItemBuffersAndRaysSeeTheSameObjects) {
  const auto n_frames = int(raster::test::stress_count("frames a walk", 1, 50));
  Sets sets;
  compare(geometry::town(1), n_frames, sets);
  compare(geometry::interior(1), n_frames, sets);
  std::printf(
      "[  COUNT   ] objects seen by both: %llu, by rays only: %llu, by item buffers only: %llu, at %llu places\n",
      static_cast<unsigned long long>(sets.both), static_cast<unsigned long long>(sets.rays_only),
      static_cast<unsigned long long>(sets.buffers_only), static_cast<unsigned long long>(sets.places_of_one));
  EXPECT_GT(sets.both, 0u);
}

}  // namespace
}  // namespace lode::experiments::truth
