#pragma once
/// HDR-FLIP: FLIP of pictures of high dynamic range (Andersson, Nilsson, Shirley, Akenine-Möller, "Visualizing Errors
/// in Rendered High Dynamic Range Images", Eurographics 2021), as NVIDIA's FLIP 1.6 computes it by default.
///
/// Both pictures are exposed for their brightest parts, for their dim ones and in steps of about a stop between, tone
/// mapped (ACES as Narkowicz fitted it), and compared by FLIP; a pixel's error is the largest that it has in any.
///
/// In contrast to the program, values below 0 count as 0 (the fitted curve turns upwards there), and a reference whose
/// median is black takes the median of its pixels that are not (the program's range of exposures is then infinite).

#include <glm/vec4.hpp>
#include <optional>
#include <span>

#include "experiments/metrics/flip/flip.h"

namespace lode::experiments {

/// Two pictures of linear premultiplied colours, as over black: alpha does not count.
struct LinearPair {
  glm::ivec2 size_px{0, 0};
  std::span<const glm::vec4> reference, test;  ///< [w*h]
};

/// In stops: colours are multiplied by 2^stop.
struct Exposures {
  double start = 0.0, stop = 0.0;
  int n = 2;  ///< at least 2, the first at `start` and the last at `stop`

  [[nodiscard]] double at(int i) const { return start + (stop - start) * i / (n - 1); }
};

/// From where the reference's largest luminance is mapped to 0.85 to where its median one is. A picture without light
/// is exposed twice at 0.
[[nodiscard]] Exposures exposures_of(std::span<const glm::vec4> reference);

/// Errors in [0, 1]; nothing if any colour of either is not finite. Not symmetric: the reference sets the exposures.
/// The time of FLIP for each of them, at most 280.
/// Throws std::logic_error if the spans are not of the size that the pair states.
[[nodiscard]] std::optional<ErrorMap> hdr_flip_map(const LinearPair& pair, const FlipParams& params = {});

}  // namespace lode::experiments
