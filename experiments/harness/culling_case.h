#pragma once
/// Culling methods on the views of one walk or one set of viewpoints: what each draws, what it loses, what it takes.
/// Methods take turns frame by frame, in an order that shifts from round to round, so that a machine that drifts
/// favours none.

#include <cstdint>
#include <functional>
#include <span>
#include <string>
#include <vector>

#include "experiments/harness/kept_results.h"
#include "experiments/harness/method.h"
#include "experiments/harness/row.h"

namespace lode::experiments {

struct CullingCase {
  std::string scene;                      ///< as it would be named on the command line
  std::string scene_hash;                 ///< of its geometry (hash_of): truth belongs to it
  std::string path;                       ///< "street", "random viewpoints"
  std::vector<std::uint32_t> frames;      ///< [n] numbers of the views, in the whole walk
  std::vector<geometry::Camera> cameras;  ///< [n]
  glm::ivec2 size_px{640, 480};
  std::uint64_t seed = 1;  ///< of the random places of samples
  int n_rounds = 3;        ///< timed; the results, which are made before, warm up; 0: no times
};

struct CaseResult {
  std::vector<Row> results;  ///< a row for each frame and method; deterministic
  std::vector<Row> times;    ///< likewise: medians over the rounds, ms
  std::vector<Row> losses;   ///< why, where an experiment asks: a row a method
};

/// Columns of `results` beside scene, path, frame, method, promise:
///   objects_in_view, occluders, tested, culled    as the technique counts them
///   objects, primitives, objects_in_view_drawn    drawn
///   shown_px                                      samples at centres that show any object
///   visible, could_be_culled                      objects in view that own a sample at a centre, or none
///   false_objects, false_px                       objects not drawn that own samples at centres, and those samples
///   false_samples_4x4, false_samples_random       at the other places (VisibleSamples)
///   same_picture                                  1 if colour, depth and ids are those of the whole scene
///   triangles_in, boxes_hidden, fragments_covered, fragments_shaded   the renderer's work
/// Columns of `times` beside those: technique_ms, render_ms, frame_ms, and a column for each part of the technique.
///
///   methods   prepared on `world`
///   truth     keeps visible samples
///   on_step   called after each frame of each round
[[nodiscard]] CaseResult run_culling_case(const CullingCase& one, const techniques::World& world,
                                          std::span<PreparedMethod* const> methods, const KeptResults& truth,
                                          const raster::RenderOptions& options, const std::function<void()>& on_step);

}  // namespace lode::experiments
