#pragma once
/// A view as a short text, for the keys of kept results.

#include <string>

#include "techniques/technique.h"

namespace lode::experiments {

/// Everything that a view's picture depends on but the scene: "size 640x480; camera ...". Numbers read back as they
/// are.
[[nodiscard]] std::string view_key(const techniques::View& view);

}  // namespace lode::experiments
