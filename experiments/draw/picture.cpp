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

std::vector<glm::ivec2> sample_positions_fx8(int n) {
  std::vector<glm::ivec2> positions;
  for (int k = 0; k < n; ++k) {
    int reversed = 0;  // k's bits in reverse order, as many as n has places for
    for (int bit = 1; bit < n; bit *= 2) reversed = 2 * reversed + ((k & bit) != 0 ? 1 : 0);
    // In units of 1/(2n) px both are odd numbers; n divides 128, so that 1/256 px holds them exactly.
    positions.emplace_back((2 * k + 1) * (128 / n), (2 * reversed + 1) * (128 / n));
  }
  return positions;
}

}  // namespace lode::experiments
