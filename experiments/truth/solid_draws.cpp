#include "experiments/truth/solid_draws.h"

namespace lode::experiments::truth {

std::vector<TracedDraw> SolidDraws::traced() const {
  std::vector<TracedDraw> traced;
  for (std::size_t i = 0; i < draws.size(); ++i) traced.push_back({&draws[i], world_from_object[i]});
  return traced;
}

SolidDraws solid_draws(const geometry::Scene& scene, std::span<const raster::Draw> draws) {
  SolidDraws solid;
  for (std::size_t i = 0; i < draws.size(); ++i) {
    const raster::Draw& draw = draws[i];
    if (draw.topology != raster::Topology::triangles) {
      ++(draw.topology == raster::Topology::points ? solid.left_out.points : solid.left_out.lines);
    } else if (draw.blend != raster::Blend::none) {
      ++solid.left_out.blended;
    } else {
      raster::Draw bare;
      bare.vertices = draw.vertices;
      bare.indices = draw.indices;
      bare.clusters = draw.clusters;
      bare.cull = draw.cull;
      bare.draw_id = std::uint32_t(i);
      solid.draws.push_back(bare);
      solid.world_from_object.push_back(scene.instances[i].world_from_object);
    }
  }
  return solid;
}

}  // namespace lode::experiments::truth
