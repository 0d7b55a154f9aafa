#pragma once
/// Wavefront OBJ files: "Advanced Visualizer", appendix B1, as far as polygons, lines and points go.

#include <string>

#include "geometry/scene.h"

namespace lode::geometry {

/// A node for each object (o) and group (g) that has elements, in the order of the first one; at it a mesh for each
/// material and kind of element, likewise. Throws Error, see model_file.h; it names the line.
[[nodiscard]] Scene read_obj(const std::string& path);

}  // namespace lode::geometry
