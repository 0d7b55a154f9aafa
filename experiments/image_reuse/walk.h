#pragma once
/// Methods on a stretch of a walk, frame after frame, since what they keep from frame to frame is what is looked at.

#include <functional>
#include <span>
#include <string>
#include <vector>

#include "experiments/harness/culling_case.h"
#include "experiments/harness/method.h"

namespace lode::experiments {

struct Walk {
  std::string scene, path;
  std::vector<std::uint32_t> frames;      ///< [n] one after the other
  std::vector<geometry::Camera> cameras;  ///< [n]
  glm::ivec2 size_px{640, 480};
  int n_passes = 1;       ///< timed, each from nothing kept; 0: no times
  int error_every = 50;   ///< frames from one whose error is measured to the next; 0: none is
  int n_steady = 30;      ///< frames from the middle on whose changes are held against the truth's
};

/// Columns of `results` beside scene, path, frame, method, and a column for each counter of the technique:
///   plates, captures, captured_px, objects, primitives      what the stage did
///   triangles_in, fragments_shaded, texels_read             the renderer's work
///   displacement_px, displacement_max_px   of plates, where error is measured: mean and greatest (displacement.h)
///   flip, psnr_db, ssim                                     likewise, against the picture of everything
///   pop, pop_p99                                            of steady frames (popping.h)
/// Columns of `times` beside those four: technique_ms, render_ms, frame_ms: medians over the passes.
///
///   methods   prepared on `world`; the first draws everything, and is what errors are held against
///   on_step   called after each frame of each pass
[[nodiscard]] CaseResult run_walk(const Walk& walk, const techniques::World& world,
                                  std::span<PreparedMethod* const> methods, int threads,
                                  const std::function<void()>& on_step);

}  // namespace lode::experiments
