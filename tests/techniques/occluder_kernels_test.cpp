/// The kernels of masked occlusion culling against the plain way, for every instruction set that can run here.

#include "techniques/masked_occlusion/occluder_kernels.h"

#include <gtest/gtest.h>

#include <limits>
#include <string>
#include <vector>

#include "geometry/random.h"

namespace lode::tests {
namespace {

using raster::Cull;
using raster::Target;
using techniques::MaskedDepth;
using techniques::OccluderKernels;
using techniques::ScreenTriangle;

constexpr glm::ivec2 kSize(160, 100);

std::vector<Target> targets() {
  std::vector<Target> all;
  for (const Target target : {Target::scalar, Target::sse4, Target::avx2, Target::avx512, Target::neon, Target::wasm}) {
    if (raster::can_run(target)) all.push_back(target);
  }
  return all;
}

MaskedDepth empty_buffer() {
  MaskedDepth buffer;
  buffer.begin(kSize);
  return buffer;
}

/// Where two buffers differ first; empty if nowhere.
std::string difference(const MaskedDepth& a, const MaskedDepth& b) {
  for (int y = 0; y < kSize.y; ++y) {
    for (int x = 0; x < kSize.x; ++x) {
      if (a.bound_at({x, y}) != b.bound_at({x, y})) return std::to_string(x) + "," + std::to_string(y);
    }
  }
  return "";
}

/// Half of the coordinates on sample positions and pixel edges, so that the top-left rule decides often.
glm::ivec2 random_point(geometry::Random& random, glm::ivec2 middle_fx8, int reach_px) {
  glm::ivec2 p_fx8;
  for (int axis = 0; axis < 2; ++axis) {
    const int v = middle_fx8[axis] + int(random.below(std::uint32_t(512 * reach_px))) - 256 * reach_px;
    p_fx8[axis] = random.below(2) == 0 ? v & ~127 : v;
  }
  return p_fx8;
}
glm::ivec2 random_middle(geometry::Random& random) {
  return 256 * glm::ivec2(int(random.below(std::uint32_t(kSize.x))), int(random.below(std::uint32_t(kSize.y))));
}

TEST(OccluderKernels, DrawATriangleAsTheReferenceDoes) {
  for (const Target target : targets()) {
    const OccluderKernels& kernels = techniques::occluder_kernels(target);
    ASSERT_EQ(kernels.target, target);
    for (const int reach_px : {2, 20, 200, 30000}) {
      geometry::Random random(7, std::uint32_t(reach_px));
      MaskedDepth expected = empty_buffer(), found = empty_buffer();
      for (int k = 0; k < 150; ++k) {
        const glm::ivec2 middle = random_middle(random);
        ScreenTriangle t;
        for (std::size_t i = 0; i < 3; ++i) {
          t.p_fx8[i] = random_point(random, middle, reach_px);
          t.z[i] = random.uniform(0.001, 1.0);
        }
        ASSERT_EQ(kernels.draw_triangle(t, found), techniques::draw_triangle(t, expected));
        if (k % 10 == 9) {
          ASSERT_EQ(difference(found, expected), "") << raster::name_of(target) << " " << reach_px << " " << k;
          expected.begin(kSize), found.begin(kSize);
        }
      }
    }
  }
}

/// A cluster of random triangles, with what the plain way needs to draw them.
struct RandomCluster {
  raster::fast::WindowVertices128 vertices;
  std::vector<std::uint8_t> corners;

  RandomCluster(geometry::Random& random, int n_vertices, int n_triangles, int reach_px) {
    const glm::ivec2 middle = random_middle(random);
    for (int i = 0; i < raster::kMaxClusterVertices; ++i) {
      const glm::ivec2 p = random_point(random, middle, i % 16 == 0 ? 200 : reach_px);
      vertices.xy_fx8[i] = std::uint64_t(std::uint32_t(p.x)) | std::uint64_t(std::uint32_t(p.y)) << 32;
      vertices.z[i] = random.uniform(0.001, 0.999);
      vertices.w[i] = 1.0;
    }
    for (int k = 0; k < 3 * n_triangles; ++k) {
      corners.push_back(std::uint8_t(random.below(std::uint32_t(n_vertices))));
    }
  }
  [[nodiscard]] ScreenTriangle triangle(int t) const {
    ScreenTriangle result;
    for (std::size_t k = 0; k < 3; ++k) {
      const std::uint8_t v = corners[3 * std::size_t(t) + k];
      result.p_fx8[k] = {vertices.x_fx8(v), vertices.y_fx8(v)};
      result.z[k] = vertices.z[v];
    }
    return result;
  }
};

/// What draws a cluster's triangles by themselves: as they are after the snap.
struct Plain {
  const RandomCluster& cluster;
  Cull cull;
  MaskedDepth& buffer;
  int n_drawn = 0;

  void draw(int t) {
    const std::int64_t area = techniques::doubled_area(cluster.triangle(t));  // y down: a front face's is negative
    if (cull == Cull::none || (cull == Cull::back) == (area < 0)) {
      n_drawn += techniques::draw_triangle(cluster.triangle(t), buffer) > 0 ? 1 : 0;
    }
  }
};

TEST(OccluderKernels, DrawAClusterAsItsTrianglesOneByOne) {
  for (const Target target : targets()) {
    geometry::Random random(8, 0);
    for (int k = 0; k < 60; ++k) {
      const int n_triangles = k % 7 == 0 ? 128 : 1 + int(random.below(128));
      const RandomCluster cluster(random, 3 + int(random.below(126)), n_triangles, k % 2 == 0 ? 4 : 25);
      const Cull cull = k % 3 == 0 ? Cull::none : k % 3 == 1 ? Cull::back : Cull::front;
      MaskedDepth expected = empty_buffer(), found = empty_buffer();
      Plain plain{cluster, cull, expected}, others{cluster, cull, found};
      for (int t = 0; t < n_triangles; ++t) plain.draw(t);
      techniques::OccluderWork work;
      techniques::occluder_kernels(target).draw_cluster(
          {.corners = cluster.corners.data(),
           .n_triangles = n_triangles,
           .vertices = &cluster.vertices,
           .cull = cull,
           .context = &others,
           .draw_other = [](void* self, int t) { static_cast<Plain*>(self)->draw(t); }},
          found, work);
      ASSERT_EQ(difference(found, expected), "") << raster::name_of(target) << " " << k;
      ASSERT_EQ(int(work.drawn) + others.n_drawn, plain.n_drawn);
    }
  }
}

TEST(OccluderKernels, AVertexThatAClampMayHaveMovedIsNotClean) {
  geometry::Random random(9, 0);
  const RandomCluster cluster(random, 20, 1, 50);
  for (const Target target : targets()) {
    const auto clean = [&](auto change) {
      raster::fast::WindowVertices128 vertices = cluster.vertices;
      change(vertices);
      return techniques::occluder_kernels(target).clean(vertices, 20);
    };
    const double nan = std::numeric_limits<double>::quiet_NaN();
    EXPECT_TRUE(clean([](auto&) {}));
    EXPECT_FALSE(clean([](auto& v) { v.z[17] = 0.0; }));  // at the far plane, or beyond
    EXPECT_FALSE(clean([](auto& v) { v.z[0] = 1.0; }));   // at the near plane, or nearer
    EXPECT_FALSE(clean([](auto& v) { v.w[19] = -1.0; }));
    EXPECT_FALSE(clean([&](auto& v) { v.w[3] = nan; }));
    EXPECT_FALSE(clean([](auto& v) { v.xy_fx8[5] = std::uint32_t(-(1 << 23)); }));  // the guard band's edge
    EXPECT_FALSE(clean([](auto& v) { v.xy_fx8[6] = std::uint64_t(1 << 23) << 32; }));
    EXPECT_TRUE(clean([](auto& v) { v.z[40] = 0.0; }));  // is none of the twenty
  }
}

}  // namespace
}  // namespace lode::tests
