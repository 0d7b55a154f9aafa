#pragma once
/// PLY files, ASCII and binary: G. Turk, "The PLY polygon file format" (1994).

#include <string>

#include "geometry/scene.h"

namespace lode::geometry {

/// One mesh at one node: the faces as triangles, or, where a file has vertices alone, points. Throws Error, see
/// model_file.h.
[[nodiscard]] Scene read_ply(const std::string& path);

}  // namespace lode::geometry
