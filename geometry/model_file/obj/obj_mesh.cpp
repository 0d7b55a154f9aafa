#include "geometry/model_file/obj/obj_mesh.h"

#include <algorithm>
#include <utility>

namespace lode::geometry {
namespace {

/// What one corner may take until its mesh is made: a slot of the table, vertex, index, and smooth normals.
constexpr std::size_t kCornerBytes = 208;

void set_normals(Mesh& mesh, const ObjData& data, const std::vector<ObjCorner>& vertices) {
  const auto has_normal = [](const ObjCorner& c) { return c.normal != ObjCorner::kNone; };
  if (std::none_of(vertices.begin(), vertices.end(), has_normal)) return;
  for (const ObjCorner& c : vertices) {
    mesh.normals.push_back(has_normal(c) ? data.normals[c.normal] : glm::vec3(0.0f));
  }
}

void set_uvs(Mesh& mesh, const ObjData& data, const std::vector<ObjCorner>& vertices, const ObjUvs& uvs) {
  const auto has_uv = [](const ObjCorner& c) { return c.uv != ObjCorner::kNone; };
  if (std::none_of(vertices.begin(), vertices.end(), has_uv)) return;
  for (const ObjCorner& c : vertices) mesh.uvs.push_back(uvs(has_uv(c) ? data.uvs[c.uv] : glm::vec2(0.0f)));
}

void set_colors(Mesh& mesh, const ObjData& data, const std::vector<ObjCorner>& vertices) {
  const auto has_color = [&](const ObjCorner& c) { return c.position < data.colors.size(); };
  if (std::none_of(vertices.begin(), vertices.end(), has_color)) return;
  for (const ObjCorner& c : vertices) mesh.colors.push_back(has_color(c) ? data.colors[c.position] : glm::vec4(1.0f));
}

}  // namespace

Mesh obj_mesh(const ObjData& data, const std::vector<ObjCorner>& corners, MeshKind kind, const ObjUvs& uvs,
              ModelFiles& files) {
  files.budget.take(kCornerBytes * corners.size(), files.model_path());
  UniqueCorners vertices = unique_corners(corners);
  Mesh mesh;
  mesh.kind = kind;
  mesh.indices = std::move(vertices.indices);
  mesh.positions.reserve(vertices.unique.size());
  for (const ObjCorner& c : vertices.unique) mesh.positions.push_back(data.positions[c.position]);
  set_normals(mesh, data, vertices.unique);
  set_uvs(mesh, data, vertices.unique, uvs);
  set_colors(mesh, data, vertices.unique);
  const bool all = !mesh.normals.empty() && std::none_of(mesh.normals.begin(), mesh.normals.end(),
                                                         [](const glm::vec3& n) { return n == glm::vec3(0.0f); });
  return kind == MeshKind::triangles && !all ? with_smooth_normals(mesh) : mesh;
}

}  // namespace lode::geometry
