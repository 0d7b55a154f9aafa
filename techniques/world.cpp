#include "techniques/world.h"

#include <utility>

namespace lode::techniques {
namespace {

constexpr std::uint32_t kNoMesh = 0xFFFFFFFFu;

using geometry::Mesh;
using geometry::MeshKind;
using geometry::Scene;

glm::dmat4 shape_from_instance(const Scene& scene, std::uint32_t first, std::uint32_t instance) {
  if (scene.instances[first].world_from_object == scene.instances[instance].world_from_object) return glm::dmat4(1.0);
  return glm::inverse(scene.instances[first].world_from_object) * scene.instances[instance].world_from_object;
}

/// The same meshes, and each in the same place relative to the first.
bool same_shape(const Scene& scene, const WorldObject& a, const WorldObject& b) {
  if (a.n_instances != b.n_instances) return false;
  for (std::uint32_t k = 0; k < a.n_instances; ++k) {
    const std::uint32_t i = a.first_instance + k, j = b.first_instance + k;
    if (scene.instances[i].mesh != scene.instances[j].mesh) return false;
    if (shape_from_instance(scene, a.first_instance, i) != shape_from_instance(scene, b.first_instance, j))
      return false;
  }
  return true;
}

}  // namespace

World::World(const Scene& scene, const SceneDraws::Params& params, bool clusters, int threads)
    : draws_(scene, params), color_space_(params.color_space), object_of_(scene.instances.size(), 0) {
  if (clusters) draws_.cut_clusters(threads);
  for (const geometry::SceneObject& object : geometry::objects_of(scene)) add_object(object);
}

void World::add_object(const geometry::SceneObject& scene_object) {
  const Scene& scene = this->scene();
  const auto id = ObjectId(objects_.size());
  WorldObject object{.name = scene_object.name,
                     .first_instance = scene_object.first_instance,
                     .n_instances = scene_object.n_instances,
                     .bounds = geometry::object_bounds(scene, scene_object)};
  for (std::uint32_t k = 0; k < object.n_instances; ++k) {
    const std::uint32_t instance = object.first_instance + k;
    object_of_[instance] = id;
    object.n_primitives += scene.meshes[scene.instances[instance].mesh].n_primitives();
  }
  if (object.n_instances > 0) object.world_from_shape = scene.instances[object.first_instance].world_from_object;
  if (!object.bounds.empty()) {
    bounds_.add(object.bounds.low);
    bounds_.add(object.bounds.high);
  }
  object.shape = shape_of(object);
  objects_.push_back(std::move(object));
}

/// One that is there already, or a new one. Only those that begin with the same mesh are looked at.
std::uint32_t World::shape_of(const WorldObject& object) {
  const Scene& scene = this->scene();
  const std::uint32_t mesh = object.n_instances > 0 ? scene.instances[object.first_instance].mesh : kNoMesh;
  std::vector<std::uint32_t>& candidates = shapes_of_mesh_[mesh];
  for (const std::uint32_t shape : candidates) {
    if (same_shape(scene, objects_[first_of_shape_[shape]], object)) return shape;
  }
  candidates.push_back(n_shapes());
  first_of_shape_.push_back(ObjectId(objects_.size()));
  return candidates.back();
}

/// Instances do not share vertices.
Shape World::shape(std::uint32_t index) const {
  const Scene& scene = this->scene();
  const WorldObject& object = objects_[first_of_shape_.at(index)];
  Shape shape;
  shape.hides = geometry::may_occlude(scene, {object.name, object.first_instance, object.n_instances});
  for (std::uint32_t k = 0; k < object.n_instances; ++k) {
    const std::uint32_t instance = object.first_instance + k;
    const Mesh& mesh = scene.meshes[scene.instances[instance].mesh];
    if (mesh.kind != MeshKind::triangles) continue;
    const auto offset = std::uint32_t(shape.positions.size());
    const glm::dmat4 place = shape_from_instance(scene, object.first_instance, instance);
    const bool same_place = place == glm::dmat4(1.0);
    shape.exact = shape.exact && same_place;
    for (const glm::vec3& p : mesh.positions) {
      shape.positions.push_back(same_place ? p : glm::vec3(place * glm::dvec4(p, 1.0)));
    }
    const std::size_t first_corner = shape.indices.size();
    for (const std::uint32_t i : mesh.indices) shape.indices.push_back(offset + i);
    if (!geometry::mirrors(place)) continue;
    for (std::size_t c = first_corner; c + 2 < shape.indices.size(); c += 3) {
      std::swap(shape.indices[c + 1], shape.indices[c + 2]);
    }
  }
  return shape;
}

}  // namespace lode::techniques
