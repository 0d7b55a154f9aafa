#include "geometry/procedural/model.h"

#include <algorithm>
#include <array>
#include <utility>

#include "geometry/error.h"
#include "geometry/procedural/parts.h"

namespace lode::geometry {

Mesh& Model::surface(const Material& material) {
  for (ModelSurface& s : surfaces) {
    if (s.material.name == material.name) return s.mesh;
  }
  surfaces.push_back({material, {}});
  return surfaces.back().mesh;
}

Material paint(const std::string& name, float r, float g, float b) {
  Material material;
  material.name = name;
  material.color = {r, g, b, 1.0f};
  return material;
}

Material two_sided(Material material) {
  material.double_sided = true;
  return material;
}

std::size_t n_triangles(const Model& model) {
  std::size_t n = 0;
  for (const ModelSurface& s : model.surfaces) n += s.mesh.n_primitives();
  return n;
}

std::size_t n_positions(const Model& model) {
  std::vector<std::array<float, 3>> places;
  for (const ModelSurface& s : model.surfaces) {
    for (const std::uint32_t index : s.mesh.indices) {
      const glm::vec3 p = s.mesh.positions[index] + 0.0f;  // −0 counts as +0
      places.push_back({p.x, p.y, p.z});
    }
  }
  std::sort(places.begin(), places.end());
  return std::size_t(std::unique(places.begin(), places.end()) - places.begin());
}

void fill_up(Model& model, Mesh& surface, std::size_t n) {
  const std::size_t found = n_triangles(model);
  if (found <= n && (n - found) % 2 == 0) add_triangles_by_splitting(surface, n - found);
  expect_triangles(model, n);
}

void expect_triangles(const Model& model, std::size_t n) {
  if (n_triangles(model) == n) return;
  throw Error(ErrorKind::bad_input, "model " + model.name + ": expected " + std::to_string(n) + " triangles, found " +
                                        std::to_string(n_triangles(model)));
}

std::uint32_t ModelScene::material(const Material& material) {
  const auto [place, is_new] = materials_.emplace(material.name, std::uint32_t(scene_.materials.size()));
  if (is_new) scene_.materials.push_back(material);
  return place->second;
}

std::size_t ModelScene::add(const Model& model) {
  Placeable& placeable = models_.emplace_back();
  for (const ModelSurface& s : model.surfaces) {
    if (s.mesh.indices.empty()) continue;
    placeable.meshes.push_back({std::uint32_t(scene_.meshes.size()), glm::dmat4(1.0)});
    for (const std::uint32_t index : s.mesh.indices) placeable.bounds.add(glm::dvec3(s.mesh.positions[index]));
    scene_.meshes.push_back(s.mesh.normals.empty() ? with_smooth_normals(s.mesh) : s.mesh);
    scene_.meshes.back().material = material(s.material);
  }
  return models_.size() - 1;
}

std::uint32_t ModelScene::picture(const Picture& picture) {
  for (std::size_t k = 0; k < scene_.pictures.size(); ++k) {
    const Picture& known = scene_.pictures[k];
    if (known.size_px == picture.size_px && known.texels == picture.texels) return std::uint32_t(k);
  }
  scene_.pictures.push_back(picture);
  return std::uint32_t(scene_.pictures.size() - 1);
}

std::size_t ModelScene::add(const Scene& source) {
  std::vector<std::uint32_t> pictures;
  for (const Picture& p : source.pictures) pictures.push_back(picture(p));
  const auto first_material = std::uint32_t(scene_.materials.size());
  const auto first_mesh = std::uint32_t(scene_.meshes.size());
  for (Material m : source.materials) {
    if (m.color_texture) m.color_texture->picture = pictures[m.color_texture->picture];
    scene_.materials.push_back(std::move(m));
  }
  for (Mesh mesh : source.meshes) {
    if (mesh.material) *mesh.material += first_material;
    scene_.meshes.push_back(std::move(mesh));
  }
  scene_.files.insert(scene_.files.end(), source.files.begin(), source.files.end());
  Placeable& placeable = models_.emplace_back(Placeable{{}, source.bounds()});
  for (const Instance& i : source.instances) placeable.meshes.push_back({first_mesh + i.mesh, i.world_from_object});
  return models_.size() - 1;
}

void ModelScene::place(std::size_t model, const std::string& name, const glm::dmat4& world_from_model) {
  const auto node = std::uint32_t(scene_.nodes.size());
  scene_.nodes.push_back({name, {}, world_from_model, world_from_model});
  const auto first = std::uint32_t(scene_.instances.size());
  for (const PlacedMesh& m : models_[model].meshes) {
    scene_.instances.push_back({m.mesh, node, world_from_model * m.model_from_mesh});
  }
  scene_.objects.push_back({name, first, std::uint32_t(models_[model].meshes.size())});
}

void ModelScene::add_path(CameraPath path) {
  for (int k = 0; k < 4; ++k) {
    const int frame = path.n_frames * k / 4;
    scene_.cameras.push_back({path.name + " " + std::to_string(frame), camera_at(path, frame)});
  }
  scene_.paths.push_back(std::move(path));
}

}  // namespace lode::geometry
