#pragma once
/// Meshes of what an OBJ file has.

#include <vector>

#include "geometry/mesh.h"
#include "geometry/model_file/model_files.h"
#include "geometry/model_file/obj/obj_corners.h"
#include "geometry/model_file/obj/obj_materials.h"

namespace lode::geometry {

/// The numbers of a file, that corners index.
struct ObjData {
  std::vector<glm::vec3> positions, normals;
  std::vector<glm::vec4> colors;  ///< of positions: shorter where the last ones have none
  std::vector<glm::vec2> uvs;     ///< as in the file, v up
};

/// A mesh with one vertex for each different (position, texture coordinate, normal), in the order of first use. Corners
/// without a texture coordinate have that of (0, 0), those of triangles without a normal a smooth one. Has no material.
[[nodiscard]] Mesh obj_mesh(const ObjData& data, const std::vector<ObjCorner>& corners, MeshKind kind,
                            const ObjUvs& uvs, ModelFiles& files);

}  // namespace lode::geometry
