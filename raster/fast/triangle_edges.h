#pragma once
/// What every triangle made ready for the kernels begins with: its edge functions and what weights are divided by (C7).

#include <array>

#include "raster/reference/assemble.h"

namespace lode::raster::fast {

/// Relative to a point of the window, a tile's corner. Small i is the canonical vertex (C7).
struct TriangleEdges {
  // Exact: whole numbers below 2^53. Edge i at p is edge_x·p.x + edge_y·p.y + edge_c, p in 1/256 px.
  std::array<double, 3> edge_x{}, edge_y{}, edge_c{};
  std::array<double, 3> w{};
  bool affine = true;  ///< the three w are bitwise equal: the weights' sum is 1 everywhere
};

[[nodiscard]] inline TriangleEdges make_triangle_edges(const reference::Triangle& shape, glm::ivec2 origin_fx8) {
  TriangleEdges t;
  const std::array<reference::EdgeFunction, 3> edges = reference::edges_of(shape);
  for (std::size_t i = 0; i < 3; ++i) {
    t.edge_x[i] = -double(edges[i].dy), t.edge_y[i] = double(edges[i].dx);
    t.edge_c[i] = double(edges[i].at(origin_fx8));
    t.w[i] = shape.v[i].w;
  }
  t.affine = shape.affine;
  return t;
}

}  // namespace lode::raster::fast
