#pragma once
/// Popping: how much more a picture changes from one frame to the next than the truth does,
///
///   P_t = mean over pixels of |(I_t − I_{t−1}) − (R_t − R_{t−1})|,
///
/// I the pictures and R their references. An error that stays the same from frame to frame does not pop.

#include <glm/gtc/type_precision.hpp>
#include <span>

namespace lode::experiments {

/// Two frames that follow each other: stored 8-bit values [w*h] each, of which alpha does not count.
struct FramePairs {
  std::span<const glm::u8vec4> picture_before, picture;
  std::span<const glm::u8vec4> reference_before, reference;
};

/// In code values of one channel, 0 to 510: a pixel's value is the mean of its three channels.
struct Popping {
  double mean = 0.0;
  double p99 = 0.0;  ///< the smallest value that 99 of 100 pixels do not exceed (nearest rank)
};

/// In integers up to one division each; 0 for no pixels. Throws std::logic_error for planes of different sizes. O(w·h).
[[nodiscard]] Popping popping(const FramePairs& frames);

}  // namespace lode::experiments
