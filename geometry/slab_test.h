#pragma once
/// Is a convex polygon on the screen covered by the union of others? Asked on equally spaced vertical slabs, without
/// any pixels. Onozawa & Kitazawa, "Occlusion culling with a hierarchical convex approximation of models", sec. 3.2.
///
///   paper         one vertical line in the middle of each slab. Corners move to the nearest line (by up to half a
///                 slab), y is hashed to bins, and a bin that is touched counts as full: as the paper has it
///   exact_x       the same lines, corners stay where they are: edges are evaluated at each line
///   conservative  slabs are columns. An occluder gives the part of a column that it covers over the whole width, an
///                 occludee takes all that it touches: what is said to be covered is covered at every point of the
///                 screen, whatever the rounding
///
/// The polygons are the convex hulls of the points given. The screen is [0, size.x] × [0, size.y]; occludees are cut to
/// it, only what is on it has to be covered. A footprint is made once for each polygon; unions are then cheap to make
/// and ask. Depth is the caller's matter.

#include <cstdint>
#include <glm/vec2.hpp>
#include <span>
#include <vector>

#include "geometry/convex_chains.h"
#include "geometry/slab_union.h"

namespace lode::geometry {

enum class SlabMode : std::uint8_t { paper, exact_x, conservative };

struct SlabParams {
  glm::dvec2 size_px{640.0, 480.0};  ///< of the virtual screen, ≥ 1; the paper takes the real screen's
  int n_slabs = 100;                 ///< 1…65536; the paper has "about 100"
  SlabMode mode = SlabMode::conservative;
  /// 0…2^20 bins of y from 0 to size.y; 0: as the mode has it, 512 for `paper` (which leaves it open) and exact y for
  /// the others. In `conservative`, occluders lose the bins that they do not fill.
  int y_bins = 0;
  /// Only `conservative`, ≥ 0: occluders shrink and occludees grow by this on all sides. The default covers the snap
  /// of drawn vertices (1/512 px) and the rounding of a projection.
  double margin_px = 1.0 / 256.0;
};

/// Coordinates beyond this are not taken: an occluder that has any, or a NaN, covers nothing, an occludee is never
/// covered.
inline constexpr double kLargestSlabCoordinate = 0x1p40;

/// Makes footprints, one after the other, in memory that is used again. Params are checked (std::logic_error).
class SlabFootprints {
 public:
  explicit SlabFootprints(const SlabParams& params = {});

  /// Both: points in px, in any order, y up or down; O(n log n + slabs touched).
  void of_occluder(std::span<const glm::dvec2> points_px, SlabFootprint& out);
  /// Empty if nothing of it is on the screen.
  void of_occludee(std::span<const glm::dvec2> points_px, SlabFootprint& out);

 private:
  void on_lines(std::span<const glm::dvec2> points, SlabFootprint& out);

  SlabParams params_;
  ConvexChains chains_;
  std::vector<glm::dvec2> moved_;
};

/// One alone.
[[nodiscard]] SlabFootprint occluder_footprint(std::span<const glm::dvec2> points_px, const SlabParams& params);
[[nodiscard]] SlabFootprint occludee_footprint(std::span<const glm::dvec2> points_px, const SlabParams& params);

}  // namespace lode::geometry
