#pragma once
/// What is surely inside a model. A ray from outside of a closed surface's box into a region of winding number 1 or
/// more crosses a front face before it enters the region: so a shape that lies in such a region, and is invisible
/// itself, hides only what the surface hides.
///
/// Each part of the model that closes by itself (closed_parts.h) and has positive volume is looked at alone; a region
/// within it counts as solid whatever other parts do there. Parts that are open or inside out have no inside.

#include <cstddef>
#include <cstdint>
#include <glm/vec3.hpp>
#include <span>
#include <vector>

#include "geometry/bounds.h"
#include "geometry/convex_body.h"
#include "geometry/triangle_tree.h"

namespace lode::geometry {

class Solid {
 public:
  /// Nothing of the input is kept.
  ///   positions   [n] object space
  ///   indices     [3·m] each < n, of finite positions
  ///   throws      Error (bad_input), one line, naming the first index or position that is wrong
  ///   cost        O((n + m) log(n + m)) time, 36 doubles a triangle; deterministic
  Solid(std::span<const glm::vec3> positions, std::span<const std::uint32_t> indices);

  /// A part that closes, with positive volume.
  struct Part {
    Bounds bounds;
    double volume;  ///< object units cubed, as often as the surface winds round it
    TriangleTree tree;
  };
  [[nodiscard]] std::span<const Part> parts() const { return parts_; }
  [[nodiscard]] double volume() const;                              ///< of all parts, overlaps counted for each
  [[nodiscard]] std::size_t n_inward() const { return n_inward_; }  ///< closed parts without positive volume
  [[nodiscard]] std::size_t n_open() const { return n_open_; }
  [[nodiscard]] std::size_t n_dropped() const { return n_dropped_; }  ///< triangles with two equal corners

  /// How often the part's surface winds round p: exact for every finite p off the surface. On it, that of one side.
  ///   part   below parts().size()
  ///   cost   O(log m + triangles above p)
  [[nodiscard]] int winding(std::size_t part, const glm::dvec3& p) const;
  /// Where the line along z through (x, y), moved by less than any number, crosses the part's surface.
  struct Crossing {
    double z;    ///< rounded
    int facing;  ///< +1 if the line, upwards, leaves, −1 if it enters
  };
  /// In no order that is defined. The winding number at (x, y, z) is the sum of `facing` above it.
  [[nodiscard]] std::vector<Crossing> crossings(std::size_t part, double x, double y) const;
  /// Whether it winds round p at least once in some part.
  [[nodiscard]] bool contains(const glm::dvec3& p) const;

  /// Whether the convex hull of the points lies in one part, exactly: true only if the part's winding number is at
  /// least 1 at every point strictly inside of the hull, which may touch the surface. False, too, for points in a
  /// plane, of none at all, and not finite; for some hulls across several parts that together do contain it; and for a
  /// few very flat ones, of which no inner point is found.
  ///   cost   O(log m + triangles near its box · its edges)
  [[nodiscard]] bool contains_hull(std::span<const glm::vec3> points) const;
  /// The same of an axis-aligned box.
  [[nodiscard]] bool contains_box(const glm::vec3& low, const glm::vec3& high) const;

 private:
  [[nodiscard]] bool contains_body(const ConvexBody& body) const;

  std::vector<Part> parts_;
  std::size_t n_inward_, n_open_, n_dropped_;
};

}  // namespace lode::geometry
