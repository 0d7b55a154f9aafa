#include "experiments/metrics/id_difference.h"

#include "experiments/metrics/expect_size.h"

namespace lode::experiments {

IdDifference id_difference(std::span<const raster::Ids> reference, std::span<const raster::Ids> rendered) {
  expect_size("rendered ids", reference.size(), rendered.size());
  IdDifference d;
  for (std::size_t i = 0; i < reference.size(); ++i) {
    const raster::Ids expected = reference[i], found = rendered[i];
    d.wrong_ids += expected != found;
    if (expected.draw == found.draw) continue;
    d.wrong_draws += 1;
    d.missing += found.draw == raster::kNoId;
    d.added += expected.draw == raster::kNoId;
  }
  return d;
}

}  // namespace lode::experiments
