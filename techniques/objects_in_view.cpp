#include "techniques/objects_in_view.h"

#include "geometry/frustum.h"

namespace lode::techniques {

std::vector<ObjectId> objects_in_view(const World& world, const View& view) {
  const geometry::Frustum frustum = geometry::frustum(geometry::clip_from_world(view.camera, view.size_px));
  std::vector<ObjectId> inside;
  for (ObjectId id = 0; id < world.objects().size(); ++id) {
    if (!geometry::is_outside(frustum, world.objects()[id].bounds)) inside.push_back(id);
  }
  return inside;
}

}  // namespace lode::techniques
