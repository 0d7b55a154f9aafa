#pragma once
/// A procedural model: surfaces of one material each, which one scene object is made of; and the scene that models are
/// placed in.

#include <cstddef>
#include <cstdint>
#include <map>
#include <string>
#include <vector>

#include "geometry/material.h"
#include "geometry/mesh.h"
#include "geometry/scene.h"

namespace lode::geometry {

struct ModelSurface {
  Material material;
  Mesh mesh;  ///< triangles
};

struct Model {
  std::string name;
  std::vector<ModelSurface> surfaces;

  /// The mesh of the surface with the material's name, a new and empty one if there is none.
  Mesh& surface(const Material& material);
};

/// A plain material: linear colour in [0, 1].
[[nodiscard]] Material paint(const std::string& name, float r, float g, float b);
/// The same seen from both sides, for surfaces that enclose nothing.
[[nodiscard]] Material two_sided(Material material);

[[nodiscard]] std::size_t n_triangles(const Model& model);
/// Positions that differ, over all surfaces: vertices after welding.
[[nodiscard]] std::size_t n_positions(const Model& model);

/// Splits triangles of the surface until the model has exactly `n` of them.
/// Throws Error (bad_input) where it has more already, or an odd number is missing.
void fill_up(Model& model, Mesh& surface, std::size_t n);

/// Throws Error (bad_input), with what was found, unless the model has so many triangles.
void expect_triangles(const Model& model, std::size_t n);

/// A scene made of models, each placed any number of times; one placing is one object and one node. Materials of
/// procedural models that have one name are one, and must be equal.
class ModelScene {
 public:
  explicit ModelScene(std::string name) { scene_.name = std::move(name); }

  /// Gives the meshes smooth normals with sharp creases, unless they have normals. Returns the model's index.
  std::size_t add(const Model& model);
  /// Everything of a scene, as it stands there, as one model. A picture that is there already is not kept twice.
  std::size_t add(const Scene& source);
  /// Of what the model draws, in its own space.
  [[nodiscard]] const Bounds& bounds(std::size_t model) const { return models_[model].bounds; }

  void place(std::size_t model, const std::string& name, const glm::dmat4& world_from_model);
  /// Once.
  void place(const Model& model, const std::string& name, const glm::dmat4& world_from_model = glm::dmat4(1.0)) {
    place(add(model), name, world_from_model);
  }

  /// A walk, and four cameras along it: "NAME 0", "NAME FRAME", …
  void add_path(CameraPath path);
  void add_free_space(const Bounds& box) { scene_.free_space.push_back(box); }

  [[nodiscard]] const Scene& scene() const { return scene_; }
  [[nodiscard]] Scene take() && { return std::move(scene_); }

 private:
  struct PlacedMesh {
    std::uint32_t mesh;
    glm::dmat4 model_from_mesh;
  };
  struct Placeable {
    std::vector<PlacedMesh> meshes;
    Bounds bounds;
  };

  std::uint32_t material(const Material& material);
  std::uint32_t picture(const Picture& picture);

  Scene scene_;
  std::map<std::string, std::uint32_t> materials_;  ///< of procedural models, by name
  std::vector<Placeable> models_;
};

}  // namespace lode::geometry
