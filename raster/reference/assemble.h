#pragma once
/// From draws to pieces: vertices are transformed, clipped, snapped and culled, and what is left becomes a list
/// of shapes in window coordinates, in submission order.

#include <cstdint>
#include <glm/vec2.hpp>
#include <memory>
#include <span>
#include <type_traits>
#include <variant>
#include <vector>

#include "raster/frame.h"
#include "raster/image.h"
#include "raster/reference/disc.h"
#include "raster/reference/line.h"
#include "raster/reference/primitive.h"
#include "raster/reference/surfel.h"
#include "raster/reference/triangle.h"
#include "raster/stats.h"

namespace lode::raster::reference {

/// A surfel is five times as large as the others: it lives in the assembly, so that triangles stay small.
using Shape = std::variant<Triangle, Line, Square, Disc, const Surfel*>;

/// f(shape), whichever it is.
template <class Function>
decltype(auto) visit_shape(const Shape& shape, const Function& f) {
  return std::visit(
      [&]<class T>(const T& s) -> decltype(auto) {
        if constexpr (std::is_same_v<T, const Surfel*>) {
          return f(*s);
        } else {
          return f(s);
        }
      },
      shape);
}

/// One shape on its way to the tiles.
struct Piece {
  Shape shape;
  PixelBox bounds_px;      ///< inside target and scissor, over all samples
  std::uint32_t draw = 0;  ///< index in the frame
  Ids ids{0, 0};           ///< as the picture has them
  std::uint32_t number = 0;  ///< within its primitive: a quad's triangles, a clipped triangle's fan
  std::array<std::uint32_t, 3> vertices{0, 0, 0};  ///< whose attributes; in the order of the shape's weights
  int n_vertices = 1;
  bool front_facing = true;
  std::uint32_t primitive = 0;  ///< index in the draw, whatever its id
};

/// Order-free ties: at equal depth the lower key wins, whatever the submission (C6).
[[nodiscard]] inline bool key_before(const Piece& a, const Piece& b) {
  if (a.ids.draw != b.ids.draw) return a.ids.draw < b.ids.draw;
  if (a.ids.primitive != b.ids.primitive) return a.ids.primitive < b.ids.primitive;
  if (a.number != b.number) return a.number < b.number;
  return a.draw < b.draw;
}

/// Things of one kind that stay where they are, and whose memory is used again after `clear`.
template <class T>
class Recycled {
 public:
  void clear() { n_ = 0; }
  /// One more; it may be an old one, with what was in it.
  [[nodiscard]] T& next() {
    if (n_ == items_.size()) items_.push_back(std::make_unique<T>());
    return *items_[n_++];
  }

 private:
  std::vector<std::unique_ptr<T>> items_;
  std::size_t n_ = 0;
};

/// What one worker assembles at a time: some primitives of one draw.
struct AssemblyPart {
  std::uint32_t draw = 0;
  std::size_t first = 0, end = 0;  ///< of the draw's primitives that are wanted
  std::vector<Piece> pieces;
  Recycled<ClippedPolygon> polygons;
  Recycled<Surfel> surfels;
  FrameStats stats;
};

struct Assembly {
  std::vector<Piece> pieces;  ///< by draw, primitive, number
  FrameStats stats;           ///< draws, primitives and pieces
  std::vector<AssemblyPart> parts;  ///< where the pieces' polygons and surfels are; perhaps more than are in use
};

/// The sign of det(x, y, w) of three clip-space corners, computed in canonical order: +1 counter-clockwise on screen.
[[nodiscard]] int facing_sign(const std::array<glm::dvec4, 3>& corners);

/// Whether a triangle of this sign is dropped: +1 counter-clockwise on screen, −1 clockwise, 0 neither.
[[nodiscard]] bool culled(Cull cull, int sign);

[[nodiscard]] Assembly assemble(const Frame& frame, glm::ivec2 target_size_px, int n_workers);

/// Which of a draw's primitives are wanted: all, or those listed.
struct Selection {
  bool all = true;
  std::span<const std::uint32_t> primitives;
};

/// The same of some primitives only (`selections` has one for each draw, or is empty), in an assembly whose memory is
/// used again.
void assemble(const Frame& frame, glm::ivec2 target_size_px, std::span<const Selection> selections, int n_workers,
              Assembly& all);

/// Pixels of the target that a draw may write.
[[nodiscard]] PixelBox drawable_pixels(const Frame& frame, const Draw& draw, glm::ivec2 target_size_px);

}  // namespace lode::raster::reference
