#pragma once
/// A tree of boxes over triangles, halved at the median along the longest side: what asks for few of many triangles
/// looks at few. The order in which triangles are met is not defined; answers must not depend on it.

#include <array>
#include <cstdint>
#include <glm/vec3.hpp>
#include <span>
#include <vector>

#include "geometry/bounds.h"

namespace lode::geometry {

using SpaceTriangle = std::array<glm::dvec3, 3>;  ///< corners, finite

class TriangleTree {
 public:
  /// triangles   [n], n < 2^31; cost O(n log n)
  explicit TriangleTree(std::vector<SpaceTriangle> triangles);

  /// Whether `keep(triangle)` holds for all triangles in boxes that are entered: a box, and all that is in it, is left
  /// out if not `enter(box)`. Ends at the first for which it does not hold.
  template <class Enter, class Keep>
  bool all_of(const Enter& enter, const Keep& keep) const {
    std::array<std::uint32_t, 64> stack;  // a tree halved at medians is no deeper than 32
    std::size_t n = 0;
    if (!nodes_.empty()) stack[n++] = 0;
    while (n > 0) {
      const Node& node = nodes_[stack[--n]];
      if (!enter(node.bounds)) continue;
      for (std::uint32_t i = 0; i < node.n_triangles; ++i) {
        if (!keep(triangles_[node.first + i])) return false;
      }
      if (node.n_triangles == 0) {
        stack[n++] = node.first + 1;
        stack[n++] = node.first;
      }
    }
    return true;
  }

  [[nodiscard]] std::span<const SpaceTriangle> triangles() const { return triangles_; }

 private:
  struct Node {
    Bounds bounds;
    std::uint32_t first = 0;        ///< triangle of a leaf, else child; the other child is the next
    std::uint32_t n_triangles = 0;  ///< of a leaf, else 0
  };
  void split(std::uint32_t node, std::uint32_t first, std::uint32_t n);

  std::vector<SpaceTriangle> triangles_;
  std::vector<Node> nodes_;
};

}  // namespace lode::geometry
