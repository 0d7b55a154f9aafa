#include "experiments/draw/picture.h"

namespace lode::experiments {
namespace {

raster::Vertices bound_vertices(const PictureDraw& draw) {
  if (const auto* window = std::get_if<std::vector<glm::dvec3>>(&draw.positions)) {
    return raster::WindowVertices{*window};
  }
  if (const auto* clip = std::get_if<std::vector<glm::dvec4>>(&draw.positions)) return raster::ClipVertices{*clip};
  return raster::ObjectVertices{std::get<std::vector<glm::vec3>>(draw.positions), draw.clip_from_world};
}

}  // namespace

std::vector<raster::Draw> bound_draws(const Picture& picture) {
  std::vector<raster::Draw> draws;
  draws.reserve(picture.draws.size());
  for (const PictureDraw& d : picture.draws) {
    raster::Draw& bound = draws.emplace_back(d.state);
    bound.vertices = bound_vertices(d);
    bound.colors = d.colors;
    bound.normals = d.normals;
    bound.uvs = d.uvs;
    bound.radii = d.radii;
    bound.texture = d.texture.get();
  }
  return draws;
}

}  // namespace lode::experiments
