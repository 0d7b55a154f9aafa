#include "techniques/inner_boxes/inner_boxes.h"

#include "geometry/projected_hull.h"
#include "techniques/inner_shapes.h"

namespace lode::techniques {

SlabCullingParams InnerBoxes::default_slabs() {
  SlabCullingParams slabs;
  slabs.occluders.most = 32;
  slabs.angle_limit_deg = 180.0;  // nothing is lost without one
  slabs.depth_rule = true;
  slabs.whole_occluders_only = true;
  slabs.slabs = geometry::SlabMode::conservative;
  return slabs;
}

/// Corners are rounded to floats: by much less than what the boxes were made smaller by.
void InnerBoxes::prepare(Stage& stage) {
  std::vector<double> areas = occluder_areas(stage.world());
  const auto found = inner_boxes_of_shapes(stage.world(), areas, params_.boxes, stage.threads());
  const ShapeBoxes& boxes = *found;
  std::vector<OccluderParts> shapes(boxes.size());
  n_boxes_ = 0;
  for (std::size_t i = 0; i < boxes.size(); ++i) {
    if (boxes[i].empty()) continue;
    auto& level = shapes[i].levels.emplace_back();
    for (const geometry::Bounds& box : boxes[i]) {
      const auto corners = geometry::corners(box);
      level.emplace_back(corners.begin(), corners.end());
    }
    n_boxes_ += boxes[i].size();
  }
  culling_.prepare(std::move(shapes), std::move(areas));
}

Counters InnerBoxes::draw(const View& view, Stage& stage) {
  Counters counters = culling_.draw(view, stage);
  counters.push_back({"boxes", n_boxes_});
  return counters;
}

}  // namespace lode::techniques
