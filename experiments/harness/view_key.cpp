#include "experiments/harness/view_key.h"

#include "experiments/parameter.h"

namespace lode::experiments {

std::string view_key(const techniques::View& view) {
  const geometry::Camera& c = view.camera;
  std::string key = "size " + std::to_string(view.size_px.x) + "x" + std::to_string(view.size_px.y) + "; camera " +
                    std::to_string(int(c.projection));
  for (const glm::dvec3& v : {c.eye, c.right, c.up, c.back}) {
    for (int axis = 0; axis < 3; ++axis) key += " " + number_text(v[axis]);
  }
  for (const double v : {c.tan_half_fov_y, c.height, c.near, c.far, view.time_s}) key += " " + number_text(v);
  return key;
}

}  // namespace lode::experiments
