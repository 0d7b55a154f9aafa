/// Embree's answers against exact orientations on soups, and what its door promises beside them.

#include "geometry/ray_query.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <atomic>
#include <cmath>
#include <glm/geometric.hpp>
#include <glm/gtc/matrix_transform.hpp>
#if defined(__x86_64__)
#include <xmmintrin.h>
#endif

#include "geometry/predicates.h"
#include "geometry/procedural.h"
#include "geometry/random.h"

namespace lode::geometry {
namespace {

using testing::ElementsAre;

/// A triangle soup in the cube [−1, 1]³; coordinates are multiples of 2^-12, so that sums of them are exact.
struct Soup {
  std::vector<glm::vec3> positions;
  std::vector<std::uint32_t> indices;

  explicit Soup(std::uint64_t seed, int n_triangles) {
    Random random(seed, 1);
    for (int i = 0; i < 3 * n_triangles; ++i) {
      positions.push_back(point(random));
      indices.push_back(std::uint32_t(i));
    }
  }
  static glm::vec3 point(Random& random) {
    const auto coordinate = [&] { return float(int(random.below(8193)) - 4096) / 4096.0f; };
    const float x = coordinate(), y = coordinate();
    return {x, y, coordinate()};
  }
  [[nodiscard]] std::array<glm::dvec3, 3> triangle(std::size_t i) const {
    return {positions[indices[3 * i]], positions[indices[3 * i + 1]], positions[indices[3 * i + 2]]};
  }
};

struct ExactHit {
  std::uint32_t primitive;
  double t;
  bool front;
  double margin;  ///< distance of the barycentrics from 0: how far from the outline
};

/// Every triangle that the ray from o through o + d meets in its inside or on its outline, by exact signs.
std::vector<ExactHit> exact_hits(const Soup& soup, const glm::dvec3& o, const glm::dvec3& d) {
  std::vector<ExactHit> hits;
  for (std::size_t i = 0; i < soup.indices.size() / 3; ++i) {
    const auto [a, b, c] = soup.triangle(i);
    const int s0 = orientation(o, o + d, b, c), s1 = orientation(o, o + d, c, a), s2 = orientation(o, o + d, a, b);
    const bool same = (s0 >= 0 && s1 >= 0 && s2 >= 0) || (s0 <= 0 && s1 <= 0 && s2 <= 0);
    const glm::dvec3 n = glm::cross(b - a, c - a);
    const double along = glm::dot(n, d);
    if (!same || along == 0.0) continue;
    const double t = glm::dot(n, a - o) / along;
    if (t < 0.0) continue;
    const glm::dvec3 p = o + t * d;
    const double area = glm::dot(n, n);
    const double margin = std::min({glm::dot(glm::cross(c - b, p - b), n), glm::dot(glm::cross(a - c, p - c), n),
                                    glm::dot(glm::cross(b - a, p - a), n)}) /
                          area;
    hits.push_back({std::uint32_t(i), t, along < 0.0, margin});
  }
  std::sort(hits.begin(), hits.end(), [](const ExactHit& a, const ExactHit& b) { return a.t < b.t; });
  return hits;
}

constexpr double kFloatMargin = 1e-5;  // a few hundred roundings of a float near 1

/// A ray from outside the cube into it, whose every answer is clear of a float's rounding; false where there is none.
bool clear_ray(const Soup& soup, Random& random, Ray& ray, std::vector<ExactHit>& hits) {
  const glm::vec3 target = Soup::point(random);
  ray.origin = 4.0f * Soup::point(random);
  ray.direction = target - ray.origin;
  if (std::max({std::abs(ray.origin.x), std::abs(ray.origin.y), std::abs(ray.origin.z)}) < 1.5f) return false;
  hits = exact_hits(soup, ray.origin, ray.direction);
  for (std::size_t k = 0; k < hits.size(); ++k) {
    if (hits[k].margin < kFloatMargin || (k > 0 && hits[k].t - hits[k - 1].t < kFloatMargin)) return false;
  }
  return true;
}

TEST(RayQuery, AgreesWithExactSignsWhereFloatsAreClear) {
  const Soup soup(7, 60);
  const RayInstance instance{soup.positions, soup.indices};
  const RayScene scene({&instance, 1});
  Random random(7, 2);
  int n_rays = 0;
  for (int k = 0; k < 400; ++k) {
    Ray ray;
    std::vector<ExactHit> exact;
    if (!clear_ray(soup, random, ray, exact)) continue;
    ++n_rays;
    const std::optional<RayHit> nearest = scene.nearest(ray);
    std::vector<RayHit> all;
    scene.all(ray, all);
    ASSERT_EQ(nearest.has_value(), !exact.empty());
    ASSERT_EQ(scene.occluded(ray), !exact.empty());
    ASSERT_EQ(all.size(), exact.size());
    if (nearest) {
      EXPECT_EQ(nearest->primitive, exact[0].primitive);
    }
    for (std::size_t i = 0; i < exact.size(); ++i) {
      EXPECT_EQ(all[i].primitive, exact[i].primitive);
      EXPECT_NEAR(all[i].t, exact[i].t, kFloatMargin);
      const auto [a, b, c] = soup.triangle(exact[i].primitive);
      const double u = all[i].u, v = all[i].v;
      const glm::dvec3 p = (1.0 - u - v) * a + u * b + v * c;
      const glm::dvec3 on_ray = glm::dvec3(ray.origin) + exact[i].t * glm::dvec3(ray.direction);
      EXPECT_LT(glm::length(p - on_ray), 1e-4);  // slivers among the soup: the weights err more than the place
    }
  }
  EXPECT_GT(n_rays, 200);
}

TEST(RayQuery, CullsTheSideThatIsAskedFor) {
  const Soup soup(11, 60);
  Random random(11, 2);
  for (const RayCull cull : {RayCull::back, RayCull::front}) {
    const RayInstance instance{soup.positions, soup.indices, glm::dmat4(1.0), cull};
    const RayScene scene({&instance, 1});
    for (int k = 0; k < 200; ++k) {
      Ray ray;
      std::vector<ExactHit> exact;
      if (!clear_ray(soup, random, ray, exact)) continue;
      std::erase_if(exact, [&](const ExactHit& hit) { return hit.front == (cull == RayCull::front); });
      std::vector<RayHit> all;
      scene.all(ray, all);
      ASSERT_EQ(all.size(), exact.size());
      for (std::size_t i = 0; i < exact.size(); ++i) EXPECT_EQ(all[i].primitive, exact[i].primitive);
      EXPECT_EQ(scene.occluded(ray), !exact.empty());
      const std::optional<RayHit> nearest = scene.nearest(ray);
      ASSERT_EQ(nearest.has_value(), !exact.empty());
      if (nearest) {
        EXPECT_EQ(nearest->primitive, exact[0].primitive);
      }
    }
  }
}

const std::vector<glm::vec3> kTriangle = {{-1, -1, 0}, {1, -1, 0}, {0, 1, 0}};
const std::vector<std::uint32_t> kCorners = {0, 1, 2};

Ray down_z(float z) { return {.origin = {0.0f, 0.0f, z}}; }

TEST(RayQuery, SeesOnlyWhatSharesABitOfTheMask) {
  const std::array<RayInstance, 2> instances = {
      RayInstance{kTriangle, kCorners, glm::translate(glm::dmat4(1.0), {0, 0, 1}), RayCull::none, 2},
      RayInstance{kTriangle, kCorners, glm::dmat4(1.0), RayCull::none, 1}};
  const RayScene scene(instances);
  Ray ray = down_z(3.0f);
  EXPECT_EQ(scene.nearest(ray)->instance, 0u);
  ray.mask = 1;
  EXPECT_EQ(scene.nearest(ray)->instance, 1u);
  ray.mask = 4;
  EXPECT_FALSE(scene.nearest(ray).has_value());
  EXPECT_FALSE(scene.occluded(ray));
}

TEST(RayQuery, StaysBetweenNearAndFar) {
  const RayInstance instance{kTriangle, kCorners};
  const RayScene scene({&instance, 1});
  Ray ray = down_z(3.0f);  // the triangle is at t = 3
  ray.t_near = 3.5f;
  EXPECT_FALSE(scene.occluded(ray));
  ray.t_near = 2.5f;
  EXPECT_TRUE(scene.occluded(ray));
  ray.t_far = 2.75f;
  EXPECT_FALSE(scene.occluded(ray));
}

TEST(RayQuery, AllHitsOfCoincidentTrianglesComeInTheOrderOfTheirIds) {
  const RayInstance one{kTriangle, kCorners};
  const std::vector<RayInstance> instances(3, one);
  const RayScene scene(instances);
  std::vector<RayHit> hits;
  scene.all(down_z(1.0f), hits);
  std::vector<std::uint32_t> order;
  for (const RayHit& hit : hits) order.push_back(hit.instance);
  EXPECT_THAT(order, ElementsAre(0u, 1u, 2u));
}

/// A unit triangle 10^6 from the origin, in a query space whose origin is beside it: t = 3/4 exactly, though floats
/// there are 1/16 apart.
TEST(RayQuery, TransformsInDouble) {
  const glm::dmat4 far = glm::translate(glm::dmat4(1.0), {0.0, 0.0, 1e6 + 0.25});
  const RayInstance instance{kTriangle, kCorners, glm::translate(glm::dmat4(1.0), {0.0, 0.0, -1e6}) * far};
  const RayScene scene({&instance, 1});
  EXPECT_EQ(scene.nearest(down_z(1.0f))->t, 0.75f);
}

TEST(RayQuery, AnEmptySceneIsMissedByAll) {
  const RayScene nothing({});
  EXPECT_FALSE(nothing.nearest(down_z(1.0f)).has_value());
  const RayInstance empty{kTriangle, {}};
  const RayScene no_triangles({&empty, 1});
  EXPECT_FALSE(no_triangles.occluded(down_z(1.0f)));
}

TEST(RayQuery, RaysThatAreNoneHitNothing) {
  const RayInstance instance{kTriangle, kCorners};
  const RayScene scene({&instance, 1});
  constexpr float kNan = std::numeric_limits<float>::quiet_NaN(), kInf = std::numeric_limits<float>::infinity();
  std::vector<Ray> rays(6, down_z(1.0f));
  rays[0].direction = {0.0f, 0.0f, 0.0f};
  rays[1].direction.z = kNan;
  rays[2].origin.x = kInf;
  rays[3].t_near = -1.0f;
  rays[4].t_far = kNan;
  rays[5].t_near = 3e38f;
  rays[5].t_far = 2e38f;
  for (const Ray& ray : rays) {
    std::vector<RayHit> hits(1);
    scene.all(ray, hits);
    EXPECT_TRUE(hits.empty());
    EXPECT_FALSE(scene.nearest(ray).has_value());
    EXPECT_FALSE(scene.occluded(ray));
  }
}

TEST(RayQuery, VerticesThatAreNotFiniteSpoilTheirTrianglesAlone) {
  constexpr float kNan = std::numeric_limits<float>::quiet_NaN();
  std::vector<glm::vec3> positions = kTriangle;
  positions.insert(positions.end(), {{-1, -1, 0.5f}, {1, -1, kNan}, {0, 1, 0.5f}});
  const std::vector<std::uint32_t> indices = {3, 4, 5, 0, 1, 2};
  const RayInstance instance{positions, indices};
  const RayScene scene({&instance, 1});
  EXPECT_EQ(scene.nearest(down_z(1.0f))->primitive, 1u);
}

TEST(RayQuery, NoNumberStopsIt) {
  constexpr float kNumbers[] = {0.0f,  1.0f,   -1.0f, 1e-40f, 1e10f,     1.8e18f,
                                1e19f, -3e38f, 3e38f, 0.5f,   HUGE_VALF, std::numeric_limits<float>::quiet_NaN()};
  for (std::uint64_t i = 0; i < 300; ++i) {
    Random random(13, 1, i);
    const auto number = [&] { return random.below(2) ? float(random.uniform(-1.0, 1.0)) : kNumbers[random.below(12)]; };
    const auto point = [&] {
      const float x = number(), y = number();
      return glm::vec3(x, y, number());
    };
    std::vector<glm::vec3> positions;
    std::vector<std::uint32_t> indices;
    for (std::uint32_t k = 0; k < 30; ++k) {
      positions.push_back(point());
      indices.push_back(random.below(k + 1));
    }
    const RayInstance instance{positions, indices, glm::dmat4(std::pow(10.0, random.uniform(-300.0, 300.0)))};
    const RayScene scene({&instance, 1});
    std::vector<RayHit> hits;
    for (int k = 0; k < 10; ++k) {
      const Ray ray{point(), point(), number(), number()};
      scene.all(ray, hits);
      EXPECT_EQ(scene.nearest(ray).has_value(), scene.occluded(ray));
    }
  }
}

TEST(RayQuery, ReportsProgressUpToAll) {
  const Mesh ball = sphere({0.0, 0.0, 0.0}, 1.0, 200, 100);
  const RayInstance instance{ball.positions, ball.indices};
  std::atomic<int> n_calls = 0;
  double largest = 0.0;
  const RayScene scene({&instance, 1}, [&](double done) {
    ++n_calls;
    largest = std::max(largest, done);
  });
  EXPECT_GT(n_calls, 0);
  EXPECT_GT(largest, 0.5);
  EXPECT_LE(largest, 1.0);
}

#if defined(__x86_64__)
/// FTZ, DAZ and rounding down, set by the caller: no call may change them, and none may be moved by them.
TEST(RayQuery, LeavesTheCallersFloatingPointStateAlone) {
  const unsigned before = _mm_getcsr(), strange = (before & ~0x3Fu) | 0x8040u | 0x2000u;
  const Soup soup(7, 60);
  const RayInstance instance{soup.positions, soup.indices};
  const Ray ray{.origin = {0.1f, 0.2f, 3.0f}, .direction = {0.01f, 0.02f, -1.0f}};
  const RayScene plain({&instance, 1});
  const std::optional<RayHit> expected = plain.nearest(ray);
  _mm_setcsr(strange);
  const RayScene scene({&instance, 1});
  const unsigned after_build = _mm_getcsr();
  const std::optional<RayHit> hit = scene.nearest(ray);
  const unsigned after_nearest = _mm_getcsr();
  std::vector<RayHit> hits;
  scene.all(ray, hits);
  const unsigned after_all = _mm_getcsr();
  (void)scene.occluded(ray);
  const unsigned after_occluded = _mm_getcsr();
  _mm_setcsr(before);
  EXPECT_EQ(after_build, strange);
  EXPECT_EQ(after_nearest, strange);
  EXPECT_EQ(after_all, strange);
  EXPECT_EQ(after_occluded, strange);
  ASSERT_TRUE(expected.has_value() && hit.has_value());
  EXPECT_EQ(hit->primitive, expected->primitive);
  EXPECT_EQ(hit->t, expected->t);
}
#endif

}  // namespace
}  // namespace lode::geometry
