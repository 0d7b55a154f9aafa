#pragma once
/// FLIP: the difference that a person sees who looks at two pictures by turns (Andersson, Nilsson, Akenine-Möller,
/// Oskarsson, Åström, Fairchild, "FLIP: A Difference Evaluator for Alternating Images", HPG 2020), as NVIDIA's FLIP 1.6
/// computes it: separated filters, picture edges repeated outwards.
///
/// In contrast to that program colours are in double, each pixel's sums in one order whatever the threads, and without
/// the C library's transcendentals: the same errors from every compiler. Features stay in single precision, with the
/// program's order of operations. Their weights sum to 0, but in floats only to 6e-8, and the square root of the
/// feature difference makes 1e-4 of that where pictures are flat: all in double, grey 128 against 136 is 0.127561, and
/// what the program computes, and everybody quotes, is 0.127591.

#include <functional>
#include <glm/vec3.hpp>

#include "experiments/metrics/error_map.h"
#include "experiments/metrics/picture_pair.h"

namespace lode::experiments {

struct FlipParams {
  /// Of sight: 0.7 m from a screen 0.7 m wide with 3840 pixels, 3840 · π/180. From 1 to 1000. The paper's is 67.
  double pixels_per_degree = 67.02064327658225;
  int threads = 1;  ///< 0: one per processor
};

/// Errors in [0, 1] of stored sRGB bytes. Symmetric in the two pictures; no errors for pictures of no pixels. O(w·h),
/// about 0.5 µs a pixel of one thread's time; beside the map about 6 kB per column and thread.
/// Throws std::logic_error if the spans are not of the size that the pair states.
[[nodiscard]] ErrorMap flip_map(const PicturePair& pair, const FlipParams& params = {});

/// The linear colour of a pixel [y*w + x], each channel in [0, 1]; called from several threads at once.
using LinearColors = std::function<glm::dvec3(std::size_t pixel)>;

/// The same, of any two pictures of one size.
[[nodiscard]] ErrorMap flip_map(glm::ivec2 size_px, const LinearColors& reference, const LinearColors& test,
                                const FlipParams& params);

}  // namespace lode::experiments
