#pragma once
/// Whose each pixel is, against whose it should be.

#include <cstdint>
#include <span>

#include "raster/image.h"

namespace lode::experiments {

struct IdDifference {
  std::uint64_t wrong_ids = 0;    ///< pixels whose draw or primitive differs
  std::uint64_t wrong_draws = 0;  ///< those whose draw does: unlike ids, right where a technique draws a substitute
  std::uint64_t missing = 0;      ///< those where something should be and nothing is
  std::uint64_t added = 0;        ///< those where nothing should be and something is
};

/// Of two id planes of one size, [w*h] pixels or samples each (else std::logic_error). O(w·h).
[[nodiscard]] IdDifference id_difference(std::span<const raster::Ids> reference, std::span<const raster::Ids> rendered);

}  // namespace lode::experiments
