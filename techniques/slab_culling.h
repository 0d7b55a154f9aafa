#pragma once
/// Occlusion culling by convex shapes on slabs, at run time: Onozawa and Kitazawa, "Occlusion culling with a
/// hierarchical convex approximation of models", sec. 3 and alg. 3. A few good occluders are chosen, the convex parts
/// that stand for them are projected, and whatever box is covered by their union, slab by slab, is not drawn. Where the
/// parts come from is the technique's matter: the paper's hulls, hulls shrunk into the model, or boxes inside it.
///
/// In contrast to the paper, the angle between occluder and occludee is computed for the pairs of a frame instead of
/// kept in a graph of all pairs, whose size grows with the square of the scene's; and of several levels only the last
/// one is looked at where it alone decides.

#include <cstdint>
#include <glm/vec3.hpp>
#include <vector>

#include "geometry/projected_hull.h"
#include "geometry/slab_occluders.h"
#include "geometry/slab_test.h"
#include "techniques/occluder_choice.h"
#include "techniques/stage.h"

namespace lode::techniques {

/// Whose shapes count together. per_occluder: an object is hidden if one occluder's parts alone cover it (alg. 3 taken
/// literally); all: if the parts of all do.
enum class Fusion : std::uint8_t { per_occluder, all };

/// Which levels decide. last: the most accurate one alone; any: what any level says is hidden, coarser ones first.
enum class LevelRule : std::uint8_t { last, any };

struct SlabCullingParams {
  /// The paper leaves the three open. No least degree: a ground plane has so large an A(S) that a threshold leaves
  /// little else.
  OccluderRule occluders{.least_degree = 0.0, .most = 16, .far = 0.0};
  /// Between eye → occluder and occluder → occludee, both as the middles of their boxes; 0…180°. The paper: "a
  /// constant". 180: no limit.
  double angle_limit_deg = 60.0;
  /// A part hides only what is nowhere nearer than its farthest point. The paper has no such rule.
  bool depth_rule = true;
  /// Occluders that others hide are left out, too. The paper always draws them. Only with the depth rule: without it
  /// two might hide each other.
  bool test_occluders = true;
  /// An object whose box comes as near as the near plane is no occluder: what the near plane cuts away of it would not
  /// hide what its parts hide.
  bool whole_occluders_only = false;
  Fusion fusion = Fusion::all;
  LevelRule levels = LevelRule::last;
  geometry::SlabMode slabs = geometry::SlabMode::paper;
  int n_slabs = 100;  ///< 1…65536; the paper: "about 100"
};

/// What stands for the objects of one shape: at each level, coarse to fine, convex parts, each by its points in the
/// shape's space. No level, or no part: it hides nothing.
struct OccluderParts {
  std::vector<std::vector<std::vector<glm::vec3>>> levels;
  /// [levels][parts] whether it hides other occluders, too; empty: they all do.
  std::vector<std::vector<std::uint8_t>> hides_occluders;
};

class SlabCulling {
 public:
  SlabCulling() = default;
  explicit SlabCulling(const SlabCullingParams& params);

  /// Once per scene.
  ///   shapes   [World::n_shapes()]
  ///   areas    [objects] A(S) of eq. 4; 0: never an occluder
  void prepare(std::vector<OccluderParts> shapes, std::vector<double> areas);

  /// Draws what is in the view and not found hidden. objects_in_view, occluders, tested, culled; parts, part_points
  /// (projected).
  Counters draw(const View& view, Stage& stage);

 private:
  /// The parts of one occluder, in the order of slab_occluders_: begin…end − 1.
  struct PartsOf {
    ObjectId object;
    std::uint32_t begin, end;
  };
  struct Occludee {
    ObjectId object;
    bool is_occluder;
    double nearest_depth;
    geometry::SlabFootprint footprint;
  };
  void project_occluders(const View& view, const World& world, std::size_t level);
  void add_part(const View& view, const World& world, ObjectId id, const std::vector<glm::vec3>& points,
                bool hides_occluders);
  [[nodiscard]] bool find_occludee(const View& view, const World& world, ObjectId id, Occludee& out);
  [[nodiscard]] bool hidden(const View& view, const World& world, const Occludee& occludee);
  [[nodiscard]] bool may_hide(const View& view, const World& world, ObjectId occluder, ObjectId occludee) const;

  SlabCullingParams params_;
  geometry::SlabParams slab_params_;
  geometry::SlabFootprints footprints_;
  double least_cosine_ = -1.0;
  std::vector<OccluderParts> shapes_;
  std::vector<double> areas_;
  std::size_t n_levels_ = 0;

  // Of one frame.
  glm::dmat4 clip_from_world_{1.0};
  std::vector<ObjectId> occluders_;
  std::vector<PartsOf> parts_of_;
  std::vector<double> farthest_depth_;         ///< [parts]
  std::vector<std::uint8_t> hides_occluders_;  ///< [parts]
  geometry::SlabOccluders slab_occluders_;
  std::vector<std::uint8_t> counts_;  ///< [parts]
  std::uint64_t n_points_ = 0, n_parts_ = 0;
  geometry::ProjectedHull projected_;
  geometry::SlabFootprint footprint_;
};

}  // namespace lode::techniques
