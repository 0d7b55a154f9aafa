#pragma once
/// A wavy square of right triangles of one size, for benchmarks.

#include <cstdint>
#include <glm/vec3.hpp>
#include <vector>

namespace lode::bench {

struct GridMesh {
  std::vector<glm::vec3> positions;
  std::vector<std::uint32_t> indices;
  [[nodiscard]] std::size_t n_triangles() const { return indices.size() / 3; }
};

/// n × n cells over [−extent, extent]², two triangles a cell, clockwise with y up; z from 0.3 to 0.5.
inline GridMesh grid_mesh(int n, float extent = 1.0f) {
  GridMesh mesh;
  for (int y = 0; y <= n; ++y) {
    for (int x = 0; x <= n; ++x) {
      const float bump = float((x * 5 + y * 3) % 8) / 40.0f;
      mesh.positions.emplace_back(extent * (2.0f * float(x) / float(n) - 1.0f),
                                  extent * (2.0f * float(y) / float(n) - 1.0f), 0.3f + bump);
    }
  }
  for (int y = 0; y < n; ++y) {
    for (int x = 0; x < n; ++x) {
      const auto a = std::uint32_t(y * (n + 1) + x), b = a + 1, c = a + std::uint32_t(n) + 1, d = c + 1;
      mesh.indices.insert(mesh.indices.end(), {a, c, b, b, c, d});
    }
  }
  return mesh;
}

}  // namespace lode::bench
