#pragma once
/// Names that the experiment's rows and its part of the report share.

#include <array>
#include <string>
#include <string_view>

namespace lode::experiments {

/// What keeps no pictures; all are held against it.
inline constexpr const char* kNoCache = "plain";

/// Ohno et al. measured 1, 2 and 5; the others surround them.
inline constexpr std::array kThresholds_deg = {"0.5", "1", "2", "3", "5", "10"};

inline constexpr std::string_view kReuse = "image_reuse:";

/// The paper's technique at a threshold, and as the paper prints it at the one that it recommends.
[[nodiscard]] inline std::string reuse_at(std::string_view threshold_deg) {
  return std::string(kReuse) + "threshold=" + std::string(threshold_deg);
}
inline constexpr const char* kLiteral = "image_reuse:threshold=2,placement=literal";

/// The walks: the paper's case 1, straight to the houses and back, and case 2, sideways.
inline constexpr std::string_view kApproach = "approach", kSideways = "sideways";

/// The pictures of a walk's middle frame: what follows "scene.path.frame".
inline constexpr std::string_view kWholePicture = ".whole.png", kReusedPicture = ".reused.png",
                                  kReusedFlip = ".reused.flip.png", kLiteralPicture = ".literal.png";

}  // namespace lode::experiments
