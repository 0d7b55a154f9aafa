#pragma once
/// A view of a small scene by raster and by rays, for tests that look at single pixels or falsify them.

#include <memory>
#include <vector>

#include "experiments/truth/check_picture.h"
#include "experiments/truth/solid_draws.h"
#include "geometry/procedural.h"
#include "raster/render.h"
#include "techniques/scene_draws.h"

namespace lode::experiments::truth {

struct SmallView {
  geometry::Scene scene;
  geometry::Camera camera;
  glm::ivec2 size_px{64, 64};
  std::unique_ptr<techniques::SceneDraws> scene_draws;
  SolidDraws solid;
  std::unique_ptr<CameraRays> rays;
  raster::Image image;
  std::vector<raster::Ids> ray_ids;

  SmallView(geometry::Scene s, const geometry::Camera& c, glm::ivec2 size)
      : scene(std::move(s)), camera(c), size_px(size) {
    scene_draws = std::make_unique<techniques::SceneDraws>(scene, techniques::SceneDraws::Params{});
    solid = solid_draws(scene, scene_draws->draws(camera, size_px));
    image = raster::make_image(size_px, raster::ColorFormat::rgba8, {.color = false, .depth = true, .ids = true});
    static_cast<void>(raster::render({.draws = solid.draws, .viewport = {}, .scissor = {}}, image, {.threads = 1}));
    rays = std::make_unique<CameraRays>(solid.traced(), camera, size_px, scene.bounds());
    ray_ids = trace_ids(*rays, size_px, 1);
  }

  [[nodiscard]] std::size_t at(int x, int y) const { return std::size_t(y) * std::size_t(size_px.x) + std::size_t(x); }
  [[nodiscard]] PicturePair pair() const { return {solid.draws, size_px, image.ids, image.depth, ray_ids}; }
  [[nodiscard]] PictureCheck check() const { return check_picture(pair(), 1); }
};

[[nodiscard]] inline geometry::Camera camera_at(const glm::dvec3& eye, const glm::dvec3& target, double near) {
  geometry::Camera camera;
  geometry::look_at(camera, eye, target);
  camera.near = near;
  return camera;
}

/// A ball before a larger, two-sided box: back faces behind front faces, and edges of all kinds.
[[nodiscard]] inline geometry::Scene ball_in_box() {
  geometry::Scene scene;
  geometry::add_instance(scene, geometry::sphere({0.1, 0.05, 0.0}, 0.9, 24, 12));
  geometry::Material two_sided;
  two_sided.double_sided = true;
  geometry::add_instance(scene, geometry::box(glm::dvec3(-1.0), glm::dvec3(1.0)), two_sided);
  return scene;
}

}  // namespace lode::experiments::truth
