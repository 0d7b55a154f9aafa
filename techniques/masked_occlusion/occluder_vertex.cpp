#include "techniques/masked_occlusion/occluder_vertex.h"

#include <algorithm>

#include "raster/reference/primitive.h"

namespace lode::techniques {

namespace reference = raster::reference;

ToScreen::ToScreen(const glm::dmat4& clip_from_object, glm::ivec2 size_px)
    : clip_from_object_(clip_from_object), viewport_(reference::make_viewport({{0, 0}, size_px})) {
  for (int axis = 0; axis < 2; ++axis) {
    const double half_fx8 = std::max(viewport_.half_fx8[axis], 1.0);
    reach_[axis] = 0.5 * double{reference::kGuard_fx8} / half_fx8 - 1.0;  // the centre is half a picture from 0
  }
}

OccluderVertex ToScreen::anywhere(const glm::vec3& p) const {
  const raster::Vertices vertices = raster::ObjectVertices{{&p, 1}, clip_from_object_};
  OccluderVertex v;
  v.clip = reference::clip_position(vertices, 0);
  v.outside = reference::has_nan(v.clip) ? kNotANumber : reference::outside_planes(viewport_, v.clip);
  if (v.outside != 0) return v;
  const reference::WindowVertex window = reference::window_vertex(viewport_, v.clip);
  v.p_fx8 = window.p_fx8;
  v.z = window.z;
  return v;
}

}  // namespace lode::techniques
