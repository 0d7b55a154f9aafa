#pragma once
/// A scene: meshes, materials and pictures, and the instances that place meshes in the world. The order of the
/// instances is the order of draw ids: (node, mesh primitive) pairs, depth first in document order. Its objects are
/// what a technique draws, replaces or leaves out as a whole: runs of instances.

#include <cstdint>
#include <glm/mat4x4.hpp>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "geometry/bounds.h"
#include "geometry/camera.h"
#include "geometry/camera_path.h"
#include "geometry/material.h"
#include "geometry/mesh.h"

namespace lode::geometry {

/// A place in the graph of a file, kept for names and for reading; drawing needs only the instances.
struct Node {
  std::string name;
  std::optional<std::uint32_t> parent;  ///< index in Scene::nodes, less than this node's own
  glm::dmat4 parent_from_node{1.0};
  glm::dmat4 world_from_node{1.0};
};

/// One mesh in the world: one draw.
struct Instance {
  std::uint32_t mesh = 0;
  std::uint32_t node = 0;
  glm::dmat4 world_from_object{1.0};
};

/// What a technique culls as a whole, a chair say: the instances [first_instance, first_instance + n_instances).
struct SceneObject {
  std::string name;
  std::uint32_t first_instance = 0;
  std::uint32_t n_instances = 0;
  friend bool operator==(const SceneObject&, const SceneObject&) = default;
};

struct SceneCamera {
  std::string name;
  Camera camera;
};

struct Scene {
  std::string name;                ///< for messages: the file's path, or the built-in's name with its parameters
  std::vector<std::string> files;  ///< that it was read from: nothing may overwrite them
  std::vector<Mesh> meshes;
  std::vector<Material> materials;
  std::vector<Picture> pictures;
  std::vector<Node> nodes;  ///< depth first in document order
  std::vector<Instance> instances;
  std::vector<SceneObject> objects;  ///< none, or every instance once, in order; see objects_of()
  std::vector<SceneCamera> cameras;  ///< in the order of their nodes
  std::vector<CameraPath> paths;     ///< walks through it, the main one first
  std::vector<Bounds> free_space;    ///< boxes of air to look around from, apart from each other; see viewpoints.h

  /// Of every indexed vertex of every instance, in the world.
  [[nodiscard]] Bounds bounds() const;
};

/// The scene's objects; of a scene that has none, one for each run of instances of one node, with the node's name.
/// Every instance belongs to exactly one, and they come in the order of their instances.
[[nodiscard]] std::vector<SceneObject> objects_of(const Scene& scene);

/// Of every indexed vertex of the object's instances, in the world.
[[nodiscard]] Bounds object_bounds(const Scene& scene, const SceneObject& object);

/// Triangles of all the object's instances.
[[nodiscard]] std::size_t n_triangles(const Scene& scene, const SceneObject& object);

/// Whether the object may hide others as far as materials tell: it has triangles, and all its instances' are opaque
/// (one that is alpha-tested or blended has holes).
[[nodiscard]] bool may_occlude(const Scene& scene, const SceneObject& object);

/// Whether the transform turns counter-clockwise into clockwise (its linear part has a negative determinant), so that
/// the front of an instance is the other side. glTF 2.0, sec. 3.7.4.
[[nodiscard]] bool mirrors(const glm::dmat4& transform);

}  // namespace lode::geometry
