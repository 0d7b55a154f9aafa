/// Vertices of occluders against the renderer's own, and what decides which clusters are looked at.

#include "techniques/masked_occlusion/occluder_vertex.h"

#include <gtest/gtest.h>

#include <cmath>
#include <limits>

#include "geometry/camera.h"
#include "techniques/masked_occlusion/cluster_walk.h"
#include "tests/techniques/technique_pictures.h"

namespace lode::tests {
namespace {

namespace reference = raster::reference;
using techniques::OccluderVertex;

bool same(const glm::dvec4& a, const glm::dvec4& b) {
  for (int i = 0; i < 4; ++i) {
    if (!(a[i] == b[i] || (std::isnan(a[i]) && std::isnan(b[i])))) return false;
  }
  return true;
}

void expect_the_renderers(const glm::dmat4& clip_from_object, glm::ivec2 size_px, const glm::vec3& p) {
  const OccluderVertex v = techniques::ToScreen(clip_from_object, size_px)(p);
  const reference::Viewport viewport = reference::make_viewport({{0, 0}, size_px});
  const glm::dvec4 clip = reference::clip_position(raster::ObjectVertices{{&p, 1}, clip_from_object}, 0);
  EXPECT_TRUE(same(v.clip, clip)) << p.x << " " << p.y << " " << p.z;
  if (reference::has_nan(clip)) {
    EXPECT_EQ(v.outside, techniques::kNotANumber);
    return;
  }
  EXPECT_EQ(v.outside, reference::outside_planes(viewport, clip));
  if (v.outside != 0) return;
  const reference::WindowVertex window = reference::window_vertex(viewport, clip);
  EXPECT_EQ(v.p_fx8, window.p_fx8);
  EXPECT_EQ(v.z, window.z);
}

TEST(OccluderVertex, IsTheRenderersToTheBit) {
  int n_inside = 0;
  for (std::uint64_t k = 0; k < 200; ++k) {
    techniques::View view = random_view(11, k);
    if (k % 4 == 0) view.size_px = {32768, 7};
    const glm::dmat4 m = geometry::clip_from_world(view.camera, view.size_px);
    geometry::Random random(12, 0, k);
    for (int i = 0; i < 50; ++i) {
      const double reach = i % 5 == 0 ? 1e6 : 15.0;
      const auto coordinate = [&] { return float(random.uniform(-reach, reach)); };
      const float x = coordinate(), y = coordinate(), z = coordinate();
      expect_the_renderers(m, view.size_px, {x, y, z});
      n_inside += techniques::ToScreen(m, view.size_px)({x, y, z}).outside == 0 ? 1 : 0;
    }
  }
  EXPECT_GT(n_inside, 1000);
}

TEST(OccluderVertex, OfAnyPointIsTheRenderersToo) {
  const float infinity = std::numeric_limits<float>::infinity(), nan = std::numeric_limits<float>::quiet_NaN();
  const float values[] = {0.0f, -0.0f, 1.0f, -3.0f, 1e-45f, 3e38f, -3e38f, infinity, -infinity, nan};
  const techniques::View view = random_view(11, 1);
  const glm::dmat4 m = geometry::clip_from_world(view.camera, view.size_px);
  for (const float x : values) {
    for (const float y : values) {
      for (const float z : values) expect_the_renderers(m, view.size_px, {x, y, z});
    }
  }
}

TEST(EyeOf, IsWhereTheCameraStands) {
  for (std::uint64_t k = 0; k < 20; ++k) {
    const techniques::View view = random_view(13, k);
    const glm::dvec4 eye = techniques::eye_of(geometry::clip_from_world(view.camera, view.size_px));
    if (view.camera.projection == geometry::Projection::perspective) {
      EXPECT_LT(glm::length(glm::dvec3(eye) / eye.w - view.camera.eye), 1e-9);
    } else {
      EXPECT_LT(std::abs(eye.w), 1e-12);
    }
    // A triangle that is turned to the camera: its normal is the camera's back.
    const glm::dvec3 p = view.camera.eye - 5.0 * view.camera.back;
    EXPECT_GT(glm::dot(view.camera.back, glm::dvec3(eye) - eye.w * p), 0.0);
  }
}

TEST(ClusterWalk, LeavesOutWhatFacesAwayOrIsHidden) {
  // A ball of 2·64·31 triangles: about half face away, and behind a buffer that is nearer everywhere none is left.
  const geometry::Scene scene = geometry::scene_of(geometry::sphere({0, 0, -10}, 1.0, 64, 32));
  const techniques::World world(scene, kRawUnlit, true, 1);
  techniques::View view;
  view.size_px = {64, 64};
  const raster::Draw draw = world.draws().draw(0, geometry::clip_from_world(view.camera, view.size_px));
  techniques::MaskedDepth buffer;
  buffer.begin(view.size_px);
  techniques::ClusterWalk walk;
  std::uint64_t n_read = 0;
  const std::size_t n = walk.worth_drawing(draw, view.size_px, buffer, n_read).size();
  EXPECT_GT(n, draw.clusters->clusters.size() / 3);
  EXPECT_LT(n, draw.clusters->clusters.size() * 3 / 4);
  for (int y = 0; y < 16; ++y) {
    for (int x = 0; x < 8; ++x) buffer.add({x, y}, ~0u, 0.5f);
  }
  EXPECT_TRUE(walk.worth_drawing(draw, view.size_px, buffer, n_read).empty());
}

}  // namespace
}  // namespace lode::tests
