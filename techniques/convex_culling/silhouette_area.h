#pragma once
/// Silhouette areas in orthographic projection on the planes of the axes, and the orthographic error between a model
/// and an approximation by hulls. Onozawa & Kitazawa, sec. 2.1, eq. 2.

#include <array>
#include <cstdint>
#include <glm/vec3.hpp>
#include <span>
#include <vector>

#include "techniques/convex_culling/line_union.h"

namespace lode::techniques::convex_culling {

using Triangle = std::array<std::uint32_t, 3>;

/// A point without one coordinate: its projection on the yz, zx or xy plane (axis 0, 1, 2).
[[nodiscard]] inline glm::dvec2 along_axis(const glm::vec3& p, int axis) {
  return {double(p[(axis + 1) % 3]), double(p[(axis + 2) % 3])};
}

/// Works with memory that it keeps from call to call.
class SilhouetteArea {
 public:
  explicit SilhouetteArea(int n_lines) : n_lines_(n_lines) {}
  void set_lines(int n_lines) { n_lines_ = n_lines; }

  /// A(S): the areas of the three silhouettes added up, each the area of a union. `vertices`: at least those of the
  /// triangles; their box places the lines.
  [[nodiscard]] double of_triangles(std::span<const glm::vec3> positions, std::span<const Triangle> triangles,
                                    std::span<const std::uint32_t> vertices);

  struct Areas {
    double model = 0.0;  ///< A(S)
    double hulls = 0.0;  ///< A(Γ)
    /// E(S, Γ), eq. 2.
    [[nodiscard]] double error() const { return model > hulls ? model - hulls : hulls - model; }
  };
  /// Both on the same lines, those of the vertices' box; `hulls` are lists of positions' indices.
  [[nodiscard]] Areas of_both(std::span<const glm::vec3> positions, std::span<const Triangle> triangles,
                              std::span<const std::uint32_t> vertices,
                              std::span<const std::vector<std::uint32_t>> hulls);

 private:
  int n_lines_;
  LineUnion lines_;
  std::vector<glm::dvec2> flat_;
};

}  // namespace lode::techniques::convex_culling
