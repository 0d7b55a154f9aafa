#include "geometry/model_file/gltf/gltf_file.h"

#include <map>
#include <string_view>
#include <utility>
#include <vector>

#include "geometry/model_file/gltf/gltf_document.h"
#include "geometry/model_file/gltf/gltf_material.h"
#include "geometry/model_file/gltf/gltf_mesh.h"
#include "geometry/model_file/gltf/gltf_node.h"

namespace lode::geometry {
namespace {

class SceneReader {
 public:
  explicit SceneReader(ModelFiles& files) : document_(files), textures_(document_) { scene_.name = files.model_path(); }

  Scene read() {
    take("materials", 4 * sizeof(GltfMaterial));
    materials_ = read_materials(document_, textures_);
    take("nodes", sizeof(PlacedNode) + sizeof(Node) + 64);  // and their families, and cameras
    scene_.nodes.reserve(document_.count("nodes"));
    for (const PlacedNode& placed : placed_nodes(document_)) add_node(placed);
    for (GltfMaterial& material : materials_) scene_.materials.push_back(std::move(material.material));
    scene_.pictures = textures_.read_pictures();
    return std::move(scene_);
  }

 private:
  /// Takes memory for all elements of a top-level array.
  void take(std::string_view array, std::size_t bytes_each) {
    document_.files().budget.take(document_.count(array) * bytes_each, scene_.name + ": " + std::string(array));
  }

  void add_node(const PlacedNode& placed) {
    const auto index = std::uint32_t(scene_.nodes.size());
    const JsonView view = document_.element("nodes", placed.node);
    Node node;
    if (const auto name = view.find("name")) node.name = name->string();
    if (placed.parent != index) node.parent = placed.parent;
    node.parent_from_node = placed.parent_from_node;
    node.world_from_node = placed.world_from_node;
    scene_.nodes.push_back(node);
    if (const auto mesh = view.find("mesh")) add_instances(*mesh, index);
    if (const auto camera = view.find("camera")) add_camera(*camera, node);
  }

  void add_instances(const JsonView& reference, std::uint32_t node) {
    const Range meshes = mesh(reference);
    document_.files().budget.take(2 * meshes.count * sizeof(Instance), reference.place());
    for (std::uint32_t i = 0; i < meshes.count; ++i) {
      scene_.instances.push_back({meshes.first + i, node, scene_.nodes[node].world_from_node});
    }
  }

  void add_camera(const JsonView& reference, const Node& node) {
    SceneCamera camera{node.name, read_camera(document_, reference, node.world_from_node)};
    const JsonView view = document_.target(reference, "cameras");
    const auto name = view.find("name");
    if (camera.name.empty() && name) camera.name = name->string();
    scene_.cameras.push_back(std::move(camera));
  }

  /// Meshes of the scene that the primitives of one of the file's meshes became.
  struct Range {
    std::uint32_t first, count;
  };

  Range mesh(const JsonView& reference) {
    const std::size_t index = reference.index(document_.count("meshes"), "meshes");
    const auto known = meshes_.find(index);
    if (known != meshes_.end()) return known->second;

    const JsonView view = document_.element("meshes", index);
    const JsonView primitives = view.require("primitives");
    const Range range{std::uint32_t(scene_.meshes.size()), std::uint32_t(primitives.size("an array of primitives"))};
    document_.files().budget.take(3 * range.count * sizeof(Mesh), primitives.place());
    for (std::uint32_t i = 0; i < range.count; ++i) {
      scene_.meshes.push_back(read_primitive(document_, primitives.at(i), materials_));
    }
    meshes_.emplace(index, range);
    return range;
  }

  GltfDocument document_;
  GltfTextures textures_;
  Scene scene_;
  std::vector<GltfMaterial> materials_;
  std::map<std::size_t, Range> meshes_;
};

}  // namespace

Scene read_gltf(const std::string& path) {
  ModelFiles files(path);
  Scene scene = SceneReader(files).read();
  scene.files = files.paths();
  return scene;
}

}  // namespace lode::geometry
