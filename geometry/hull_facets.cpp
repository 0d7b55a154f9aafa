#include "geometry/hull_facets.h"

#include <glm/geometric.hpp>
#include <utility>

#include "geometry/predicates.h"

namespace lode::geometry {

HullFacets::HullFacets(std::span<const glm::dvec3> points, const std::array<std::uint32_t, 4>& tetrahedron)
    : points_(points), next_outside_(points.size(), kNone), starting_at_(points.size(), kNone) {
  auto [a, b, c, d] = tetrahedron;
  if (orientation(points[a], points[b], points[c], points[d]) > 0) std::swap(b, c);  // d is behind abc
  facets_ = {{{a, b, c}, {1, 2, 3}}, {{b, a, d}, {0, 3, 2}}, {{c, b, d}, {0, 1, 3}}, {{a, c, d}, {0, 2, 1}}};
  looked_at_.assign(facets_.size(), 0);
  for (std::uint32_t p = std::uint32_t(points.size()); p-- > 0;) hand_out(p, 0);
}

bool HullFacets::sees(std::uint32_t point, std::uint32_t facet) const {
  const auto [a, b, c] = facets_[facet].corners;
  return orientation(points_[a], points_[b], points_[c], points_[point]) > 0;
}

/// To the first of the facets from `first_facet` on that it sees. A point that sees none of the facets made for a new
/// corner, instead of some that it saw one of, is in the polyhedron: it would see both sides of an edge of the horizon
/// otherwise, and hence the new facet there, too.
void HullFacets::hand_out(std::uint32_t point, std::uint32_t first_facet) {
  for (std::uint32_t f = first_facet; f < facets_.size(); ++f) {
    if (!sees(point, f)) continue;
    next_outside_[point] = std::exchange(facets_[f].first_outside, point);
    return;
  }
}

/// About the farthest one (rounded distances; of equal ones the first in the list). Any would do; far ones leave less.
std::uint32_t HullFacets::farthest_outside(std::uint32_t facet) const {
  const auto [a, b, c] = facets_[facet].corners;
  const glm::dvec3 normal = glm::cross(points_[b] - points_[a], points_[c] - points_[a]);
  std::uint32_t farthest = facets_[facet].first_outside;
  double greatest = -1.0;
  for (std::uint32_t p = farthest; p != kNone; p = next_outside_[p]) {
    const double distance = glm::dot(normal, points_[p] - points_[a]);
    if (distance > greatest) greatest = distance, farthest = p;
  }
  return farthest;
}

/// All facets that the point sees hang together (they would if it moved a little inwards, which changes none of them),
/// and one closed line of edges without a knot surrounds them.
void HullFacets::find_visible(std::uint32_t point, std::uint32_t facet) {
  const std::uint32_t unseen = 2 * ++n_additions_, seen = unseen + 1;
  visible_ = {facet};
  horizon_.clear();
  looked_at_[facet] = seen;
  for (std::size_t k = 0; k < visible_.size(); ++k) {
    const Facet& f = facets_[visible_[k]];
    for (std::size_t i = 0; i < 3; ++i) {
      const std::uint32_t neighbour = f.neighbours[i];
      if (looked_at_[neighbour] < unseen) {
        looked_at_[neighbour] = sees(point, neighbour) ? seen : unseen;
        if (looked_at_[neighbour] == seen) visible_.push_back(neighbour);
      }
      if (looked_at_[neighbour] == unseen) horizon_.push_back({f.corners[i], f.corners[(i + 1) % 3], neighbour});
    }
  }
}

/// Replaces what the point sees by a cone of facets from it to the horizon. None is without area: a point on the line
/// of a horizon edge would be in the planes of both facets there, and see neither.
void HullFacets::add(std::uint32_t point, std::uint32_t facet) {
  find_visible(point, facet);
  const std::uint32_t first = std::uint32_t(facets_.size());
  for (const auto& [a, b, stays] : horizon_) {
    const std::uint32_t made = std::uint32_t(facets_.size());
    starting_at_[a] = made;
    facets_.push_back({{a, b, point}, {stays, kNone, kNone}});
    looked_at_.push_back(0);
    Facet& other = facets_[stays];
    for (std::size_t i = 0; i < 3; ++i) {
      if (other.corners[i] == b && other.corners[(i + 1) % 3] == a) other.neighbours[i] = made;
    }
  }
  for (std::uint32_t f = first; f < facets_.size(); ++f) {
    const std::uint32_t next = starting_at_[facets_[f].corners[1]];
    facets_[f].neighbours[1] = next;
    facets_[next].neighbours[2] = f;
  }
  for (const std::uint32_t f : visible_) {
    facets_[f].alive = false;
    for (std::uint32_t p = std::exchange(facets_[f].first_outside, kNone); p != kNone;) {
      const std::uint32_t next = next_outside_[p];
      if (p != point) hand_out(p, first);
      p = next;
    }
  }
}

void HullFacets::grow() {
  for (std::uint32_t f = 0; f < facets_.size(); ++f) {
    if (facets_[f].alive && facets_[f].first_outside != kNone) add(farthest_outside(f), f);
  }
}

}  // namespace lode::geometry
