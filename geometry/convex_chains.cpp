#include "geometry/convex_chains.h"

#include <algorithm>
#include <cmath>
#include <stdexcept>

#include "geometry/predicates.h"

namespace lode::geometry {

namespace {

/// Appends a point right of all others, or above the last one; corners that then are none go. Chains turn left
/// (turn = 1) or right (−1).
void append(std::vector<glm::dvec2>& chain, const glm::dvec2& p, int turn) {
  while (chain.size() >= 2 && turn * orientation(chain[chain.size() - 2], chain.back(), p) <= 0) chain.pop_back();
  chain.push_back(p);
}

}  // namespace

ConvexChains convex_chains(std::span<const glm::dvec2> points) {
  ConvexChains chains;
  convex_chains(points, chains);
  return chains;
}

/// Andrew's monotone chain over the points from left to right. Of points above each other the lower chain sees the
/// lowest, the upper one the highest.
void convex_chains(std::span<const glm::dvec2> points, ConvexChains& chains) {
  if (points.empty()) throw std::logic_error("convex_chains: expected at least one point, found none");
  std::vector<glm::dvec2>& sorted = chains.sorted;
  sorted.assign(points.begin(), points.end());
  std::sort(sorted.begin(), sorted.end(),
            [](const glm::dvec2& a, const glm::dvec2& b) { return a.x != b.x ? a.x < b.x : a.y < b.y; });
  chains.lower.clear();
  chains.upper.clear();
  for (std::size_t i = 0; i < sorted.size(); ++i) {
    if (i == 0 || sorted[i].x != sorted[i - 1].x) append(chains.lower, sorted[i], 1);
    if (i + 1 == sorted.size() || sorted[i].x != sorted[i + 1].x) append(chains.upper, sorted[i], -1);
  }
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
