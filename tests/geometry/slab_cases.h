#pragma once
/// Random occluders and occludees on a screen, and the exact answer to whether one point is in one of them.

#include <cmath>
#include <cstdint>
#include <glm/vec2.hpp>
#include <span>
#include <vector>

#include "geometry/hull_2d.h"
#include "geometry/predicates.h"
#include "geometry/random.h"
#include "geometry/slab_test.h"

namespace lode::geometry::test {

using Polygon = std::vector<glm::dvec2>;

inline Polygon hull_of(const Polygon& points) {
  Polygon hull;
  for (const std::uint32_t i : convex_hull_2d(points)) hull.push_back(points[i]);
  return hull;
}

/// In the closed hull, which is as convex_hull_2d gives it and has an area.
inline bool contains(const Polygon& hull, const glm::dvec2& p) {
  for (std::size_t i = 0; i < hull.size(); ++i) {
    if (orientation(hull[i], hull[(i + 1) % hull.size()], p) < 0) return false;
  }
  return hull.size() > 2;
}

/// One coordinate: anywhere about the screen, on a column's end, or one unit in the last place beside it.
inline double hard_coordinate(Random& random, double size, int n_slabs) {
  const double anywhere = random.uniform(-0.3, 1.3) * size;
  const double on_end = double(random.below(std::uint32_t(n_slabs) + 1)) * size / double(n_slabs);
  switch (random.below(4)) {
    case 0:
      return on_end;
    case 1:
      return std::nextafter(on_end, random.below(2) ? 1e9 : -1e9);
    default:
      return anywhere;
  }
}

/// Occluders that fuse: random polygons, or a grid of cells that share edges, up to a gap of nothing or very little.
inline std::vector<Polygon> random_occluders(Random& random, const SlabParams& params) {
  std::vector<Polygon> occluders;
  const glm::dvec2 size = params.size_px;
  if (random.below(2)) {
    for (std::uint32_t n = 1 + random.below(4); n > 0; --n) {
      Polygon p;
      for (std::uint32_t k = 3 + random.below(6); k > 0; --k) {
        p.emplace_back(hard_coordinate(random, size.x, params.n_slabs), hard_coordinate(random, size.y, 7));
      }
      occluders.push_back(p);
    }
    return occluders;
  }
  const double gap = random.below(2) ? 0.0 : 1e-9;
  const double lean = random.uniform(-0.4, 0.4) * size.y;
  const int n = 1 + int(random.below(4));
  std::vector<double> cuts = {-0.5 * size.y};
  for (int i = 0; i < n; ++i) cuts.push_back(cuts.back() + random.uniform(0.1, 1.0) * size.y);
  for (int i = 0; i < n; ++i) {
    const double low = cuts[std::size_t(i)] + gap, high = cuts[std::size_t(i) + 1];
    occluders.push_back(
        {{-size.x, low - lean}, {2 * size.x, low + lean}, {2 * size.x, high + lean}, {-size.x, high - lean}});
  }
  return occluders;
}

inline Polygon random_occludee(Random& random, const SlabParams& params) {
  const glm::dvec2 centre(random.uniform(-0.1, 1.1) * params.size_px.x, random.uniform(-0.1, 1.1) * params.size_px.y);
  const double size = random.uniform(0.001, 0.3) * params.size_px.x;
  Polygon p;
  for (std::uint32_t k = 3 + random.below(6); k > 0; --k) {
    p.push_back(centre + glm::dvec2(random.uniform(-1, 1), random.uniform(-1, 1)) * size);
  }
  return p;
}

struct SlabTally {
  std::uint64_t covered = 0;        ///< said to be
  std::uint64_t points = 0;         ///< tried in occludees that were said to be covered
  std::uint64_t false_answers = 0;  ///< of these, in no occluder
};

/// Case i: asks whether a random occludee is covered, and if it is said to be, tries random points of it.
inline void slab_case(std::uint64_t i, SlabParams params, int n_points, SlabTally& tally) {
  Random random(3, 78, i);
  params.n_slabs = 1 + int(random.below(120));
  const std::vector<Polygon> occluders = random_occluders(random, params);
  SlabUnion united(params.n_slabs);
  std::vector<Polygon> hulls;
  for (const Polygon& occluder : occluders) {
    united.add(occluder_footprint(occluder, params));
    hulls.push_back(hull_of(occluder));
  }
  for (int k = 0; k < 8; ++k) {
    const Polygon occludee = random_occludee(random, params);
    if (!united.covers(occludee_footprint(occludee, params))) continue;
    ++tally.covered;
    const Polygon hull = hull_of(occludee);
    for (int j = 0; j < n_points; ++j) {
      // A corner, or a random mean of the corners; rounding may put either outside, and then it does not count.
      glm::dvec2 p = hull[random.below(std::uint32_t(hull.size()))];
      for (const glm::dvec2& q : hull) p += (q - p) * (random.below(3) == 0 ? 0.0 : random.uniform());
      const bool on_screen = p.x >= 0 && p.y >= 0 && p.x <= params.size_px.x && p.y <= params.size_px.y;
      if (!on_screen || !contains(hull, p)) continue;
      ++tally.points;
      bool found = false;
      for (const Polygon& occluder : hulls) found = found || contains(occluder, p);
      tally.false_answers += !found;
    }
  }
}

}  // namespace lode::geometry::test
