#pragma once
/// STL files, ASCII and binary: 3D Systems, "StereoLithography Interface Specification" (1988).

#include <string>

#include "geometry/scene.h"

namespace lode::geometry {

/// One mesh at one node, with three vertices for each facet, in the file's order, and the facets' geometric normals;
/// the file's own normals and attributes are not read. A file is binary if its length is what its count says, else
/// text if it begins with "solid". Throws Error, see model_file.h.
[[nodiscard]] Scene read_stl(const std::string& path);

}  // namespace lode::geometry
