#include "techniques/hierarchical_z/hierarchical_z.h"

#include <bit>

#include "techniques/objects_in_view.h"

namespace lode::techniques {

Counters HierarchicalZ::draw(const View& view, Stage& stage) {
  const World& world = stage.world();
  std::vector<ObjectId> inside, occluders;
  {
    const auto timer = stage.time("selection");
    inside = objects_in_view(world, view);
    occluders = choose_occluders(world, view, inside, areas_, params_.occluders);
  }
  if (occluders.empty()) {  // nothing can be hidden
    for (const ObjectId id : inside) stage.object(id);
    return {{"objects_in_view", inside.size()}, {"occluders", 0}, {"tested", 0}, {"culled", 0}, {"texels_read", 0}};
  }
  {
    const auto timer = stage.time("occluders");
    draw_depth(view, stage, occluders);
    pyramid_.build(depth_.depth, view.size_px, std::countr_zero(unsigned(params_.scale)));
  }
  // Occluders are tested like all others. Where one of them is the nearest, nothing else hides it: so what hides
  // others is never left out itself.
  const auto timer = stage.time("test");
  const glm::dmat4 clip_from_world = geometry::clip_from_world(view.camera, view.size_px);
  std::uint64_t n_tested = 0, n_culled = 0, n_read = 0;
  for (const ObjectId id : inside) {
    const std::optional<ScreenBox> box = screen_box(clip_from_world, view.size_px, world.objects()[id].bounds);
    if (box) ++n_tested;
    if (box && pyramid_.hides(*box, n_read)) {
      ++n_culled;
    } else {
      stage.object(id);
    }
  }
  return {{"objects_in_view", inside.size()},
          {"occluders", occluders.size()},
          {"tested", n_tested},
          {"culled", n_culled},
          {"texels_read", n_read}};
}

void HierarchicalZ::draw_depth(const View& view, const Stage& stage, std::span<const ObjectId> occluders) {
  const World& world = stage.world();
  if (depth_.size_px != view.size_px) {
    depth_ = raster::make_image(view.size_px, color_format(world.color_space()),
                                {.color = false, .depth = true, .ids = false});
  }
  const glm::dmat4 clip_from_world = geometry::clip_from_world(view.camera, view.size_px);
  std::vector<raster::Draw> draws;
  for (const ObjectId id : occluders) {
    const WorldObject& object = world.objects()[id];
    for (std::uint32_t k = 0; k < object.n_instances; ++k) {
      draws.push_back(world.draws().draw(object.first_instance + k, clip_from_world));
    }
  }
  raster::RenderOptions options = stage.render_options();
  options.memory = &memory_;
  static_cast<void>(raster::render({.draws = draws, .clear = {}, .viewport = {}, .scissor = {}}, depth_, options));
}

}  // namespace lode::techniques
