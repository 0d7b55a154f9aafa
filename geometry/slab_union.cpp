#include "geometry/slab_union.h"

#include <algorithm>

namespace lode::geometry {

void SlabUnion::add(const SlabFootprint& occluder) {
  for (std::size_t i = 0; i < occluder.intervals.size(); ++i) {
    SlabInterval y = occluder.intervals[i];
    if (y.low > y.high) continue;
    std::vector<SlabInterval>& slab = slabs_.at(std::size_t(occluder.first) + i);
    // Those that end before y.low stay, those up to y.high become part of it.
    const auto begin = std::ranges::lower_bound(slab, y.low, {}, &SlabInterval::high);
    auto end = begin;
    for (; end != slab.end() && end->low <= y.high; ++end) {
      y = {std::min(y.low, end->low), std::max(y.high, end->high)};
    }
    if (begin == end) {
      slab.insert(begin, y);
    } else {
      *begin = y;
      slab.erase(begin + 1, end);
    }
  }
}

bool SlabUnion::covers(const SlabFootprint& occludee) const {
  for (std::size_t i = 0; i < occludee.intervals.size(); ++i) {
    const SlabInterval& y = occludee.intervals[i];
    if (y.low > y.high) continue;
    const std::vector<SlabInterval>& slab = slabs_.at(std::size_t(occludee.first) + i);
    const auto at = std::ranges::lower_bound(slab, y.high, {}, &SlabInterval::high);
    if (at == slab.end() || at->low > y.low) return false;
  }
  return true;
}

void SlabUnion::clear() {
  for (std::vector<SlabInterval>& slab : slabs_) slab.clear();
}

}  // namespace lode::geometry
