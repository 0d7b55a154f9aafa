#pragma once
/// Names that the experiment's rows and its part of the report share.

#include <array>

namespace lode::experiments {

/// What leaves out nothing, what all are held against, and the paper's technique as it is shown.
inline constexpr const char *kEverything = "plain", *kBaseline = "frustum_culling",
                            *kPaper = "convex_culling:mode=safe";

/// Whose view from above is shown beside the paper's.
inline constexpr std::array kRivals = {"hierarchical_z", "masked_occlusion", "inner_boxes"};

/// The path of a case that is no walk.
inline constexpr const char* kRandomViewpoints = "random viewpoints";

/// What makes a method lose what can be seen: the column of the samples lost by it, and how the report says it.
struct Cause {
  const char *column, *words;
};
/// In the order in which they are asked for; the last is what is left when the others are ruled out.
inline constexpr std::array kCauses = {Cause{"depth_px", "by the missing depth rule"},
                                       Cause{"snapping_px", "by corners moved to slabs"},
                                       Cause{"bulge_px", "by hulls that bulge out of models"}};

}  // namespace lode::experiments
