#pragma once
/// A convex polygon as its heights over x: two chains of edges from left to right, with bounds on the rounding of what
/// is read off them. What sweeps over polygons is made of.

#include <cstddef>
#include <glm/vec2.hpp>
#include <span>
#include <vector>

namespace lode::geometry {

/// y from lower to upper, for x from left() to right(). Each chain has strictly growing x, and the same first and last
/// x as the other; the lower one is convex, the upper one concave. One corner each if the polygon is upright.
struct ConvexChains {
  std::vector<glm::dvec2> lower, upper;
  std::vector<glm::dvec2> sorted;  ///< scratch of convex_chains()

  [[nodiscard]] double left() const { return lower.front().x; }
  [[nodiscard]] double right() const { return lower.back().x; }
};

/// The chains of the points' convex hull. points: [n] finite, n ≥ 1 (checked: std::logic_error); O(n log n).
[[nodiscard]] ConvexChains convex_chains(std::span<const glm::dvec2> points);
/// The same into chains that were made before, whose memory is used again.
void convex_chains(std::span<const glm::dvec2> points, ConvexChains& chains);

/// A height, and a bound on how far it is from the exact one: y ± error, in whatever rounding, holds it. At corners and
/// on level edges the error is 0.
struct ChainHeight {
  double y = 0.0;
  double error = 0.0;
};

/// Reads one chain's heights at x that grow, from its first to its last x. Coordinates up to 2^500 in size.
class ChainWalk {
 public:
  explicit ChainWalk(const std::vector<glm::dvec2>& chain) : chain_(&chain) {}

  [[nodiscard]] ChainHeight at(double x);

 private:
  const std::vector<glm::dvec2>* chain_;
  std::size_t at_ = 0;
};

}  // namespace lode::geometry
