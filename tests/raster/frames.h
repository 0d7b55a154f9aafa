#pragma once
/// Frames and images for tests, in one line.

#include "both_pipelines.h"

namespace lode::raster::test {

[[nodiscard]] inline Frame frame_of(std::span<const Draw> draws) {
  Frame frame;
  frame.draws = draws;
  return frame;
}
[[nodiscard]] inline Frame frame_of(const Draw& draw) { return frame_of({&draw, 1}); }  ///< which must outlive it

[[nodiscard]] inline Draw triangles_of(const Vertices& vertices) {
  Draw draw;
  draw.vertices = vertices;
  return draw;
}

[[nodiscard]] inline RenderOptions workers_and_tiles(int threads, int tile_size_px) {
  RenderOptions options;
  options.threads = threads;
  options.tile_size_px = tile_size_px;
  return options;
}

}  // namespace lode::raster::test
