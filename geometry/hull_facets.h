#pragma once
/// The growing polyhedron of convex_hull (hull.h): triangles that know their neighbours, each with a list of points
/// outside of it that are still to be reached.

#include <array>
#include <cstdint>
#include <glm/vec3.hpp>
#include <span>
#include <vector>

namespace lode::geometry {

class HullFacets {
 public:
  using Triangle = std::array<std::uint32_t, 3>;

  /// Starts from the tetrahedron of four of the points that lie in no plane, and hands out all others. Borrows them.
  HullFacets(std::span<const glm::dvec3> points, const std::array<std::uint32_t, 4>& tetrahedron);

  /// Adds points until none is outside.
  void grow();

  struct Facet {
    Triangle corners;     ///< counter-clockwise from outside
    Triangle neighbours;  ///< of edge i, from corner i to corner i + 1
    std::uint32_t first_outside = kNone;
    bool alive = true;
  };
  static constexpr std::uint32_t kNone = 0xFFFFFFFFu;
  /// Also those that are no more (not alive).
  [[nodiscard]] std::span<const Facet> facets() const { return facets_; }

 private:
  /// An edge of what the new point sees, from `a` to `b` as the facet that goes has it, and the facet that stays.
  struct HorizonEdge {
    std::uint32_t a, b, stays;
  };

  [[nodiscard]] bool sees(std::uint32_t point, std::uint32_t facet) const;
  [[nodiscard]] std::uint32_t farthest_outside(std::uint32_t facet) const;
  void hand_out(std::uint32_t point, std::uint32_t first_facet);
  void find_visible(std::uint32_t point, std::uint32_t facet);
  void add(std::uint32_t point, std::uint32_t facet);

  std::span<const glm::dvec3> points_;
  std::vector<Facet> facets_;
  std::vector<std::uint32_t> next_outside_;  ///< [points] in the list of a facet
  std::vector<std::uint32_t> starting_at_;   ///< [points] the new facet whose horizon edge starts there
  std::vector<std::uint32_t> looked_at_;     ///< [facets] by which addition it was seen, 2·n + 1, or not, 2·n
  std::vector<std::uint32_t> visible_;
  std::vector<HorizonEdge> horizon_;
  std::uint32_t n_additions_ = 0;
};

}  // namespace lode::geometry
