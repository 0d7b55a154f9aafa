#pragma once
/// MTL files, the materials of OBJ: Wavefront's "Advanced Visualizer", appendix B1, as far as Material holds it.

#include <glm/vec2.hpp>
#include <glm/vec3.hpp>
#include <optional>
#include <string>
#include <vector>

#include "geometry/model_file/model_files.h"

namespace lode::geometry {

/// A picture with the options that stand before its name.
struct MtlMap {
  std::string path;                    ///< beside the MTL file, unless it is absolute; backslashes have become slashes
  std::string place;                   ///< for messages: "a.mtl: line 7"
  glm::dvec2 offset{0.0}, scale{1.0};  ///< -o and -s: of the coordinates, v up, scaled first
  bool clamp = false;                  ///< -clamp on
};

struct MtlMaterial {
  std::string name;
  glm::vec3 color{1.0f};                         ///< Kd
  float opacity = 1.0f;                          ///< d, or 1 − Tr if there is no d
  std::optional<MtlMap> color_map, opacity_map;  ///< map_Kd, map_d
};

/// The materials of a file, in its order; a later one of the same name comes later. Throws Error (bad_input), naming
/// the line.
[[nodiscard]] std::vector<MtlMaterial> read_mtl(ModelFiles& files, const std::string& path,
                                                const std::string& referrer);

}  // namespace lode::geometry
