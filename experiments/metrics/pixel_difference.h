#pragma once
/// Differences pixel by pixel, in integers.

#include <cstdint>
#include <optional>

#include "experiments/metrics/picture_pair.h"

namespace lode::experiments {

struct PixelDifference {
  int max = 0;                    ///< of any channel, in code values
  std::uint64_t differing = 0;    ///< pixels with any channel different
  std::uint64_t sum_squared = 0;  ///< over pixels and channels
  std::uint64_t n_values = 0;     ///< pixels times three channels
};
[[nodiscard]] PixelDifference pixel_difference(const PicturePair& pair);

/// Root of the mean squared difference, in code values; 0 for empty pictures.
[[nodiscard]] double rmse(const PixelDifference& d);
/// 10 log10(255² / mean squared difference), in dB; nothing for equal pictures.
[[nodiscard]] std::optional<double> psnr(const PixelDifference& d);

}  // namespace lode::experiments
