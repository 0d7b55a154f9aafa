#include "raster/fast/tile.h"

namespace lode::raster::fast {

std::uint32_t Owners::primitive(std::uint32_t owner) const {
  const Resident& r = w_.residents[owner / kSlotTriangles];
  return scene_.fast[r.fast_draw].clusters->primitives[r.first_triangle + owner % kSlotTriangles];
}

Ids Owners::ids(std::uint32_t owner) const {
  if (owner & kPieceBit) return piece(owner & ~kPieceBit).ids;
  const std::uint32_t index = fast_draw(owner).draw;
  const Draw& draw = scene_.frame->draws[index];
  return {draw.draw_id.value_or(index), draw.primitive_id ? *draw.primitive_id : primitive(owner)};
}

Owners::Key Owners::key(std::uint32_t owner) const {
  const Ids of_owner = ids(owner);
  if (owner & kPieceBit) {
    const Piece& p = piece(owner & ~kPieceBit);
    return {of_owner.draw, of_owner.primitive, p.number, p.draw, p.primitive};
  }
  return {of_owner.draw, of_owner.primitive, 0, fast_draw(owner).draw, primitive(owner)};
}

bool Owners::key_before(std::uint32_t a, std::uint32_t b) const { return b == kNoOwner || key(a) < key(b); }

int Owners::facing_sign(std::uint32_t slot, std::uint32_t triangle) const {
  const Resident& r = w_.residents[slot];
  const FastDraw& fast = scene_.fast[r.fast_draw];
  std::array<glm::dvec4, 3> corners;
  for (std::size_t k = 0; k < 3; ++k) {
    const std::uint8_t local = fast.clusters->corners[3 * std::size_t(r.first_triangle + triangle) + k];
    corners[k] = reference::clip_position(scene_.frame->draws[fast.draw].vertices,
                                          fast.clusters->vertices[r.first_vertex + local]);
  }
  return reference::facing_sign(corners);
}

void Owners::make_piece(std::uint32_t owner, Piece& p) const {
  const Resident& r = w_.residents[owner / kSlotTriangles];
  const FastDraw& fast = scene_.fast[r.fast_draw];
  const WindowVertices128& v = w_.vertices[owner / kSlotTriangles];
  std::array<reference::WindowVertex, 3> corners;
  std::array<std::uint32_t, 3> vertices;
  for (std::size_t k = 0; k < 3; ++k) {
    const std::uint8_t local = fast.clusters->corners[3 * std::size_t(r.first_triangle + owner % kSlotTriangles) + k];
    corners[k] = {glm::ivec2(v.x_fx8(local), v.y_fx8(local)) + box_.begin_px * 256, v.z[local], v.w[local]};
    vertices[k] = fast.clusters->vertices[r.first_vertex + local];
  }
  std::array<int, 3> order;
  p.shape = *reference::make_triangle(corners, order);
  p.bounds_px = box_;
  p.draw = fast.draw;
  p.ids = ids(owner);
  for (std::size_t k = 0; k < 3; ++k) p.vertices[k] = vertices[std::size_t(order[k])];
  p.n_vertices = 3;
  p.front_facing = reference::doubled_area_fx16(corners[0].p_fx8, corners[1].p_fx8, corners[2].p_fx8) < 0;  // y down
}

}  // namespace lode::raster::fast
