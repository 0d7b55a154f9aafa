#pragma once
/// A part of a solid cut into cells by planes along the axes, and which cells seem to be inside. Planes are not evenly
/// spaced: they are put where the part has faces across an axis, so that walls thinner than a cell fill theirs.

#include <array>
#include <cstddef>
#include <cstdint>
#include <glm/vec3.hpp>
#include <vector>

#include "geometry/solid.h"

namespace lode::geometry {

/// Cells [low, high), counted along each axis.
struct CellBox {
  glm::ivec3 low{0}, high{0};
  bool operator==(const CellBox&) const = default;
};

class InnerGrid {
 public:
  /// resolution   cells on the part's longest side, 1…64; at least an eighth of it, rounded up, on the others
  ///   cost       O(cells + cells in the boxes of triangles), and a line through each column
  InnerGrid(const Solid& solid, std::size_t part, int resolution);

  /// Cells along each axis, ≥ 1.
  [[nodiscard]] const glm::ivec3& size() const { return size_; }
  /// The corner of cell i's, and of the cell before: 0 ≤ i ≤ size.
  [[nodiscard]] glm::vec3 corner(const glm::ivec3& i) const {
    return {planes_[0][std::size_t(i.x)], planes_[1][std::size_t(i.y)], planes_[2][std::size_t(i.z)]};
  }
  /// Whether all cells of a box are inside, as far as rounded numbers tell. O(1).
  [[nodiscard]] bool all_inside(const CellBox& box) const;

  /// Volume of the cells of a box that are inside and not covered yet. O(1).
  [[nodiscard]] double uncovered(const CellBox& box) const;
  void cover(const CellBox& box);
  [[nodiscard]] bool uncovered_cell(const glm::ivec3& i) const { return inside_[cell(i)] && !covered_[cell(i)]; }

 private:
  [[nodiscard]] std::size_t cell(const glm::ivec3& i) const {
    return (std::size_t(i.z) * std::size_t(size_.y) + std::size_t(i.y)) * std::size_t(size_.x) + std::size_t(i.x);
  }
  [[nodiscard]] CellBox cells_of(const SpaceTriangle& triangle) const;
  void find_cells_inside(const Solid& solid, std::size_t part);
  void sum_up();

  std::array<std::vector<float>, 3> planes_;  ///< ascending
  glm::ivec3 size_{0};
  std::vector<std::uint8_t> inside_;    ///< [cells]
  std::vector<std::uint8_t> covered_;   ///< [cells]
  std::vector<std::int32_t> n_inside_;  ///< [corners] cells before the corner that are
  std::vector<double> uncovered_;       ///< [corners] their volume, without those covered
};

}  // namespace lode::geometry
