#pragma once
/// Masked software occlusion culling for whole objects: Hasselgren, Andersson and Akenine-Möller, "Masked Software
/// Occlusion Culling" (HPG 2016). The triangles of near and large objects go into a buffer with two depths and a mask
/// for each 8 × 4 samples; what lies behind it everywhere is left out.
///
/// Promise: conservative at the picture's samples (pixel centres). The occluders' triangles cover exactly the samples
/// that the renderer's cover (draw_occluder.h), at a depth that is nowhere nearer than the picture's
/// (screen_triangle.h, masked_depth.h); what is left out can only have fragments strictly farther than that
/// (screen_box.h). Boxes inside the occluders, in the place of their triangles, keep that promise (draw_inner_box.h).

#include "techniques/inner_shapes.h"
#include "techniques/masked_occlusion/draw_occluder.h"
#include "techniques/masked_occlusion/masked_depth.h"
#include "techniques/occluder_choice.h"
#include "techniques/stage.h"

namespace lode::techniques {

class MaskedOcclusion {
 public:
  /// What stands for an occluder: all of its triangles, or a few boxes inside of it.
  enum class Input : std::uint8_t { triangles, inner_boxes };

  struct Params {
    OccluderRule occluders;
    Input input = Input::triangles;
    geometry::InnerBoxesParams boxes;  ///< of that input
  };
  MaskedOcclusion() = default;
  explicit MaskedOcclusion(const Params& params) : params_(params) {}

  [[nodiscard]] Promise promise() const { return Promise::conservative_sampled; }
  void prepare(Stage& stage);
  void cut() {}
  /// objects_in_view, occluders, tested, culled; occluders_hidden (not drawn into the buffer), triangles,
  /// triangles_drawn, subtiles_written, subtiles_read.
  Counters draw(const View& view, Stage& stage);

 private:
  void draw_occluder(const View& view, const World& world, ObjectId id, OccluderWork& work);

  Params params_;
  std::vector<double> areas_;                ///< [objects]
  std::shared_ptr<const ShapeBoxes> boxes_;  ///< none if triangles are drawn
  MaskedDepth buffer_;
  OccluderDrawer drawer_;
};

}  // namespace lode::techniques
