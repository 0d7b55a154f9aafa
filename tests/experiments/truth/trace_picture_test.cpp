/// Pictures by rays against the rasterizer's: away from edges they are the same to rounding.

#include "experiments/truth/trace_picture.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <glm/gtc/matrix_transform.hpp>

#include "experiments/sample_positions.h"
#include "experiments/scenes/builtin_scene.h"
#include "experiments/truth/surface_point.h"
#include "tests/experiments/truth/small_view.h"

namespace lode::experiments::truth {
namespace {

struct BothPictures {
  raster::Image raster, rays;
};

BothPictures both(const geometry::Scene& scene, const geometry::Camera& camera, glm::ivec2 size_px,
                  techniques::ColorSpace space, int n_samples = 1) {
  const techniques::SceneDraws scene_draws(scene, {.color_space = space});
  const std::vector<glm::ivec2> samples = sample_positions_fx8(n_samples);
  const bool single = n_samples == 1;
  const PictureRequest request{.size_px = size_px,
                               .samples_fx8 = samples,
                               .clear = glm::vec4(0.25f, 0.5f, 0.75f, 1.0f),
                               .format = techniques::color_format(space),
                               .planes = {.color = true, .depth = single, .ids = single}};
  const std::vector<raster::Draw> draws = scene_draws.draws(camera, size_px);
  BothPictures pictures{raster::make_image(size_px, request.format, request.planes), {}};
  static_cast<void>(
      raster::render({.draws = draws, .clear = request.clear, .viewport = {}, .scissor = {}, .samples_fx8 = samples},
                     pictures.raster));
  pictures.rays = trace_picture(scene_draws, camera, scene.bounds(), request, 2);
  return pictures;
}

float difference(const glm::vec4& a, const glm::vec4& b) {
  float largest = 0.0f;
  for (int c = 0; c < 4; ++c) largest = std::max(largest, std::abs(a[c] - b[c]));
  return largest;
}

/// Part of the pixels whose colours differ by more than the tolerance.
double part_differing(const BothPictures& p, float tolerance) {
  std::size_t n = 0;
  const std::size_t n_pixels = std::max(p.raster.rgba32f.size(), p.raster.rgba8.size());
  for (std::size_t i = 0; i < n_pixels; ++i) {
    n += p.raster.rgba32f.empty() ? difference(p.raster.rgba8[i], p.rays.rgba8[i]) > tolerance
                                  : difference(p.raster.rgba32f[i], p.rays.rgba32f[i]) > tolerance;
  }
  return double(n) / double(n_pixels);
}

/// Snapping moves a triangle by up to 1/512 px, and with it colours by a few thousandths of what they change by from
/// pixel to pixel; textures of few, large checks change at their borders.
TEST(TracePicture, EqualsTheRasterizersAwayFromEdges) {
  for (const char* name : {"spheres:side=4,segments=12", "alpha", "ground", "terrain:cells=8"}) {
    const geometry::Scene scene = make_builtin_scene(name);
    const geometry::Camera camera = geometry::framing_camera(scene.bounds(), {96, 64});
    const BothPictures p = both(scene, camera, {96, 64}, techniques::ColorSpace::srgb);
    EXPECT_LT(part_differing(p, 0.01f), 0.005) << name;
    std::size_t n_ids = 0;
    for (std::size_t i = 0; i < p.raster.ids.size(); ++i) {
      n_ids += p.raster.ids[i] != p.rays.ids[i];
      if (p.raster.ids[i] == p.rays.ids[i]) {
        EXPECT_NEAR(p.raster.depth[i], p.rays.depth[i], 1e-3f);
      }
    }
    EXPECT_LT(n_ids, 96u * 64u / 200u) << name;
  }
}

TEST(TracePicture, EqualsTheRasterizersInRawColours) {
  const geometry::Scene scene = make_builtin_scene("alpha");
  const geometry::Camera camera = geometry::framing_camera(scene.bounds(), {96, 64});
  EXPECT_LT(part_differing(both(scene, camera, {96, 64}, techniques::ColorSpace::raw), 2.0f), 0.005);
}

TEST(TracePicture, AveragesSamplesAsTheRasterizerDoes) {
  const geometry::Scene scene = make_builtin_scene("spheres:side=3,segments=12");
  const geometry::Camera camera = geometry::framing_camera(scene.bounds(), {48, 32});
  for (const techniques::ColorSpace space : {techniques::ColorSpace::srgb, techniques::ColorSpace::raw}) {
    const BothPictures p = both(scene, camera, {48, 32}, space, 16);
    const float sixteenth = space == techniques::ColorSpace::raw ? 16.0f : 1.0f / 16.0f;
    EXPECT_LT(part_differing(p, 1.01f * sixteenth), 0.005);  // a sample at an edge may go either way
    EXPECT_LT(part_differing(p, 0.1f * sixteenth), 0.03);
  }
}

TEST(TracePicture, IsTheSameForAnyNumberOfThreads) {
  const geometry::Scene scene = make_builtin_scene("alpha");
  const techniques::SceneDraws draws(scene, {});
  const std::vector<glm::ivec2> samples = sample_positions_fx8(1);
  const geometry::Camera camera = geometry::framing_camera(scene.bounds(), {48, 32});
  const PictureRequest request{.size_px = {48, 32}, .samples_fx8 = samples, .planes = {}};
  const raster::Image one = trace_picture(draws, camera, scene.bounds(), request, 1);
  const raster::Image three = trace_picture(draws, camera, scene.bounds(), request, 3);
  EXPECT_EQ(one.rgba32f, three.rgba32f);
  EXPECT_EQ(one.depth, three.depth);
  EXPECT_EQ(one.ids, three.ids);
}

/// A square at distance 2 seen through a 90° camera of 64 × 64 px: px = 32 + 32·x/2, so a pixel is 1/16 of a unit.
TEST(SurfacePoint, KnowsWeightsFootprintAndSide) {
  geometry::Camera camera;
  camera.tan_half_fov_y = 1.0;
  camera.near = 1.0;
  const std::vector<glm::vec3> positions = {{-1, -1, -2}, {1, -1, -2}, {-1, 1, -2}};
  const std::vector<glm::vec2> uvs = {{0, 1}, {4, 1}, {0, -1}};
  const std::vector<std::uint32_t> indices = {0, 1, 2};
  raster::Draw draw;
  draw.vertices = raster::ObjectVertices{positions, geometry::clip_from_world(camera, {64, 64})};
  draw.indices = indices;
  draw.uvs = uvs;
  // (24, 36) px is x = −½, y = −¼: weights ¼ along x, 3/8 along y.
  const SurfacePoint p = surface_point(draw, 0, {64, 64}, {24.0, 36.0});
  EXPECT_NEAR(p.weights[0], 0.375, 1e-12);
  EXPECT_NEAR(p.weights[1], 0.25, 1e-12);
  EXPECT_NEAR(p.weights[2], 0.375, 1e-12);
  EXPECT_EQ(p.depth, 0.5f);
  EXPECT_TRUE(p.front_facing);
  EXPECT_NEAR(p.footprint.uv.x, 1.0, 1e-12);
  EXPECT_NEAR(p.footprint.uv.y, 0.25, 1e-12);
  // u grows by 4 in 2 units, 32 px; v falls by 2 in 2 units upwards, so it grows by 1/16 a pixel down.
  EXPECT_NEAR(p.footprint.duv_dx.x, 0.125, 1e-12);
  EXPECT_NEAR(p.footprint.duv_dx.y, 0.0, 1e-12);
  EXPECT_NEAR(p.footprint.duv_dy.x, 0.0, 1e-12);
  EXPECT_NEAR(p.footprint.duv_dy.y, 0.0625, 1e-12);
}

/// In perspective the derivatives are those of the quotient: against differences of the footprint itself.
TEST(SurfacePoint, DerivativesAreThoseOfThePlane) {
  const geometry::Camera camera = camera_at({0.3, 0.5, 0.6}, {0.0, 0.0, -1.0}, 0.1);
  const std::vector<glm::vec3> positions = {{-3, 0, 2}, {3, 0, 1}, {0, -0.2f, -9}};  // one corner behind the eye
  const std::vector<glm::vec2> uvs = {{0, 1}, {4, 1}, {2, -1}};
  const std::vector<std::uint32_t> indices = {0, 1, 2};
  raster::Draw draw;
  draw.vertices = raster::ObjectVertices{positions, geometry::clip_from_world(camera, {64, 64})};
  draw.indices = indices;
  draw.uvs = uvs;
  const double h = 1e-4;
  const auto uv_at = [&](double x, double y) { return surface_point(draw, 0, {64, 64}, {x, y}).footprint.uv; };
  const SurfacePoint p = surface_point(draw, 0, {64, 64}, {30.0, 50.0});
  const glm::dvec2 dx = (uv_at(30.0 + h, 50.0) - uv_at(30.0 - h, 50.0)) / (2.0 * h);
  const glm::dvec2 dy = (uv_at(30.0, 50.0 + h) - uv_at(30.0, 50.0 - h)) / (2.0 * h);
  for (int k = 0; k < 2; ++k) {
    EXPECT_NEAR(p.footprint.duv_dx[k], dx[k], 1e-6);
    EXPECT_NEAR(p.footprint.duv_dy[k], dy[k], 1e-6);
  }
}

/// Of radius 2 at (148376, 1234, −223423), where floats are 1/64 apart: seen from inside, no sample shows the
/// background, by raster or by rays.
TEST(CameraRays, AFarAwayBallHasNoHolesFromInside) {
  geometry::Material material;
  material.double_sided = true;
  const glm::dvec3 centre(148376.0, 1234.0, -223423.0);
  geometry::Scene scene = geometry::scene_of(geometry::sphere(centre, 2.0, 200, 100), material);
  const SmallView view(std::move(scene), camera_at(centre, centre + glm::dvec3(0.3, 0.2, -1.0), 0.001), {64, 64});
  for (std::size_t i = 0; i < view.ray_ids.size(); ++i) {
    EXPECT_NE(view.ray_ids[i].draw, raster::kNoId);
    EXPECT_NE(view.image.ids[i].draw, raster::kNoId);
  }
  EXPECT_EQ(view.check().of(Verdict::unexplained), 0u);
}

}  // namespace
}  // namespace lode::experiments::truth
