#pragma once
/// Scenes of a few triangles, and their pictures by a camera whose view is one world unit a pixel.

#include <glm/gtc/matrix_transform.hpp>
#include <vector>

#include "geometry/scene.h"
#include "raster/render.h"
#include "techniques/scene_draws.h"

namespace lode::tests {

/// A square [0, 1]² in the plane z, counter-clockwise as seen from +z, with uvs (v down) and normals along +z.
inline geometry::Mesh unit_square(float z = 0.0f) {
  geometry::Mesh mesh;
  mesh.positions = {{0, 0, z}, {1, 0, z}, {1, 1, z}, {0, 1, z}};
  mesh.indices = {0, 1, 2, 0, 2, 3};
  mesh.uvs = {{0, 1}, {1, 1}, {1, 0}, {0, 0}};
  mesh.normals.assign(4, {0, 0, 1});
  return mesh;
}

inline geometry::Picture one_texel(glm::u8vec4 texel) {
  return {.name = "texel", .size_px = {1, 1}, .texels = {texel}, .has_alpha = texel.a < 255};
}

/// Adds the mesh with a material of its own.
inline void add(geometry::Scene& scene, geometry::Mesh mesh, const geometry::Material& material,
                const glm::dmat4& world_from_object = glm::dmat4(1.0)) {
  mesh.material = std::uint32_t(scene.materials.size());
  scene.materials.push_back(material);
  scene.instances.push_back(
      {.mesh = std::uint32_t(scene.meshes.size()), .node = 0, .world_from_object = world_from_object});
  scene.meshes.push_back(std::move(mesh));
}

/// Looks down −z from z = 10 at [0, n]², or up +z from z = −10 (x then runs to the left), depth from 20 units on.
inline geometry::Camera square_camera(int n, bool from_behind = false) {
  geometry::Camera camera;
  camera.eye = {0.5 * n, 0.5 * n, from_behind ? -10.0 : 10.0};
  if (from_behind) {
    camera.right = {-1, 0, 0};
    camera.back = {0, 0, -1};
  }
  camera.projection = geometry::Projection::orthographic;
  camera.height = n;
  camera.near = 0.0;
  camera.far = 20.0;
  return camera;
}

/// The scene on n × n pixels.
inline raster::Image picture_of(const geometry::Scene& scene, const techniques::SceneDraws::Params& params,
                                const glm::vec4& clear = glm::vec4(0.0f), int n = 1, bool from_behind = false) {
  const techniques::SceneDraws scene_draws(scene, params);
  const std::vector<raster::Draw> draws = scene_draws.draws(square_camera(n, from_behind), {n, n});
  raster::Image image = raster::make_image({n, n}, techniques::color_format(params.color_space));
  raster::render({.draws = draws, .clear = clear, .viewport = {}, .scissor = {}}, image, {.threads = 1});
  return image;
}

}  // namespace lode::tests
