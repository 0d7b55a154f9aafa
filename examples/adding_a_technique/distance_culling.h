#pragma once
/// Objects whose box is farther from the eye than a limit are not drawn.

#include "techniques/objects_in_view.h"
#include "techniques/stage.h"

namespace lode::techniques {

struct DistanceCulling {
  double limit = 100.0;  ///< world units

  [[nodiscard]] Promise promise() const { return Promise::approximate; }
  void prepare(Stage&) {}  // once per scene: whatever takes long
  void cut() {}            // forgets what was remembered from frame to frame: nothing
  Counters draw(const View& view, Stage& stage) {
    std::uint64_t n_culled = 0;
    const std::vector<ObjectId> inside = objects_in_view(stage.world(), view);
    for (const ObjectId id : inside) {
      const geometry::Bounds& box = stage.world().objects()[id].bounds;
      const glm::dvec3 nearest = glm::clamp(view.camera.eye, box.low, box.high);
      if (glm::distance(nearest, view.camera.eye) > limit) {
        ++n_culled;
      } else {
        stage.object(id);
      }
    }
    return {{"objects_in_view", inside.size()}, {"culled", n_culled}};
  }
};

}  // namespace lode::techniques
