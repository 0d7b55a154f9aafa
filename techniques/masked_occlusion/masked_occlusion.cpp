#include "techniques/masked_occlusion/masked_occlusion.h"

#include <algorithm>

#include "raster/fp_environment.h"
#include "techniques/objects_in_view.h"

namespace lode::techniques {
namespace {

struct Placed {
  ObjectId id;
  std::optional<ScreenBox> box;
};

/// [shapes]; those of shapes that hide nothing are empty.
std::vector<StandIn> hulls_of(const World& world) {
  std::vector<StandIn> hulls;
  for (std::uint32_t k = 0; k < world.n_shapes(); ++k) {
    const Shape shape = world.shape(k);
    hulls.push_back(shape.hides ? hull_of(shape) : StandIn{});
  }
  return hulls;
}

/// The working layer keeps more in this order, and the buffer so far can spare the next ones. What reaches the near
/// plane comes first; ties by id.
template <class BoxOf>
std::vector<Placed> nearest_first(std::span<const ObjectId> ids, const BoxOf& box_of) {
  std::vector<Placed> placed;
  for (const ObjectId id : ids) placed.push_back({id, box_of(id)});
  const auto nearest = [](const Placed& p) { return p.box ? p.box->nearest : 2.0f; };
  std::sort(placed.begin(), placed.end(), [&](const Placed& a, const Placed& b) {
    return nearest(a) != nearest(b) ? nearest(a) > nearest(b) : a.id < b.id;
  });
  return placed;
}

}  // namespace

void MaskedOcclusion::prepare(Stage& stage) {
  const World& world = stage.world();
  areas_ = occluder_areas(world);
  if (params_.shape == MaskedShape::hulls) {
    hulls_ = world.once<std::vector<StandIn>>("masked_occlusion: hulls", [&] { return hulls_of(world); });
  }
  if (params_.shape == MaskedShape::inner_boxes) {
    boxes_ = inner_boxes_of_shapes(world, areas_, params_.boxes, stage.threads());
    for (ObjectId id = 0; id < areas_.size(); ++id) {
      if ((*boxes_)[world.objects()[id].shape].empty()) areas_[id] = 0.0;
    }
  }
}

Counters MaskedOcclusion::draw(const View& view, Stage& stage) {
  const raster::FpEnvironment ieee;  // the renderer's: vertices have to be the same to the bit
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
  std::uint64_t n_hidden = 0;
  OccluderWork work;
  {
    const auto timer = stage.time("occluders");
    buffer_.begin(view.size_px);
    for (const auto& [id, box] : nearest_first(occluders, box_of)) {
      if (box && buffer_.hides(*box, work.subtiles_read)) {
        ++n_hidden;
      } else {
        draw_occluder(view, stage, id, box, work);
      }
    }
  }
  // Occluders are tested like all others. Where one of them is the nearest, nothing else hides it: so what hides
  // others is never left out itself.
  const auto timer = stage.time("test");
  std::uint64_t n_tested = 0, n_culled = 0;
  for (const ObjectId id : inside) {
    const OnScreen box = box_of(id);
    if (box) ++n_tested;
    if (box && buffer_.hides(*box, work.subtiles_read)) {
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
          {"subtiles_written", work.subtiles_written},
          {"subtiles_read", work.subtiles_read}};
}

/// A stand-in is drawn only for an object that lies wholly beyond the near plane: where that cuts a model open, the
/// picture shows what is behind it, and the stand-in would hide it.
void MaskedOcclusion::draw_occluder(const View& view, const Stage& stage, ObjectId id, const OnScreen& box,
                                    OccluderWork& work) {
  const World& world = stage.world();
  const glm::dmat4 clip_from_world = geometry::clip_from_world(view.camera, view.size_px);
  const WorldObject& object = world.objects()[id];
  if (params_.shape == MaskedShape::meshes) {
    for (std::uint32_t k = 0; k < object.n_instances; ++k) {
      drawer_.draw(world.draws().draw(object.first_instance + k, clip_from_world), view.size_px,
                   stage.render_options().target, buffer_, work);
    }
    return;
  }
  if (!box) return;
  StandIn boxes;
  if (params_.shape == MaskedShape::inner_boxes) {
    const glm::dvec3 inset = inset_of(view, object.bounds, object.world_from_shape);
    for (const geometry::Bounds& inner : (*boxes_)[object.shape]) add_box(inner, inset, boxes);
  }
  const StandIn& stand_in = params_.shape == MaskedShape::hulls ? (*hulls_)[object.shape] : boxes;
  drawer_.draw(stand_in_draw(stand_in, clip_from_world, object.world_from_shape), view.size_px,
               stage.render_options().target, buffer_, work);
}

}  // namespace lode::techniques
