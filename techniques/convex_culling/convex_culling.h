#pragma once
/// Occlusion culling with a hierarchical convex approximation of models: Onozawa and Kitazawa (README.md). Each shape
/// is approximated once by a few convex hulls at several levels; at run time the hulls of a few good occluders, on
/// about a hundred slabs of the screen, tell which boxes are hidden (techniques/slab_culling.h).
///
/// What it promises depends on the mode:
///   literal        approximate: as the paper has it. Hulls stick out of models, corners move to slabs, nothing is said
///                  about depth: what is visible may be left out
///   safe           approximate: a hull hides only what is behind all of it. Bulges and slabs remain
///   conservative   no point of the screen is lost: hulls are shrunk into the model until that is proven
///                  (geometry/inner_hulls.h), and slabs are columns

#include "techniques/convex_culling/convex_approximation.h"
#include "techniques/slab_culling.h"

namespace lode::techniques {

class ConvexCulling {
 public:
  enum class Mode : std::uint8_t { literal, safe, conservative };

  static constexpr double kAny = 1e9;  ///< no limit

  struct Params {
    Mode mode = Mode::safe;
    convex_culling::ApproximationParams approximation;  ///< limits empty: 6 % and 13 % of a shape's vertices
    /// Candidates have an A(S) of at least this quantile of all objects', 0…1; the paper pre-selects and does not say
    /// how.
    double least_area_quantile = 0.5;
    double largest_error = 0.1;  ///< and a relative error at the last level of at most this
    /// And hide too much by at most this share of their silhouette, from any of some fixed directions (excess.h): all
    /// hulls of a shape together. Ours.
    double largest_excess = kAny;
    /// Hulls that alone hide too much by more than this share of their own silhouette are left out. Ours.
    double largest_hull_excess = kAny;
    /// And those that do by more than this share hide no other occluder: it is large, and much is lost with it. Ours.
    double largest_occluder_excess = kAny;
    /// Hulls smaller than this share of the model's silhouette, each at its largest, are left out: they hide little and
    /// cost as much as others. Ours.
    double least_hull_size = 0.0;
    SlabCullingParams slabs;  ///< as params_for() has them for the mode
  };
  /// The mode's rules: literal has no depth rule, draws every occluder and moves corners to slabs; safe has the depth
  /// rule, hides an occluder only by hulls of an excess of at most 5 %, and leaves out hulls below 1 %; conservative
  /// has the depth rule, columns, no occluder that the near plane may cut, and, since nothing is lost by it, no angle
  /// limit and 32 occluders.
  [[nodiscard]] static Params params_for(Mode mode);

  ConvexCulling() : ConvexCulling(params_for(Mode::safe)) {}
  explicit ConvexCulling(const Params& params) : params_(params), culling_(params.slabs) {}

  [[nodiscard]] Promise promise() const {
    const bool rules = params_.slabs.depth_rule && params_.slabs.whole_occluders_only &&
                       params_.slabs.slabs == geometry::SlabMode::conservative;
    return params_.mode == Mode::conservative && rules ? Promise::conservative_continuous : Promise::approximate;
  }
  /// Approximates every shape that may occlude, on the stage's threads. O(n log² n) for shapes of n triangles.
  void prepare(Stage& stage);
  void cut() {}
  Counters draw(const View& view, Stage& stage) { return culling_.draw(view, stage); }

 private:
  Params params_;
  SlabCulling culling_;
};

}  // namespace lode::techniques
