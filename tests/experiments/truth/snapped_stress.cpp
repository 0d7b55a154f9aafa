/// Raster and Embree on the very same, snapped triangles: window coordinates are whole numbers of 1/256 px, which
/// floats hold exactly, seen by orthographic rays through the pixels' centres. Where integers say that a sample lies
/// strictly inside exactly one front-most triangle, both must show it; on an edge, one of the triangles that touch the
/// sample. Beside all triangles Embree may be wrong by a hair, and that is counted.

#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cstdio>
#include <vector>

#include "geometry/random.h"
#include "geometry/ray_query.h"
#include "raster/render.h"
#include "tests/raster/counter_random.h"

namespace lode::experiments::truth {
namespace {

using geometry::Random;

constexpr int kSide_px = 32;
constexpr int kSide_fx8 = kSide_px * 256;

/// Triangle k lies at depth 1 − (k + 1)/1024: the first is the nearest, and no two tie.
struct WindowTriangles {
  std::vector<glm::ivec2> p_fx8;  ///< [3n]
  [[nodiscard]] std::size_t size() const { return p_fx8.size() / 3; }
};

/// Half the triangles have their corners on samples a few pixels apart, so that samples lie on their edges; of the
/// others' coordinates half lie on samples or pixels' borders. Corners are shared at times.
WindowTriangles random_triangles(Random& random, int n) {
  WindowTriangles t;
  const auto anywhere = [&] {
    return random.below(2) == 0 ? 128 * int(random.below(2 * kSide_px + 1)) : int(random.below(kSide_fx8 + 1));
  };
  for (int i = 0; i < n; ++i) {
    const bool on_samples = random.below(2) == 0;
    const int x = int(random.below(kSide_px - 6)), y = int(random.below(kSide_px - 6));
    for (int k = 0; k < 3; ++k) {
      const auto on_sample = [&](int from) { return 256 * (from + int(random.below(7))) + 128; };
      const int px = on_samples ? on_sample(x) : anywhere();
      glm::ivec2 p(px, on_samples ? on_sample(y) : anywhere());
      if (!t.p_fx8.empty() && random.below(8) == 0) p = t.p_fx8[random.below(std::uint32_t(t.p_fx8.size()))];
      t.p_fx8.push_back(p);
    }
  }
  return t;
}

std::int64_t edge(glm::ivec2 a, glm::ivec2 b, glm::ivec2 s) {
  return std::int64_t(b.x - a.x) * (s.y - a.y) - std::int64_t(b.y - a.y) * (s.x - a.x);
}

/// 1 strictly inside, 0 on the outline, −1 outside; a triangle without area covers nothing.
int side(const WindowTriangles& t, std::size_t k, glm::ivec2 s) {
  const glm::ivec2 a = t.p_fx8[3 * k], b = t.p_fx8[3 * k + 1], c = t.p_fx8[3 * k + 2];
  const std::int64_t area = edge(a, b, c);
  if (area == 0) return -1;
  const std::int64_t sign = area > 0 ? 1 : -1;
  const std::int64_t least = std::min({sign * edge(a, b, s), sign * edge(b, c, s), sign * edge(c, a, s)});
  return least > 0 ? 1 : (least == 0 ? 0 : -1);
}

/// By how much the sample misses the triangle: its largest negative edge value, 0 if it touches it.
std::int64_t miss(const WindowTriangles& t, std::size_t triangle, glm::ivec2 s) {
  const glm::ivec2 a = t.p_fx8[3 * triangle], b = t.p_fx8[3 * triangle + 1], c = t.p_fx8[3 * triangle + 2];
  const std::int64_t sign = edge(a, b, c) > 0 ? 1 : -1;
  return -std::min({sign * edge(a, b, s), sign * edge(b, c, s), sign * edge(c, a, s), std::int64_t{0}});
}

/// Embree's robust test computes edge values in float and lets a ray meet a triangle that it misses by their rounding:
/// 2^-22 of the two products, each at most kSide_fx8².
constexpr std::int64_t kHair = std::int64_t{2} * kSide_fx8 * kSide_fx8 >> 22;

/// What may be shown: the triangles that touch the sample up to the first that it is strictly inside of.
struct Allowed {
  std::vector<std::uint32_t> touching;  ///< nearest first
  bool certain = false;                 ///< exactly one, strictly inside; or none
  bool ends_inside = false;             ///< the last is strictly around the sample: something must be shown
};

Allowed allowed(const WindowTriangles& t, glm::ivec2 s) {
  Allowed a;
  for (std::size_t k = 0; k < t.size() && !a.ends_inside; ++k) {
    const int where = side(t, k, s);
    if (where >= 0) a.touching.push_back(std::uint32_t(k));
    a.ends_inside = where > 0;
  }
  a.certain = a.touching.empty() || (a.ends_inside && a.touching.size() == 1);
  return a;
}

bool permits(const Allowed& a, std::uint32_t shown) {
  if (shown == raster::kNoId) return !a.ends_inside;
  return std::find(a.touching.begin(), a.touching.end(), shown) != a.touching.end();
}

raster::Image rasterized(const WindowTriangles& t) {
  std::vector<glm::dvec3> p_px;
  for (std::size_t i = 0; i < t.p_fx8.size(); ++i) {
    p_px.emplace_back(glm::dvec2(t.p_fx8[i]) / 256.0, 1.0 - double(i / 3 + 1) / 1024.0);
  }
  raster::Draw draw;
  draw.vertices = raster::WindowVertices{p_px};
  raster::Image image = raster::make_image({kSide_px, kSide_px}, raster::ColorFormat::rgba8,
                                           {.color = false, .depth = true, .ids = true});
  static_cast<void>(raster::render({.draws = {&draw, 1}, .viewport = {}, .scissor = {}}, image, {.threads = 1}));
  return image;
}

TEST(SnappedStress, RasterAndEmbreeAgreeStrictlyInside) {
  const std::uint64_t n_samples = tests::stress_count(10'000'000);
  std::uint64_t n_certain = 0, n_on_edges = 0, n_raster_wrong = 0, n_embree_wrong = 0, n_by_a_hair = 0;
  for (std::uint64_t i = 0; i * kSide_px * kSide_px < n_samples; ++i) {
    Random random(5, 1, i);
    const WindowTriangles t = random_triangles(random, 1 + int(random.below(40)));
    const raster::Image image = rasterized(t);
    std::vector<glm::vec3> positions;
    std::vector<std::uint32_t> indices;
    for (std::size_t k = 0; k < t.p_fx8.size(); ++k) {
      positions.emplace_back(glm::vec2(t.p_fx8[k]), -float(k / 3 + 1));
      indices.push_back(std::uint32_t(k));
    }
    const geometry::RayInstance instance{positions, indices};
    const geometry::RayScene scene({&instance, 1});
    for (int y = 0; y < kSide_px; ++y) {
      for (int x = 0; x < kSide_px; ++x) {
        const glm::ivec2 s(256 * x + 128, 256 * y + 128);
        const Allowed a = allowed(t, s);
        ++(a.certain ? n_certain : n_on_edges);
        const std::uint32_t by_raster = image.ids[std::size_t(y * kSide_px + x)].primitive;
        const auto hit = scene.nearest({.origin = glm::vec3(glm::vec2(s), 0.0f)});
        const std::uint32_t by_rays = hit ? hit->primitive : raster::kNoId;
        n_raster_wrong += !permits(a, by_raster);
        const bool by_a_hair = a.touching.empty() && hit && miss(t, by_rays, s) <= kHair;
        n_by_a_hair += by_a_hair;
        n_embree_wrong += !by_a_hair && !permits(a, by_rays);
        if (a.certain && by_raster != by_rays && !by_a_hair) {
          ADD_FAILURE() << "missed by " << (hit ? miss(t, by_rays, s) : 0) << ", case " << i << ", sample " << s.x
                        << "," << s.y << ": raster " << by_raster << ", rays " << by_rays;
        }
      }
    }
  }
  std::printf("[  COUNT   ] samples strictly inside or outside: %llu, on edges: %llu, missed by a hair: %llu\n",
              static_cast<unsigned long long>(n_certain), static_cast<unsigned long long>(n_on_edges),
              static_cast<unsigned long long>(n_by_a_hair));
  EXPECT_EQ(n_raster_wrong, 0u);
  EXPECT_EQ(n_embree_wrong, 0u);
  EXPECT_GT(n_on_edges, n_samples / 100);
}

}  // namespace
}  // namespace lode::experiments::truth
