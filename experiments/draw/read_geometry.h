#pragma once
/// Reads the geometry of a draw: positions, and for discs and surfels what comes with each of them.

#include <span>
#include <string_view>

#include "experiments/draw/picture.h"
#include "experiments/draw/read_draw.h"
#include "geometry/json/json_view.h"

namespace lode::experiments {

enum class Space { window, clip, discs, surfels };

/// A key that gives a draw its geometry.
struct GeometryKey {
  std::string_view key;
  raster::Topology topology;
  Space space;
  int vertices_each;  ///< the number of vertices is a multiple of this

  [[nodiscard]] bool is_line() const {
    return topology == raster::Topology::lines || topology == raster::Topology::line_strip;
  }
};

[[nodiscard]] std::span<const GeometryKey> geometry_keys();

/// Sets the draw's positions, and normals, radii and colours where the geometry has them.
void read_geometry(const geometry::JsonView& view, const GeometryKey& key, const DrawContext& context,
                   PictureDraw& draw);

/// A length in the picture's unit, such as a point's size, in px. Lengths up to 65536 px are exact in float.
[[nodiscard]] float read_length_px(const geometry::JsonView& view, const DrawContext& context);

}  // namespace lode::experiments
