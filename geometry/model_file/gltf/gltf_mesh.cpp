#include "geometry/model_file/gltf/gltf_mesh.h"

#include <cmath>
#include <numeric>
#include <string>
#include <utility>

#include "geometry/model_file/gltf/gltf_accessor.h"

namespace lode::geometry {
namespace {

/// Primitive modes, in the order of their numbers.
enum class Mode { points, lines, line_loop, line_strip, triangles, triangle_strip, triangle_fan };

MeshKind kind_of(Mode mode) {
  if (mode == Mode::points) return MeshKind::points;
  return mode <= Mode::line_strip ? MeshKind::lines : MeshKind::triangles;
}

/// Vertices that a list is made of, k-th primitive first corner first. Sec. 3.7.2.1.
std::vector<std::uint32_t> as_list(Mode mode, const std::vector<std::uint32_t>& v) {
  std::vector<std::uint32_t> list;
  const std::size_t n = v.size();
  switch (mode) {
    case Mode::line_strip:
    case Mode::line_loop:
      list.reserve(2 * n);
      for (std::size_t i = 0; i + 1 < n; ++i) list.insert(list.end(), {v[i], v[i + 1]});
      if (mode == Mode::line_loop) list.insert(list.end(), {v[n - 1], v[0]});
      break;
    case Mode::triangle_strip:
      list.reserve(3 * n);
      for (std::size_t i = 0; i + 2 < n; ++i) list.insert(list.end(), {v[i], v[i + 1 + i % 2], v[i + 2 - i % 2]});
      break;
    default:  // a fan
      list.reserve(3 * n);
      for (std::size_t i = 0; i + 2 < n; ++i) list.insert(list.end(), {v[i + 1], v[i + 2], v[0]});
      break;
  }
  return list;
}

/// Where a primitive's vertices are counted, for messages: its indices, or its positions.
std::vector<std::uint32_t> read_list(GltfDocument& document, const JsonView& view, Mode mode, std::size_t n_vertices) {
  std::vector<std::uint32_t> v;
  if (const auto indices = view.find("indices")) {
    v = read_indices(document, *indices, n_vertices);
  } else {
    document.files().budget.take(4 * n_vertices, view.place());
    v.resize(n_vertices);
    std::iota(v.begin(), v.end(), 0u);
  }
  const std::size_t n_corners = corners_per_primitive(kind_of(mode));
  const bool is_list = mode == Mode::points || mode == Mode::lines || mode == Mode::triangles;
  if (v.size() < n_corners)
    view.fail(std::to_string(v.size()) + " vertices: expected at least " + std::to_string(n_corners));
  if (!is_list) {
    document.files().budget.take(4 * n_corners * v.size(), view.place());
    return as_list(mode, v);
  }
  if (v.size() % n_corners != 0) {
    view.fail(std::to_string(v.size()) + " vertices: expected a multiple of " + std::to_string(n_corners));
  }
  return v;
}

void check_finite(const std::vector<glm::vec3>& positions, const JsonView& reference) {
  // x − x is 0, or NaN for what is not finite: a sum that vectorizes decides for nearly all files.
  float sum = 0.0f;
  for (const glm::vec3& p : positions) sum += (p.x - p.x) + (p.y - p.y) + (p.z - p.z);
  if (sum == 0.0f) return;
  std::size_t i = 0;
  while (std::isfinite(positions[i].x) && std::isfinite(positions[i].y) && std::isfinite(positions[i].z)) ++i;
  reference.fail("accessors[" + std::to_string(reference.integer(0, std::int64_t(1) << 40)) + "], element " +
                 std::to_string(i) + ": a position that is not finite");
}

/// One value a vertex.
template <class Values>
Values checked_count(Values values, std::size_t n, const JsonView& reference) {
  if (values.size() == n) return values;
  reference.fail(std::to_string(values.size()) + " elements: expected " + std::to_string(n) +
                 ", one for each position");
}

std::vector<glm::vec2> read_uvs(GltfDocument& document, const JsonView& attributes, const UvSource& source,
                                std::size_t n) {
  const JsonView reference = attributes.require("TEXCOORD_" + std::to_string(source.set));
  std::vector<glm::vec2> uvs = checked_count(read_vec2(document, reference), n, reference);
  if (source.uv_from_set) {
    for (glm::vec2& uv : uvs) uv = glm::vec2(*source.uv_from_set * glm::dvec3(uv, 1.0));
  }
  return uvs;
}

std::vector<glm::vec4> read_colors(GltfDocument& document, const JsonView& reference, std::size_t n) {
  const AccessorLayout layout = accessor_layout(document, reference);
  if (layout.component_type != 5126 && !layout.normalized) layout.view.fail("a colour: expected floats, or normalized");
  if (layout.n_components == 4) return checked_count(read_vec4(document, reference), n, reference);
  const std::vector<glm::vec3> opaque = checked_count(read_vec3(document, reference), n, reference);
  document.files().budget.take(n * sizeof(glm::vec4), reference.place());
  std::vector<glm::vec4> colors;
  colors.reserve(n);
  for (const glm::vec3& c : opaque) colors.emplace_back(c, 1.0f);
  return colors;
}

/// (0, 0, 0) where a file has no direction.
std::vector<glm::vec3> read_normals(GltfDocument& document, const JsonView& reference, std::size_t n) {
  std::vector<glm::vec3> normals = checked_count(read_vec3(document, reference), n, reference);
  for (glm::vec3& normal : normals) {
    if (!(std::isfinite(normal.x) && std::isfinite(normal.y) && std::isfinite(normal.z))) normal = glm::vec3(0.0f);
  }
  return normals;
}

}  // namespace

Mesh read_primitive(GltfDocument& document, const JsonView& view, const std::vector<GltfMaterial>& materials) {
  const auto mode_view = view.find("mode");
  const Mode mode = mode_view ? Mode(mode_view->integer(0, 6)) : Mode::triangles;
  Mesh mesh;
  mesh.kind = kind_of(mode);
  if (const auto reference = view.find("material")) {
    mesh.material = std::uint32_t(reference->index(materials.size(), "materials"));
  }
  const JsonView attributes = view.require("attributes");
  const auto positions = attributes.find("POSITION");
  if (!positions) return mesh;

  mesh.positions = read_vec3(document, *positions);
  check_finite(mesh.positions, *positions);
  const std::size_t n = mesh.positions.size();
  mesh.indices = read_list(document, view, mode, n);
  if (const auto normals = attributes.find("NORMAL")) mesh.normals = read_normals(document, *normals, n);
  if (const auto colors = attributes.find("COLOR_0")) mesh.colors = read_colors(document, *colors, n);
  const GltfMaterial* const material = mesh.material ? &materials[*mesh.material] : nullptr;
  if (material && material->uvs) mesh.uvs = read_uvs(document, attributes, *material->uvs, n);

  const bool is_lit = !(material && material->material.unlit);
  if (mesh.kind == MeshKind::triangles && is_lit && mesh.normals.empty()) {
    constexpr std::size_t kCornerBytes =
        2 * sizeof(glm::vec3) + sizeof(glm::vec2) + sizeof(glm::vec4) + sizeof(std::uint32_t);
    document.files().budget.take(kCornerBytes * mesh.indices.size(), view.place());
    return with_flat_normals(mesh);
  }
  return mesh;
}

}  // namespace lode::geometry
