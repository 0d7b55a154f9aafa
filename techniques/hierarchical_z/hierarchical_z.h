#pragma once
/// Hierarchical Z for whole objects: Greene, Kass and Miller, "Hierarchical Z-buffer visibility" (SIGGRAPH 1993). Some
/// near and large objects are drawn first, depth only; what lies behind that depth everywhere is left out.
///
/// Promise: conservative at the picture's samples (pixel centres). The depth of the occluders is the renderer's own, at
/// those samples, by the same draws; the picture holds the occluders too, so it is nowhere farther. What is left out
/// can only have fragments strictly farther than that (screen_box.h bounds where they are and how near), and such a
/// fragment loses, order-free or ordered, whatever its id. A picture of other samples (several a pixel) may lose what
/// shows only between the pixels' centres.

#include "raster/image.h"
#include "raster/render.h"
#include "techniques/hierarchical_z/depth_pyramid.h"
#include "techniques/occluder_choice.h"
#include "techniques/stage.h"

namespace lode::techniques {

class HierarchicalZ {
 public:
  struct Params {
    OccluderRule occluders;
    /// Side in pixels of the smallest texel that a test looks at: 1, 2, 4, … 64. Beyond 1, a texel counts as covered
    /// only as far as all its pixels are (inner coverage): less is found hidden, sooner.
    int scale = 1;
  };
  HierarchicalZ() = default;
  explicit HierarchicalZ(const Params& params) : params_(params) {}

  [[nodiscard]] Promise promise() const { return Promise::conservative_sampled; }
  void prepare(Stage& stage) { areas_ = occluder_areas(stage.world()); }
  void cut() {}
  /// objects_in_view, occluders, tested, culled, texels_read. What is culled may be an occluder: one that others hide.
  Counters draw(const View& view, Stage& stage);

 private:
  void draw_depth(const View& view, const Stage& stage, std::span<const ObjectId> occluders);

  Params params_;
  std::vector<double> areas_;  ///< [objects]
  raster::Image depth_;
  raster::FrameMemory memory_;
  DepthPyramid pyramid_;
};

}  // namespace lode::techniques
