#include "geometry/slab_occluders.h"

#include <algorithm>

namespace lode::geometry {

void SlabOccluders::clear() {
  for (std::vector<Entry>& slab : slabs_) slab.clear();
  n_ = 0;
}

void SlabOccluders::add(const SlabFootprint& occluder) {
  for (std::size_t i = 0; i < occluder.intervals.size(); ++i) {
    const SlabInterval& y = occluder.intervals[i];
    if (y.low <= y.high) slabs_.at(std::size_t(occluder.first) + i).push_back({y.low, y.high, n_});
  }
  ++n_;
}

void SlabOccluders::sort() {
  for (std::vector<Entry>& slab : slabs_) {
    std::sort(slab.begin(), slab.end(),
              [](const Entry& a, const Entry& b) { return a.low != b.low ? a.low < b.low : a.occluder < b.occluder; });
  }
}

/// From the bottom of the interval upwards: how far the intervals that begin no later reach.
bool SlabOccluders::cover(const SlabFootprint& occludee, std::span<const std::uint8_t> counts) const {
  for (std::size_t i = 0; i < occludee.intervals.size(); ++i) {
    const SlabInterval& y = occludee.intervals[i];
    if (y.low > y.high) continue;
    double reach = y.low;
    bool begun = false;
    for (const Entry& entry : slabs_.at(std::size_t(occludee.first) + i)) {
      if (entry.low > reach || (begun && reach >= y.high)) break;
      if (counts[entry.occluder] == 0 || entry.high < reach) continue;
      begun = true;
      reach = entry.high;
    }
    if (!begun || reach < y.high) return false;
  }
  return true;
}

}  // namespace lode::geometry
