#include "experiments/truth/triangle_table.h"

namespace lode::experiments::truth {

TriangleTable::TriangleTable(std::span<const raster::Draw> draws, glm::ivec2 size_px)
    : draws_(draws), size_px_(size_px) {
  for (std::size_t i = 0; i < draws.size(); ++i) draw_of_id_[*draws[i].draw_id] = i;
}

std::size_t TriangleTable::n_triangles(std::size_t draw) const {
  const raster::Draw& d = draws_[draw];
  return (d.indices ? d.indices->size() : std::get<raster::ObjectVertices>(d.vertices).positions.size()) / 3;
}

SourceTriangle TriangleTable::source(std::size_t draw, std::size_t triangle) const {
  const raster::Draw& d = draws_[draw];
  const auto& vertices = std::get<raster::ObjectVertices>(d.vertices);
  SourceTriangle source{&vertices.clip_from_object, {}, d.cull};
  for (std::size_t i = 0; i < 3; ++i) {
    const std::size_t k = 3 * triangle + i;
    source.p_object[i] = vertices.positions[d.indices ? (*d.indices)[k] : k];
  }
  return source;
}

std::optional<SourceTriangle> TriangleTable::find(raster::Ids ids) const {
  const auto draw = draw_of_id_.find(ids.draw);
  if (draw == draw_of_id_.end() || ids.primitive >= n_triangles(draw->second)) return std::nullopt;
  return source(draw->second, ids.primitive);
}

const PreparedTriangle* PreparedCache::find(raster::Ids ids) {
  if (ids.draw == raster::kNoId) return nullptr;
  Entry& entry = entries_[(ids.draw * 31u + ids.primitive) % entries_.size()];
  if (entry.ids == ids) return &entry.triangle;
  const std::optional<SourceTriangle> source = table_->find(ids);
  if (!source) return nullptr;
  entry = {ids, table_->prepared(*source)};
  return &entry.triangle;
}

}  // namespace lode::experiments::truth
