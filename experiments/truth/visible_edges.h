#pragma once
/// How long the visible edges of a picture are, and how many samples may differ along them.
///
/// An edge is where the nearest triangle changes. By Crofton's formula its length is π/4 times the number of crossings
/// with the horizontal and the vertical lines of a grid, times the grid's spacing, for edges in every direction alike.
/// Crossings closer than the spacing are missed, so the figure is a lower bound; the grid is refined where it matters.
///
/// A snap moves an outline by at most δ = √2/2 · 1/256 px, so that samples it may pass over lie in a band of width 2δ
/// around the edges, and among samples that do not care where edges run there are about 2δ · length.

#include <cstdint>
#include <functional>
#include <glm/vec2.hpp>
#include <span>
#include <vector>

#include "raster/image.h"

namespace lode::experiments::truth {

inline constexpr double kEdgeBand_px = 2.0 * 0.70710678118654752 / 256.0;  ///< 2δ

inline constexpr std::uint64_t kMaxEdgeRays = 1u << 21;

struct VisibleEdges {
  double length_px = 0.0;
  int grid = 1;  ///< lines a pixel, a power of two: what it took to reach the length that was asked for, or the finest
};

/// Ids at a point of the picture, in pixels; thread-safe.
using IdsAt = std::function<raster::Ids(glm::dvec2)>;

/// Measures on the pixels' own grid and, as long as the length is below `enough_px`, on ever finer ones of up to 16
/// lines a pixel around the pixels that differ from a neighbour and around those of `also`. At least the length on the
/// pixels' own grid.
///   ids   [w·h] at the pixels' centres
[[nodiscard]] VisibleEdges visible_edges(glm::ivec2 size_px, std::span<const raster::Ids> ids,
                                         std::span<const glm::ivec2> also, double enough_px, const IdsAt& ids_at,
                                         int threads);

}  // namespace lode::experiments::truth
