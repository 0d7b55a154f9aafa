#pragma once
/// Masked software occlusion culling for whole objects: Hasselgren, Andersson and Akenine-Möller, "Masked Software
/// Occlusion Culling" (HPG 2016). The triangles of near and large objects go into a buffer with two depths and a mask
/// for each 8 × 4 samples; what lies behind it everywhere is left out.
///
/// Promise: conservative at the picture's samples (pixel centres). The occluders' triangles cover exactly the samples
/// that the renderer's cover (draw_occluder.h), at a depth that is nowhere nearer than the picture's
/// (screen_triangle.h, masked_depth.h); what is left out can only have fragments strictly farther than that
/// (screen_box.h). Inner boxes keep the promise for models that are closed (stand_ins.h). With hulls in the models'
/// place it is approximate: hulls cover what the models leave free.

#include <memory>

#include "techniques/inner_shapes.h"
#include "techniques/masked_occlusion/draw_occluder.h"
#include "techniques/masked_occlusion/masked_depth.h"
#include "techniques/masked_occlusion/stand_ins.h"
#include "techniques/occluder_choice.h"
#include "techniques/screen_box.h"
#include "techniques/stage.h"

namespace lode::techniques {

/// What is drawn into the buffer for an occluder.
enum class MaskedShape : std::uint8_t {
  meshes,      ///< the object's own triangles
  hulls,       ///< its convex hull
  inner_boxes  ///< boxes inside it, where it is closed (inner_shapes.h)
};

class MaskedOcclusion {
 public:
  struct Params {
    OccluderRule occluders;
    MaskedShape shape = MaskedShape::meshes;
    geometry::InnerBoxesParams boxes = {};  ///< with MaskedShape::inner_boxes
  };
  MaskedOcclusion() = default;
  explicit MaskedOcclusion(Params params) : params_(std::move(params)) {}

  [[nodiscard]] Promise promise() const {
    return params_.shape == MaskedShape::hulls ? Promise::approximate : Promise::conservative_sampled;
  }
  void prepare(Stage& stage);
  void cut() {}
  /// objects_in_view, occluders, tested, culled; occluders_hidden (not drawn into the buffer), triangles,
  /// triangles_drawn, subtiles_written, subtiles_read.
  Counters draw(const View& view, Stage& stage);

 private:
  using OnScreen = std::optional<ScreenBox>;
  void draw_occluder(const View& view, const Stage& stage, ObjectId id, const OnScreen& box, OccluderWork& work);

  Params params_;
  std::vector<double> areas_;                          ///< [objects]
  std::shared_ptr<const std::vector<StandIn>> hulls_;  ///< [shapes] with MaskedShape::hulls
  std::shared_ptr<const ShapeBoxes> boxes_;            ///< [shapes] with MaskedShape::inner_boxes
  MaskedDepth buffer_;
  OccluderDrawer drawer_;
};

}  // namespace lode::techniques
