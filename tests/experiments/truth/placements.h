#pragma once
/// Random polygons, and random placements of their vertices within the snap, in exact arithmetic.

#include <array>
#include <cmath>

#include "experiments/truth/coverage.h"
#include "experiments/truth/depth_interval.h"
#include "experiments/truth/polygon.h"
#include "geometry/random.h"

namespace lode::experiments::truth {

using geometry::Random;

/// A coordinate in [0, 8): anything, a sample's, or one that puts an edge exactly at the reach from a sample.
inline double coordinate(Random& random) {
  switch (random.below(4)) {
    case 0:
      return random.below(8) + 0.5;
    case 1:
      return random.below(8) + 0.5 + (random.below(2) ? kSnap_px : -kSnap_px);
    default:
      return random.uniform(0.0, 8.0);
  }
}

/// A triangle in [0, 8)², at times a sliver, a point, or as small as the snap; depths in (0, 1].
inline ExactPolygon random_triangle(Random& random) {
  ExactPolygon t(3);
  const double size = random.below(3) == 0 ? 0.02 : 1.0;
  const double x = coordinate(random), y = coordinate(random);
  for (ExactVertex& v : t) {
    const double vx = x + size * (coordinate(random) - x), vy = y + size * (coordinate(random) - y);
    v.x_px = vx;
    v.y_px = vy;
    v.z = 1.0 - random.uniform();
  }
  if (random.below(4) == 0) {  // a sliver: the third vertex beside the line through the others
    const Rational along(random.uniform());
    t[2].x_px = t[0].x_px + along * (t[1].x_px - t[0].x_px) + Rational(random.uniform(-0.01, 0.01));
    t[2].y_px = t[0].y_px + along * (t[1].y_px - t[0].y_px);
  }
  return t;
}

/// A pixel's centre, or a point about the reach from the outline.
inline glm::dvec2 random_sample(const ExactPolygon& t, Random& random) {
  const double x = random.below(8) + 0.5, y = random.below(8) + 0.5;
  if (random.below(2) == 0) return {x, y};
  const std::size_t i = random.below(3);
  const ExactVertex &a = t[i], &b = t[(i + 1) % 3];
  const Rational along(random.below(4) == 0 ? 0.0 : random.uniform());
  const double offsets[] = {0.0, kSnap_px, random.uniform(0.0, 1.5 * kSnap_px)};
  const auto offset = [&] { return random.below(2) ? offsets[random.below(3)] : -offsets[random.below(3)]; };
  const Rational on_x = a.x_px + along * (b.x_px - a.x_px), on_y = a.y_px + along * (b.y_px - a.y_px);
  const double dx = offset();
  return {on_x.get_d() + dx, on_y.get_d() + offset()};
}

/// A vertex anywhere in its square, often on its corners and sides.
inline ExactVertex placed(const ExactVertex& v, Random& random) {
  const auto offset = [&] {
    const double choice[] = {-kSnap_px, kSnap_px, 0.0, random.uniform(-kSnap_px, kSnap_px)};
    return choice[random.below(4)];
  };
  ExactVertex moved = v;
  moved.x_px += Rational(offset());
  moved.y_px += Rational(offset());
  return moved;
}

inline Rational cross(const ExactVertex& a, const ExactVertex& b, glm::dvec2 s) {
  return (b.x_px - a.x_px) * (Rational(s.y) - a.y_px) - (b.y_px - a.y_px) * (Rational(s.x) - a.x_px);
}

/// 1 inside, −1 outside, 0 on the outline or without area.
inline int side(const ExactPolygon& polygon, glm::dvec2 s) {
  bool any_left = false, any_right = false, on_line = false;
  for (std::size_t i = 0; i < polygon.size(); ++i) {
    const Rational c = cross(polygon[i], polygon[(i + 1) % polygon.size()], s);
    any_left |= c > 0;
    any_right |= c < 0;
    on_line |= c == 0;
  }
  if (any_left && any_right) return -1;
  return on_line ? 0 : 1;
}

/// The least t ≥ 0 such that the square of half side t around s meets the segment a–b: max(|x|, |y|) is convex along
/// it, and least at an end, where x or y is 0, or where |x| = |y|.
inline Rational square_distance(const ExactVertex& a, const ExactVertex& b, glm::dvec2 s) {
  const Rational x0 = a.x_px - Rational(s.x), y0 = a.y_px - Rational(s.y);
  const Rational dx = b.x_px - a.x_px, dy = b.y_px - a.y_px;
  Rational least = -1;
  const auto try_at = [&](const Rational& t) {
    if (t < 0 || t > 1) return;
    const Rational x = abs(x0 + t * dx), y = abs(y0 + t * dy);
    const Rational here = x > y ? x : y;
    if (least < 0 || here < least) least = here;
  };
  try_at(0);
  try_at(1);
  if (dx != 0) try_at(-x0 / dx);
  if (dy != 0) try_at(-y0 / dy);
  if (dx != dy) try_at((y0 - x0) / (dx - dy));
  if (dx != -dy) try_at((-y0 - x0) / (dx + dy));
  return least;
}

}  // namespace lode::experiments::truth
