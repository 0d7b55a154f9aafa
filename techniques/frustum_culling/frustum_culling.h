#pragma once
/// Objects whose box lies outside the view are not drawn: what every occlusion culler does first, and what the papers
/// measure themselves against (Clark, "Hierarchical geometric models for visible surface algorithms", CACM 1976).

#include "techniques/objects_in_view.h"
#include "techniques/stage.h"

namespace lode::techniques {

struct FrustumCulling {
  [[nodiscard]] Promise promise() const { return Promise::exact; }
  void prepare(Stage&) {}
  void cut() {}
  Counters draw(const View& view, Stage& stage) {
    const std::vector<ObjectId> inside = objects_in_view(stage.world(), view);
    for (const ObjectId id : inside) stage.object(id);
    return {{"objects_in_view", inside.size()}};
  }
};

}  // namespace lode::techniques
