#pragma once
/// A scene as all techniques see it: what can be left out as a whole (objects), what objects look like (draws), and
/// which of them are the same shape in different places. Made once per scene and shared by all that draw it.

#include <cstdint>
#include <functional>
#include <glm/mat4x4.hpp>
#include <map>
#include <memory>
#include <mutex>
#include <span>
#include <string>
#include <vector>

#include "geometry/bounds.h"
#include "geometry/scene.h"
#include "techniques/scene_draws.h"

namespace lode::techniques {

using ObjectId = std::uint32_t;  ///< index in World::objects()

/// What is drawn or left out as a whole: a run of the scene's instances.
struct WorldObject {
  std::string name;
  std::uint32_t first_instance = 0, n_instances = 0;
  geometry::Bounds bounds;         ///< in the world, of every indexed vertex
  std::uint64_t n_primitives = 0;  ///< triangles, lines and points
  std::uint32_t shape = 0;         ///< below World::n_shapes()
  glm::dmat4 world_from_shape{1.0};
};

/// The triangles of an object, whatever their materials, in the space of its first instance. Objects of the same meshes
/// in the same places relative to each other share one. What is front (scene_draws.h) is counter-clockwise.
struct Shape {
  std::vector<glm::vec3> positions;    ///< [n]
  std::vector<std::uint32_t> indices;  ///< [3 · triangles], each < n
  /// Only opaque triangles, so that what it covers hides what is behind it.
  bool hides = false;
  /// Every position is one of the scene's, unchanged: all instances stand in the same place.
  bool exact = true;
};

class World {
 public:
  /// The scene must outlive this unchanged. With `clusters`, meshes are cut for the fast pipeline on `threads` threads
  /// (0: one per processor). Throws raster::Error (out_of_memory; bad_input, naming a picture that is too large).
  World(const geometry::Scene& scene, const SceneDraws::Params& params, bool clusters, int threads = 0);

  [[nodiscard]] const geometry::Scene& scene() const { return draws_.scene(); }
  [[nodiscard]] const SceneDraws& draws() const { return draws_; }
  [[nodiscard]] ColorSpace color_space() const { return color_space_; }
  [[nodiscard]] const geometry::Bounds& bounds() const { return bounds_; }
  [[nodiscard]] std::span<const WorldObject> objects() const { return objects_; }
  [[nodiscard]] std::uint32_t n_shapes() const { return std::uint32_t(first_of_shape_.size()); }
  /// Makes a copy of one. O(its size).
  [[nodiscard]] Shape shape(std::uint32_t shape) const;
  /// What was found out about this world under that key, or what `make` returns, which is then kept for whoever asks
  /// next: techniques that prepare the same thing with the same parameters do it once. The key names the type, too.
  template <class T>
  [[nodiscard]] std::shared_ptr<const T> once(const std::string& key, const std::function<T()>& make) const {
    const std::lock_guard lock(findings_->lock);
    std::shared_ptr<const void>& found = findings_->by_key[key];
    if (!found) found = std::make_shared<const T>(make());
    return std::static_pointer_cast<const T>(found);
  }

  /// The object that an instance belongs to.
  [[nodiscard]] ObjectId object_of(std::uint32_t instance) const { return object_of_[instance]; }

 private:
  struct Findings {
    std::mutex lock;
    std::map<std::string, std::shared_ptr<const void>> by_key;
  };

  void add_object(const geometry::SceneObject& scene_object);
  std::uint32_t shape_of(const WorldObject& object);

  std::unique_ptr<Findings> findings_ = std::make_unique<Findings>();
  SceneDraws draws_;
  ColorSpace color_space_;
  geometry::Bounds bounds_;
  std::vector<WorldObject> objects_;
  std::vector<std::uint32_t> object_of_;                                ///< [instances]
  std::vector<std::uint32_t> first_of_shape_;                           ///< [shapes] the first object of each
  std::map<std::uint32_t, std::vector<std::uint32_t>> shapes_of_mesh_;  ///< by the mesh that they begin with
};

}  // namespace lode::techniques
