#include "techniques/masked_occlusion/masked_occlusion.h"

#include "geometry/projected_hull.h"
#include "techniques/masked_occlusion/draw_inner_box.h"
#include "techniques/objects_in_view.h"

namespace lode::techniques {

void MaskedOcclusion::prepare(Stage& stage) {
  const World& world = stage.world();
  areas_ = occluder_areas(world);
  boxes_ = nullptr;
  if (params_.input == Input::triangles) return;
  boxes_ = inner_boxes_of_shapes(world, areas_, params_.boxes, stage.threads());
  for (ObjectId id = 0; id < areas_.size(); ++id) {
    if ((*boxes_)[world.objects()[id].shape].empty()) areas_[id] = 0.0;
  }
}

/// Boxes stand only for objects that lie in front of the near plane: what it cuts away of an object would not hide what
/// its boxes hide.
void MaskedOcclusion::draw_occluder(const View& view, const World& world, ObjectId id, OccluderWork& work) {
  const WorldObject& object = world.objects()[id];
  const glm::dmat4 clip_from_world = geometry::clip_from_world(view.camera, view.size_px);
  if (!boxes_) {
    for (std::uint32_t k = 0; k < object.n_instances; ++k) {
      drawer_.draw(world.draws().draw(object.first_instance + k, clip_from_world), view.size_px, buffer_, work);
    }
    return;
  }
  const auto corners = geometry::corners(object.bounds);
  const auto whole = geometry::project_hull(corners, clip_from_world, glm::dvec2(view.size_px));
  if (whole.near_plane != geometry::NearPlane::in_front) return;
  for (const geometry::Bounds& box : (*boxes_)[object.shape]) {
    draw_inner_box(box, clip_from_world * object.world_from_shape, geometry::mirrors(object.world_from_shape),
                   view.size_px, buffer_, work);
  }
}

Counters MaskedOcclusion::draw(const View& view, Stage& stage) {
  const World& world = stage.world();
  std::vector<ObjectId> inside, occluders;
  {
    const auto timer = stage.time("selection");
    inside = objects_in_view(world, view);
    occluders = choose_occluders(world, view, inside, areas_, params_.occluders);
  }
  const glm::dmat4 clip_from_world = geometry::clip_from_world(view.camera, view.size_px);
  const auto box_of = [&](ObjectId id) {
    return screen_box(clip_from_world, view.size_px, world.objects()[id].bounds);
  };
  std::uint64_t n_hidden = 0, n_read = 0;
  OccluderWork work;
  {
    // Best first, so that the buffer so far can spare the next ones.
    const auto timer = stage.time("occluders");
    buffer_.begin(view.size_px);
    for (const ObjectId id : occluders) {
      const std::optional<ScreenBox> box = box_of(id);
      if (box && buffer_.hides(*box, n_read)) {
        ++n_hidden;
        continue;
      }
      draw_occluder(view, world, id, work);
    }
  }
  // Occluders are tested like all others. Where one of them is the nearest, nothing else hides it: so what hides
  // others is never left out itself.
  const auto timer = stage.time("test");
  std::uint64_t n_tested = 0, n_culled = 0;
  for (const ObjectId id : inside) {
    const std::optional<ScreenBox> box = box_of(id);
    if (box) ++n_tested;
    if (box && buffer_.hides(*box, n_read)) {
      ++n_culled;
    } else {
      stage.object(id);
    }
  }
  return {{"objects_in_view", inside.size()},
          {"occluders", occluders.size()},
          {"tested", n_tested},
          {"culled", n_culled},
          {"occluders_hidden", n_hidden},
          {"triangles", work.triangles},
          {"triangles_drawn", work.drawn},
          {"subtiles_written", work.subtiles},
          {"subtiles_read", n_read}};
}

}  // namespace lode::techniques
