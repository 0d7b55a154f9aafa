#pragma once
/// SSIM (Wang, Bovik, Sheikh, Simoncelli, "Image quality assessment: from error visibility to structural similarity",
/// IEEE TIP 2004) and MS-SSIM (Wang, Simoncelli, Bovik, "Multiscale structural similarity for image quality
/// assessment", Asilomar 2003), of the three channels by themselves and then averaged.
///
/// 11×11 Gaussian window of σ 1.5, K₁ = 0.01, K₂ = 0.03, range 255, population covariance, only where the whole window
/// is inside the picture. Sums run in double, row by row: the same on every machine.

#include <optional>

#include "experiments/metrics/picture_pair.h"

namespace lode::experiments {

/// Smallest side that has an SSIM: the window; and an MS-SSIM: the window after four halvings.
inline constexpr int kMinSsimSize_px = 11;
inline constexpr int kMinMsSsimSize_px = 11 * 16;

/// 1 for equal pictures; nothing where a side is shorter than kMinSsimSize_px.
[[nodiscard]] std::optional<double> ssim(const PicturePair& pair);

/// Five scales, each of half the size (2×2 means; an odd last row or column is left out), with the paper's weights
/// 0.0448, 0.2856, 0.3001, 0.2363, 0.1333. A scale whose contrast and structure are below 0 counts as 0. Nothing where
/// a side is shorter than kMinMsSsimSize_px.
[[nodiscard]] std::optional<double> ms_ssim(const PicturePair& pair);

}  // namespace lode::experiments
