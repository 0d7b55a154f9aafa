#pragma once
/// Footprints of many occluders, slab by slab, of which any subset can be asked whether its union covers an occludee:
/// which occluders count differs from occludee to occludee (they must be in front of it).

#include <cstdint>
#include <span>
#include <vector>

#include "geometry/slab_union.h"

namespace lode::geometry {

class SlabOccluders {
 public:
  explicit SlabOccluders(int n_slabs = 100) : slabs_(std::size_t(n_slabs)) {}

  void clear();
  /// Takes a footprint of slabs 0…n_slabs − 1; they count from 0 in the order in which they are added.
  void add(const SlabFootprint& occluder);
  /// After the last one is added, before the first question. O(n log n) for the n intervals of each slab.
  void sort();

  /// Whether every interval of the occludee lies in one of the union of those occluders whose `counts` is not 0; of
  /// intervals that overlap or touch exactly, the union is one. True for an empty footprint.
  ///   counts   [occluders]
  ///   cost     O(intervals in the slabs of the occludee)
  [[nodiscard]] bool cover(const SlabFootprint& occludee, std::span<const std::uint8_t> counts) const;

  [[nodiscard]] std::size_t size() const { return n_; }

 private:
  struct Entry {
    double low, high;
    std::uint32_t occluder;
  };
  std::vector<std::vector<Entry>> slabs_;
  std::uint32_t n_ = 0;
};

}  // namespace lode::geometry
