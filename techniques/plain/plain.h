#pragma once
/// The scene as it is: every object is drawn. What all other techniques are measured against.

#include "techniques/stage.h"

namespace lode::techniques {

struct Plain {
  [[nodiscard]] Promise promise() const { return Promise::exact; }
  void prepare(Stage&) {}
  void cut() {}
  Counters draw(const View&, Stage& stage) {
    for (ObjectId id = 0; id < stage.world().objects().size(); ++id) stage.object(id);
    return {};
  }
};

}  // namespace lode::techniques
