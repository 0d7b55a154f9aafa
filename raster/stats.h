#pragma once
/// Deterministic work counters of one render: the same for any number of threads and any instruction set. What they
/// count is part of the tests, so that skipped work cannot hide in a noisy clock.

#include <cstdint>

namespace lode::raster {

struct FrameStats {
  std::uint64_t draws_in = 0;
  std::uint64_t draws_culled_frustum = 0;   ///< clustered ones whose box is not in the view
  std::uint64_t draws_ordered = 0;          ///< those that run in submission order after the order-free ones
  std::uint64_t primitives_in = 0;          ///< a quad is two: its triangles
  std::uint64_t primitives_not_finite = 0;  ///< discarded: a NaN in a vertex
  std::uint64_t primitives_outside = 0;     ///< nothing left after clipping
  std::uint64_t primitives_facing = 0;      ///< culled by facing
  std::uint64_t primitives_empty = 0;       ///< zero area after the snap, radius ≤ 0, no length
  std::uint64_t primitives_clipped = 0;     ///< cut by at least one plane
  // Of the fast pipeline's clusters, tile by tile: a box that touches two tiles counts twice.
  std::uint64_t boxes_tested = 0;   ///< of clusters and of groups of them
  std::uint64_t boxes_outside = 0;  ///< not in the view, or not in the tile
  std::uint64_t boxes_facing = 0;   ///< all triangles face away
  std::uint64_t boxes_hidden = 0;   ///< behind what was drawn already
  std::uint64_t clusters_drawn = 0;
  std::uint64_t triangles_in = 0;  ///< of those clusters
  std::uint64_t triangles_without_sample = 0;
  std::uint64_t triangles_facing = 0;
  std::uint64_t triangles_empty = 0;
  std::uint64_t triangles_rasterized = 0;  ///< pieces among them
  std::uint64_t blocks_touched = 0;        ///< 4×4 of triangles up to 64 px, 8×8 of larger ones
  std::uint64_t blocks_outside = 0;        ///< in a triangle's box, but not in the triangle
  std::uint64_t blocks_hidden = 0;

  std::uint64_t pieces = 0;  ///< triangles, lines, … left after culling and clipping, in the target or beside it
  std::uint64_t tiles = 0;   ///< tiles that the bounds of any piece, or of a clustered draw, touch
  /// Samples inside a primitive and the scissor; those of skipped blocks, and of a triangle up to 64 px those behind
  /// what was nearer than all of it, are not looked at and not counted.
  std::uint64_t fragments_covered = 0;
  std::uint64_t fragments_alpha_failed = 0;
  /// Covered, but something nearer was there. Of clustered triangles up to 4×16 px, which are drawn many at a time in no
  /// order, something at all.
  std::uint64_t fragments_depth_failed = 0;
  std::uint64_t fragments_shaded = 0;  ///< shader results computed, alpha tests included
  std::uint64_t fragments_blended = 0;
  std::uint64_t texels_read = 0;

  FrameStats& operator+=(const FrameStats& other);
};

/// Calls visit(name, value) for every counter, in the order above.
template <class Visit>
void for_each_counter(const FrameStats& s, Visit visit) {
  visit("draws_in", s.draws_in);
  visit("draws_culled_frustum", s.draws_culled_frustum);
  visit("draws_ordered", s.draws_ordered);
  visit("primitives_in", s.primitives_in);
  visit("primitives_not_finite", s.primitives_not_finite);
  visit("primitives_outside", s.primitives_outside);
  visit("primitives_facing", s.primitives_facing);
  visit("primitives_empty", s.primitives_empty);
  visit("primitives_clipped", s.primitives_clipped);
  visit("boxes_tested", s.boxes_tested);
  visit("boxes_outside", s.boxes_outside);
  visit("boxes_facing", s.boxes_facing);
  visit("boxes_hidden", s.boxes_hidden);
  visit("clusters_drawn", s.clusters_drawn);
  visit("triangles_in", s.triangles_in);
  visit("triangles_without_sample", s.triangles_without_sample);
  visit("triangles_facing", s.triangles_facing);
  visit("triangles_empty", s.triangles_empty);
  visit("triangles_rasterized", s.triangles_rasterized);
  visit("blocks_touched", s.blocks_touched);
  visit("blocks_outside", s.blocks_outside);
  visit("blocks_hidden", s.blocks_hidden);
  visit("pieces", s.pieces);
  visit("tiles", s.tiles);
  visit("fragments_covered", s.fragments_covered);
  visit("fragments_alpha_failed", s.fragments_alpha_failed);
  visit("fragments_depth_failed", s.fragments_depth_failed);
  visit("fragments_shaded", s.fragments_shaded);
  visit("fragments_blended", s.fragments_blended);
  visit("texels_read", s.texels_read);
}

/// Of one draw: samples covered (after culling and alpha test, before depth), and samples visible: owned at
/// the end, or for draws that blend or write no depth, samples that passed the depth test.
struct DrawStats {
  std::uint64_t covered = 0;
  std::uint64_t visible = 0;
};

}  // namespace lode::raster
