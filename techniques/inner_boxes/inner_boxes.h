#pragma once
/// Occlusion culling by boxes inside the occluders, on slabs (README.md): the run time of convex culling
/// (techniques/slab_culling.h) with other occluder shapes, so that the two can be compared by shape alone.
///
/// Promise: conservative at every point of the screen. The boxes are proven to lie in the occluders (geometry/solid.h),
/// slabs are columns (geometry/slab_test.h), a box hides only what is behind all of it, and an object whose box reaches
/// the near plane is no occluder.

#include "geometry/inner_boxes.h"
#include "techniques/slab_culling.h"

namespace lode::techniques {

class InnerBoxes {
 public:
  struct Params {
    geometry::InnerBoxesParams boxes;
    SlabCullingParams slabs = default_slabs();  ///< of which the promise needs the three that default_slabs() sets
  };
  [[nodiscard]] static SlabCullingParams default_slabs();

  InnerBoxes() : InnerBoxes(Params{}) {}
  explicit InnerBoxes(const Params& params) : params_(params), culling_(params.slabs) {}

  [[nodiscard]] Promise promise() const { return Promise::conservative_continuous; }
  /// Finds boxes in every shape that may occlude, on the stage's threads.
  void prepare(Stage& stage);
  void cut() {}
  /// Counters: slab_culling.h; and `boxes`, of all shapes together.
  Counters draw(const View& view, Stage& stage);

 private:
  Params params_;
  SlabCulling culling_;
  std::uint64_t n_boxes_ = 0;
};

}  // namespace lode::techniques
