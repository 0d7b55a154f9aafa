#include "geometry/convex_chains.h"

#include <algorithm>
#include <cmath>
#include <stdexcept>

#include "geometry/hull_2d.h"

namespace lode::geometry {

ConvexChains convex_chains(std::span<const glm::dvec2> points) {
  const std::vector<std::uint32_t> hull = convex_hull_2d(points);
  if (hull.empty()) throw std::logic_error("convex_chains: expected at least one point, found none");
  // From the lexicographically smallest corner along the lower chain to the largest, and back along the upper one. Of
  // an upright edge at either end, each chain has one corner only.
  const auto corner = [&](std::size_t i) -> const glm::dvec2& { return points[hull[i]]; };
  ConvexChains chains;
  std::size_t i = 0;
  chains.lower.push_back(corner(0));
  while (i + 1 < hull.size() && corner(i + 1).x > corner(i).x) chains.lower.push_back(corner(++i));
  if (i + 1 < hull.size() && corner(i + 1).x == corner(i).x) ++i;  // up the right end, or all that there is
  for (; i < hull.size() && corner(i).x > chains.left(); ++i) chains.upper.push_back(corner(i));
  chains.upper.push_back(i < hull.size() ? corner(i) : corner(0));
  std::ranges::reverse(chains.upper);
  return chains;
}

ChainHeight ChainWalk::at(double x) {
  const std::vector<glm::dvec2>& chain = *chain_;
  while (at_ + 2 < chain.size() && chain[at_ + 1].x <= x) ++at_;
  const glm::dvec2& p = chain[at_];
  if (at_ + 1 == chain.size() || x <= p.x) return {p.y, 0.0};
  const glm::dvec2& q = chain[at_ + 1];
  if (x >= q.x || p.y == q.y) return {q.y, 0.0};
  // With u = 2^-53 of |p.y| + |q.y|: three roundings in t ≤ 1, one each in q.y − p.y, the product and the sum, and one
  // when the error is added to y or taken off; 8u covers them. The last term stands for underflow.
  const double t = (x - p.x) / (q.x - p.x);
  return {p.y + t * (q.y - p.y), 0x1p-50 * (std::fabs(p.y) + std::fabs(q.y)) + 0x1p-500};
}

}  // namespace lode::geometry
