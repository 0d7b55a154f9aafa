#pragma once
/// Pictures of one view of a culling case: everything, what a method draws, what it loses, and the scene from above.

#include <span>
#include <string>
#include <vector>

#include "experiments/harness/culling_case.h"

namespace lode::experiments {

/// The frame in which the method loses the most; the middle one if it loses nothing. Index in the case's cameras.
[[nodiscard]] std::size_t telling_frame(const CullingCase& one, const CaseResult& result, const std::string& method);

/// The scene from above, as an SVG that stands alone: boxes of objects that are drawn and seen, drawn and not seen,
/// rightly and falsely culled, and outside the view (classes seen, kept, culled, lost, out), with eye and view.
[[nodiscard]] std::string top_view(const techniques::World& world, const geometry::Camera& camera, glm::ivec2 size_px,
                                   const PreparedMethod& method, const std::vector<std::uint32_t>& owned_samples);

/// Draws the view by the method and writes FOLDER/NAME.whole.png and .top.svg and, if anything is lost, .drawn.png,
/// .difference.png (in red, in a yellow frame) and .flip.png (the errors of FLIP in the colours of magma); and
/// .RIVAL.top.svg for each of the rivals. Returns the files' names.
std::vector<std::string> write_case_pictures(const CullingCase& one, std::size_t frame, const techniques::World& world,
                                             PreparedMethod& method, std::span<PreparedMethod* const> rivals,
                                             const raster::RenderOptions& options, const std::string& folder);

}  // namespace lode::experiments
