#pragma once
/// What convex polygons cover of a screen's slabs, and the union of several: sorted intervals on each slab. The sets of
/// Onozawa & Kitazawa, "Occlusion culling with a hierarchical convex approximation of models", sec. 3.2 (there: hashed
/// arrays Y).

#include <cstddef>
#include <span>
#include <vector>

namespace lode::geometry {

/// The y from low to high, in px or bins; nothing if low > high.
struct SlabInterval {
  double low = 1.0;
  double high = 0.0;
};

/// What a polygon covers (occluder) or needs (occludee) on the slabs first, first + 1, …
struct SlabFootprint {
  int first = 0;
  std::vector<SlabInterval> intervals;

  [[nodiscard]] bool empty() const { return intervals.empty(); }
};

/// The union of occluders: on each slab sorted intervals that neither overlap nor touch. Two become one only where they
/// overlap or touch exactly.
class SlabUnion {
 public:
  explicit SlabUnion(int n_slabs = 100) : slabs_(std::size_t(n_slabs)) {}

  /// Footprints of the same params, for slabs 0…n_slabs − 1. O(slabs of the footprint · intervals there).
  void add(const SlabFootprint& occluder);
  /// Whether every interval of the occludee lies in one of the union's. True for an empty footprint.
  [[nodiscard]] bool covers(const SlabFootprint& occludee) const;
  void clear();

  [[nodiscard]] std::span<const SlabInterval> slab(int i) const { return slabs_[std::size_t(i)]; }

 private:
  std::vector<std::vector<SlabInterval>> slabs_;
};

}  // namespace lode::geometry
