#include "geometry/model_file/gltf/gltf_node.h"

#include <algorithm>
#include <cfloat>
#include <cmath>
#include <glm/geometric.hpp>
#include <string>
#include <utility>

#include "geometry/trigonometry.h"

namespace lode::geometry {
namespace {

constexpr std::uint32_t kNone = 0xFFFFFFFFu;

template <int N>
glm::vec<N, double> read_vector(const JsonView& view, const char* expected) {
  if (view.size(expected) != N) view.fail_expected(expected);
  glm::vec<N, double> v;
  for (int c = 0; c < N; ++c) v[c] = view.at(std::size_t(c)).number(-DBL_MAX, DBL_MAX);
  return v;
}

glm::dmat4 read_matrix(const JsonView& view) {
  if (view.size("16 numbers") != 16) view.fail_expected("16 numbers, column by column");
  glm::dmat4 m;
  for (int i = 0; i < 16; ++i) m[i / 4][i % 4] = view.at(std::size_t(i)).number(-DBL_MAX, DBL_MAX);
  if (m[0][3] != 0.0 || m[1][3] != 0.0 || m[2][3] != 0.0 || m[3][3] != 1.0) view.fail("expected a last row of 0 0 0 1");
  return m;
}

/// Columns of the rotation by x i + y j + z k + w, which is made a unit quaternion first.
glm::dmat4 rotation(glm::dvec4 q, const JsonView& view) {
  const double length = std::sqrt(q.x * q.x + q.y * q.y + q.z * q.z + q.w * q.w);
  if (!(length > 0.0) || !std::isfinite(length)) view.fail_expected("a unit quaternion");
  q /= length;
  glm::dmat4 m(1.0);
  m[0] = {1.0 - 2.0 * (q.y * q.y + q.z * q.z), 2.0 * (q.x * q.y + q.z * q.w), 2.0 * (q.x * q.z - q.y * q.w), 0.0};
  m[1] = {2.0 * (q.x * q.y - q.z * q.w), 1.0 - 2.0 * (q.x * q.x + q.z * q.z), 2.0 * (q.y * q.z + q.x * q.w), 0.0};
  m[2] = {2.0 * (q.x * q.z + q.y * q.w), 2.0 * (q.y * q.z - q.x * q.w), 1.0 - 2.0 * (q.x * q.x + q.y * q.y), 0.0};
  return m;
}

/// "matrix", or translation · rotation · scale. Sec. 3.5.3.
glm::dmat4 read_transform(const JsonView& node) {
  const auto matrix = node.find("matrix");
  const auto move = node.find("translation"), turn = node.find("rotation"), stretch = node.find("scale");
  if (matrix) {
    if (move || turn || stretch) node.fail("has both \"matrix\" and a translation, rotation or scale");
    return read_matrix(*matrix);
  }
  glm::dmat4 m(1.0);
  if (turn) m = rotation(read_vector<4>(*turn, "[x, y, z, w]"), *turn);
  if (stretch) {
    const glm::dvec3 scale = read_vector<3>(*stretch, "[x, y, z]");
    for (int c = 0; c < 3; ++c) m[c] *= scale[c];
  }
  if (move) m[3] = glm::dvec4(read_vector<3>(*move, "[x, y, z]"), 1.0);
  return m;
}

bool is_finite(const glm::dmat4& m) {
  for (int c = 0; c < 4; ++c) {
    for (int r = 0; r < 4; ++r) {
      if (!std::isfinite(m[c][r])) return false;
    }
  }
  return true;
}

/// Who belongs to whom, by the indices of the file's nodes.
struct Family {
  std::vector<std::vector<std::uint32_t>> children;
  std::vector<std::uint32_t> parents;  ///< kNone: a root
};

std::vector<std::uint32_t> read_node_list(const JsonView& view, std::size_t n_nodes) {
  std::vector<std::uint32_t> nodes;
  for (std::size_t i = 0, n = view.size("an array of nodes"); i < n; ++i) {
    nodes.push_back(std::uint32_t(view.at(i).index(n_nodes, "nodes")));
  }
  return nodes;
}

Family read_family(const GltfDocument& document) {
  const std::size_t n = document.count("nodes");
  Family family{std::vector<std::vector<std::uint32_t>>(n), std::vector<std::uint32_t>(n, kNone)};
  for (std::size_t parent = 0; parent < n; ++parent) {
    const JsonView node = document.element("nodes", parent);
    const auto view = node.find("children");
    if (!view) continue;
    family.children[parent] = read_node_list(*view, n);
    for (std::size_t i = 0; i < family.children[parent].size(); ++i) {
      std::uint32_t& known = family.parents[family.children[parent][i]];
      if (known != kNone) {
        view->at(i).fail("node " + std::to_string(family.children[parent][i]) + " is already a child of node " +
                         std::to_string(known) + ": expected one parent for each node");
      }
      known = std::uint32_t(parent);
    }
  }
  return family;
}

/// Fails at a node that is its own ancestor. As no node has two parents, following parents is enough.
void check_cycles(const GltfDocument& document, const Family& family) {
  std::vector<std::uint32_t> walk(family.parents.size(), kNone);  // the walk that came by first
  for (std::uint32_t start = 0; start < walk.size(); ++start) {
    std::uint32_t node = start;
    while (node != kNone && walk[node] == kNone) {
      walk[node] = start;
      node = family.parents[node];
    }
    if (node != kNone && walk[node] == start) {
      document.element("nodes", node).fail("is its own ancestor: expected nodes without cycles");
    }
  }
}

/// The nodes at the top of what is read.
std::vector<std::uint32_t> roots(const GltfDocument& document, const Family& family) {
  const std::size_t n_scenes = document.count("scenes");
  const auto index = document.root().find("scene");
  const std::size_t scene = index ? index->index(n_scenes, "scenes") : 0;
  std::vector<std::uint32_t> result;
  if (n_scenes == 0) {
    for (std::uint32_t node = 0; node < family.parents.size(); ++node) {
      if (family.parents[node] == kNone) result.push_back(node);
    }
    return result;
  }
  const JsonView scene_view = document.element("scenes", scene);
  const auto view = scene_view.find("nodes");
  if (!view) return result;
  result = read_node_list(*view, family.parents.size());
  std::vector<bool> seen(family.parents.size());
  for (std::size_t i = 0; i < result.size(); ++i) {
    if (family.parents[result[i]] != kNone) {
      view->at(i).fail("node " + std::to_string(result[i]) + " is a child of node " +
                       std::to_string(family.parents[result[i]]) + ": expected a node without a parent");
    }
    if (seen[result[i]]) view->at(i).fail("node " + std::to_string(result[i]) + " is listed twice");
    seen[result[i]] = true;
  }
  return result;
}

glm::dvec3 unit(const glm::dvec3& v, const JsonView& reference) {
  const double greatest = std::max({std::fabs(v.x), std::fabs(v.y), std::fabs(v.z)});
  if (!(greatest > 0.0)) reference.fail("a camera at a node that is flat: expected a scale without zeros");
  const glm::dvec3 w = v / greatest;  // so that squares neither overflow nor vanish
  return w / std::sqrt(w.x * w.x + w.y * w.y + w.z * w.z);
}

/// znear and zfar; `low` is excluded if it is 0.
void read_range(const JsonView& view, Camera& camera, bool may_touch_eye) {
  const JsonView near = view.require("znear");
  camera.near = near.number(may_touch_eye ? 0.0 : DBL_TRUE_MIN, DBL_MAX);
  if (const auto far = view.find("zfar")) {
    camera.far = far->number(0.0, DBL_MAX);
    if (!(camera.far > camera.near)) far->fail_expected("more than znear");
  }
}

void read_perspective(const JsonView& view, Camera& camera) {
  camera.projection = Projection::perspective;
  const JsonView angle = view.require("yfov");
  const double yfov = angle.number(0.0, kPi);
  camera.tan_half_fov_y = tangent(0.5 * yfov);
  if (!(yfov > 0.0 && yfov < kPi && camera.tan_half_fov_y > 0.0)) angle.fail_expected("an angle between 0 and pi");
  read_range(view, camera, false);
}

void read_orthographic(const JsonView& view, Camera& camera) {
  camera.projection = Projection::orthographic;
  camera.height = 2.0 * view.require("ymag").number(DBL_MIN, DBL_MAX / 2);
  (void)view.require("zfar");
  read_range(view, camera, true);
}

}  // namespace

std::vector<PlacedNode> placed_nodes(const GltfDocument& document) {
  const Family family = read_family(document);
  check_cycles(document, family);

  std::vector<PlacedNode> placed;
  placed.reserve(family.parents.size());
  std::vector<std::pair<std::uint32_t, std::uint32_t>> open;  // a node, and its parent's place; the next one last
  const auto push = [&](const std::vector<std::uint32_t>& nodes, std::uint32_t parent) {
    for (auto node = nodes.rbegin(); node != nodes.rend(); ++node) open.emplace_back(*node, parent);
  };
  push(roots(document, family), kNone);
  while (!open.empty()) {
    const auto [node, parent] = open.back();
    open.pop_back();
    const auto place = std::uint32_t(placed.size());
    const JsonView view = document.element("nodes", node);
    const glm::dmat4 local = read_transform(view);
    const glm::dmat4 world = parent == kNone ? local : placed[parent].world_from_node * local;
    if (!is_finite(world)) view.fail("its place in the world is not finite");
    placed.push_back({node, parent == kNone ? place : parent, local, world});
    push(family.children[node], place);
  }
  return placed;
}

Camera read_camera(const GltfDocument& document, const JsonView& reference, const glm::dmat4& world_from_node) {
  const JsonView view = document.target(reference, "cameras");
  Camera camera;
  camera.eye = glm::dvec3(world_from_node[3]);
  camera.back = unit(glm::dvec3(world_from_node[2]), reference);
  const glm::dvec3 y = unit(glm::dvec3(world_from_node[1]), reference);
  camera.up = unit(y - glm::dot(y, camera.back) * camera.back, reference);
  camera.right = glm::cross(camera.up, camera.back);
  if (view.require("type").choice({"perspective", "orthographic"}) == 0) {
    read_perspective(view.require("perspective"), camera);
  } else {
    read_orthographic(view.require("orthographic"), camera);
  }
  check(camera);
  return camera;
}

}  // namespace lode::geometry
