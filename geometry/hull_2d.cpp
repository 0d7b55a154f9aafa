#include "geometry/hull_2d.h"

#include <algorithm>
#include <cmath>
#include <numeric>
#include <stdexcept>
#include <tuple>

#include "geometry/predicates.h"

namespace lode::geometry {
namespace {

/// The points from left to right, lower ones first, equal ones once (the first of them).
std::vector<std::uint32_t> sorted_distinct(std::span<const glm::dvec2> points) {
  std::vector<std::uint32_t> order(points.size());
  std::iota(order.begin(), order.end(), 0u);
  std::ranges::sort(order, [&](std::uint32_t a, std::uint32_t b) {
    return std::tuple(points[a].x, points[a].y, a) < std::tuple(points[b].x, points[b].y, b);
  });
  const auto equal = [&](std::uint32_t a, std::uint32_t b) { return points[a] == points[b]; };
  order.erase(std::unique(order.begin(), order.end(), equal), order.end());
  return order;
}

/// Appends one point to a chain of left turns that begins at `first`; corners that are none any more go.
void append(std::span<const glm::dvec2> points, std::size_t first, std::vector<std::uint32_t>& chain, std::uint32_t p) {
  while (chain.size() >= first + 2 &&
         orientation(points[chain[chain.size() - 2]], points[chain.back()], points[p]) <= 0) {
    chain.pop_back();
  }
  chain.push_back(p);
}

}  // namespace

std::vector<std::uint32_t> convex_hull_2d(std::span<const glm::dvec2> points) {
  for (const glm::dvec2& p : points) {
    if (!std::isfinite(p.x) || !std::isfinite(p.y)) throw std::logic_error("convex_hull_2d: expected finite points");
  }
  const std::vector<std::uint32_t> order = sorted_distinct(points);
  if (order.size() < 2) return order;
  std::vector<std::uint32_t> chain;
  for (const std::uint32_t p : order) append(points, 0, chain, p);
  const std::size_t rightmost = chain.size() - 1;
  for (std::size_t i = order.size() - 1; i-- > 0;) append(points, rightmost, chain, order[i]);
  chain.pop_back();  // the first point, reached again
  return chain;
}

}  // namespace lode::geometry
