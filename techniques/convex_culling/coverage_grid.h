#pragma once
/// Silhouettes sampled on the planes of the axes, with a count of hulls at each sample: the area of the union of many
/// hulls stays known while hulls come and go.

#include <array>
#include <cstdint>
#include <glm/vec3.hpp>
#include <span>
#include <vector>

#include "geometry/bounds.h"

namespace lode::techniques::convex_culling {

/// What a hull covers of the three planes: on line first + i the samples low…high − 1.
struct GridFootprint {
  struct Run {
    std::uint16_t low, high;
  };
  struct Plane {
    int first = 0;
    std::vector<Run> runs;
  };
  std::array<Plane, 3> planes;

  [[nodiscard]] std::int64_t n_samples() const {
    std::int64_t n = 0;
    for (const Plane& plane : planes) {
      for (const Run& run : plane.runs) n += run.high - run.low;
    }
    return n;
  }
};

class CoverageGrid {
 public:
  /// n × n samples over the box's rectangle on each plane, in the middles of n × n cells. n in 1…1024.
  CoverageGrid(const geometry::Bounds& bounds, int n);

  /// Of the convex hull of the points named.
  [[nodiscard]] GridFootprint footprint(std::span<const glm::vec3> positions,
                                        std::span<const std::uint32_t> hull) const;

  void add(const GridFootprint& hull);
  void remove(const GridFootprint& hull);  ///< one that was added

  /// The area of the union: samples with a hull times the cell's area, on all three planes.
  [[nodiscard]] double area() const;
  /// The samples with a hull on each plane; integers, so that what is taken back is taken back exactly.
  [[nodiscard]] const std::array<std::int64_t, 3>& covered() const { return covered_; }
  [[nodiscard]] double area_of(const std::array<std::int64_t, 3>& n_samples) const;

 private:
  int n_;
  geometry::Bounds bounds_;
  std::array<std::vector<std::uint32_t>, 3> counts_;  ///< [n · n] line by line
  std::array<std::int64_t, 3> covered_{};
};

}  // namespace lode::techniques::convex_culling
