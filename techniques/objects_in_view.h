#pragma once
/// The first step of every culler: what may be in the view at all.

#include <vector>

#include "techniques/technique.h"
#include "techniques/world.h"

namespace lode::techniques {

/// The objects whose boxes are not surely outside the view, in ascending order. Rounding is on the safe side: an object
/// that is left out has no sample in any picture of this view.
[[nodiscard]] std::vector<ObjectId> objects_in_view(const World& world, const View& view);

}  // namespace lode::techniques
