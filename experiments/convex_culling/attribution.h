#pragma once
/// Why an object that can be seen was culled: which of the method's liberties did it. Asked by taking them back one
/// after the other: the first that brings the object back is the cause.
///
///   depth      nothing but an angle says that the occluder is in front: brought back by the depth rule
///   snapping   corners moved to slabs, nothing is tested between them: brought back by columns
///   bulge      what is left: hulls that stick out of the model

#include "experiments/harness/culling_case.h"

namespace lode::experiments {

/// For each of the methods' falsely culled samples (at pixel centres) of the case: a row a method, with the number of
/// frames that have any and the samples of each of kCauses (names.h).
///   methods  names of "convex_culling" with any settings but those that are taken back, without the renderer's skips
[[nodiscard]] std::vector<Row> attributed_losses(const CullingCase& one, const CaseResult& result,
                                                 const techniques::World& world,
                                                 const std::vector<std::string>& methods,
                                                 const raster::RenderOptions& options);

}  // namespace lode::experiments
