#pragma once
/// A picture of where two pictures differ.

#include "experiments/compare/stored_picture.h"

namespace lode::experiments {

/// Black where equal. Colours: 64 + 191·d/255 for a channel's difference d, so that 1 is seen; depth and ids: white
/// where they differ. Of pictures of one kind and size.
[[nodiscard]] ColorPlane difference_map(const StoredPicture& a, const StoredPicture& b);

}  // namespace lode::experiments
