#pragma once
/// A mesh primitive: one array of triangles, lines or points with one material, as a file has it. Strips, fans and
/// polygons have become lists when a mesh is made; primitive k is the k-th of the list, degenerate ones included.

#include <cstddef>
#include <cstdint>
#include <glm/vec2.hpp>
#include <glm/vec3.hpp>
#include <glm/vec4.hpp>
#include <optional>
#include <vector>

namespace lode::geometry {

enum class MeshKind : std::uint8_t { triangles, lines, points };

/// Corners of one primitive: 3, 2, 1.
[[nodiscard]] constexpr std::size_t corners_per_primitive(MeshKind kind) {
  return kind == MeshKind::triangles ? 3 : (kind == MeshKind::lines ? 2 : 1);
}

struct Mesh {
  MeshKind kind = MeshKind::triangles;
  std::vector<glm::vec3> positions;    ///< [n], object space, finite
  std::vector<std::uint32_t> indices;  ///< [corners_per_primitive · primitives], each < n

  // Per vertex; each empty or [n].
  std::vector<glm::vec3> normals;  ///< object space, of any length; (0,0,0) where a file has none
  std::vector<glm::vec2> uvs;      ///< of the material's colour texture; v = 0 is the picture's top row
  std::vector<glm::vec4> colors;   ///< linear, straight alpha, multiplied into the material's colour

  std::optional<std::uint32_t> material;  ///< index in Scene::materials; nothing: the default material

  [[nodiscard]] std::size_t n_primitives() const { return indices.size() / corners_per_primitive(kind); }
};

/// A copy with one vertex a corner and each triangle's geometric normal, (0,0,0) where it has no area. glTF 2.0,
/// sec. 3.7.2.1, asks for this where a file has no normals. Only for triangles.
[[nodiscard]] Mesh with_flat_normals(const Mesh& mesh);

/// A copy in which every vertex without a normal, or with (0,0,0), has one: at each corner the sum of the normals,
/// weighted by area, of the triangles at its position that are turned from its own by at most 60°, of unit length. So
/// creases stay sharp, and a surface that is there twice, once from either side, does not cancel. A vertex whose
/// corners differ becomes several. Vertices at bitwise equal positions are one; where more than 256 corners meet, each
/// has its triangle's own normal; (0,0,0) where a triangle has no area. Only for triangles. Deterministic: sums run in
/// index order, in double.
[[nodiscard]] Mesh with_smooth_normals(const Mesh& mesh);

}  // namespace lode::geometry
