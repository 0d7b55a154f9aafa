#include "techniques/mesh_lod/mesh_lod.h"

#include <algorithm>
#include <glm/common.hpp>
#include <glm/geometric.hpp>
#include <limits>

#include "techniques/objects_in_view.h"

namespace lode::techniques {

void MeshLod::prepare(Stage& stage) {
  const World& world = stage.world();
  levels_ = mesh_levels(world, params_.shares, stage.threads());
  errors_.assign(world.objects().size(), {});
  for (ObjectId id = 0; id < errors_.size(); ++id) {
    const WorldObject& object = world.objects()[id];
    for (std::uint32_t i = object.first_instance; i < object.first_instance + object.n_instances; ++i) {
      const geometry::Instance& instance = world.scene().instances[i];
      const double scale = largest_scale(instance.world_from_object);
      for (std::size_t k = 0; k < kMeshLevels; ++k) {
        errors_[id][k] = std::max(errors_[id][k], scale * levels_->of_mesh[instance.mesh][k].error);
      }
    }
  }
}

int MeshLod::level_for(const std::array<double, kMeshLevels>& errors, double pixels_per_unit) const {
  if (params_.level > 0) return params_.level;
  for (int level = kMeshLevels; level > 0; --level) {
    if (errors[std::size_t(level - 1)] * pixels_per_unit < params_.pixels) return level;
  }
  return 0;
}

Counters MeshLod::draw(const View& view, Stage& stage) {
  const World& world = stage.world();
  std::uint64_t n_at[kMeshLevels + 1] = {};
  const std::vector<ObjectId> inside = objects_in_view(world, view);
  for (const ObjectId id : inside) {
    const WorldObject& object = world.objects()[id];
    const int level = level_for(errors_[id], pixels_per_unit(view, object.bounds));
    meshes_.assign(object.n_instances, nullptr);
    bool simpler = false;
    for (std::uint32_t k = 0; level > 0 && k < object.n_instances; ++k) {
      const std::uint32_t mesh = world.scene().instances[object.first_instance + k].mesh;
      const MeshLevel& shown = levels_->of_mesh[mesh][std::size_t(level - 1)];
      if (!shown.alternate) continue;
      meshes_[k] = &*shown.alternate;
      simpler = true;
    }
    stage.stand_in(id, meshes_);
    ++n_at[simpler ? level : 0];
  }
  return {{"objects_in_view", inside.size()},
          {"level0", n_at[0]},
          {"level1", n_at[1]},
          {"level2", n_at[2]},
          {"level3", n_at[3]},
          {"primitives_drawn", stage.work().primitives + stage.work().stand_in_primitives},
          {"extra_bytes", levels_->bytes}};
}

double pixels_per_unit(const View& view, const geometry::Bounds& box) {
  const double height = 2.0 * geometry::half_extent(view.camera, view.size_px).y;  // at distance 1, or anywhere
  const double at_one = double(view.size_px.y) / height;
  if (view.camera.projection == geometry::Projection::orthographic) return at_one;
  const double distance = glm::distance(glm::clamp(view.camera.eye, box.low, box.high), view.camera.eye);
  return distance > 0.0 ? at_one / distance : std::numeric_limits<double>::infinity();
}

}  // namespace lode::techniques
