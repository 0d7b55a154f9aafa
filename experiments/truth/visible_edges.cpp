#include "experiments/truth/visible_edges.h"

#include <algorithm>
#include <cstddef>

#include "geometry/trigonometry.h"
#include "raster/parallel.h"

namespace lode::experiments::truth {
namespace {

double length_of(std::uint64_t crossings, int grid) { return geometry::kPi / 4.0 * double(crossings) / double(grid); }

class Pixels {
 public:
  Pixels(glm::ivec2 size_px, std::span<const raster::Ids> ids) : size_px_(size_px), ids_(ids) {}

  std::size_t at(glm::ivec2 px) const { return std::size_t(px.y) * std::size_t(size_px_.x) + std::size_t(px.x); }

  std::uint64_t crossings() const {
    std::uint64_t n = 0;
    for_each_pair([&](glm::ivec2, glm::ivec2) { ++n; });
    return n;
  }

  /// Pixels within one of a crossing, or of those in `also`, in reading order.
  std::vector<glm::ivec2> near_edges(std::span<const glm::ivec2> also) const {
    std::vector<bool> marked(ids_.size());
    const auto mark_around = [&](glm::ivec2 px) {
      for (int y = std::max(px.y - 1, 0); y <= std::min(px.y + 1, size_px_.y - 1); ++y) {
        for (int x = std::max(px.x - 1, 0); x <= std::min(px.x + 1, size_px_.x - 1); ++x) marked[at({x, y})] = true;
      }
    };
    for_each_pair([&](glm::ivec2 a, glm::ivec2 b) {
      mark_around(a);
      mark_around(b);
    });
    for (const glm::ivec2 px : also) mark_around(px);
    std::vector<glm::ivec2> pixels;
    for (int y = 0; y < size_px_.y; ++y) {
      for (int x = 0; x < size_px_.x; ++x) {
        if (marked[at({x, y})]) pixels.emplace_back(x, y);
      }
    }
    return pixels;
  }

 private:
  /// visit(a, b) for neighbours with different ids.
  template <class Visit>
  void for_each_pair(Visit visit) const {
    for (int y = 0; y < size_px_.y; ++y) {
      for (int x = 0; x < size_px_.x; ++x) {
        const glm::ivec2 px(x, y), right(x + 1, y), below(x, y + 1);
        if (right.x < size_px_.x && ids_[at(px)] != ids_[at(right)]) visit(px, right);
        if (below.y < size_px_.y && ids_[at(px)] != ids_[at(below)]) visit(px, below);
      }
    }
  }

  glm::ivec2 size_px_;
  std::span<const raster::Ids> ids_;
};

/// Crossings on a grid of n × n points in one pixel, each with its right and its lower neighbour.
std::uint64_t crossings_in(glm::ivec2 px, int n, const IdsAt& ids_at) {
  std::vector<raster::Ids> above(std::size_t(n) + 1), row(std::size_t(n) + 1);
  std::uint64_t crossings = 0;
  for (int y = 0; y <= n; ++y) {
    for (int x = 0; x <= n; ++x) {
      row[std::size_t(x)] = ids_at(glm::dvec2(px) + (glm::dvec2(x, y) + 0.5) / double(n));
      if (x > 0 && y < n) crossings += row[std::size_t(x)] != row[std::size_t(x) - 1];
      if (y > 0 && x < n) crossings += row[std::size_t(x)] != above[std::size_t(x)];
    }
    std::swap(above, row);
  }
  return crossings;
}

}  // namespace

VisibleEdges visible_edges(glm::ivec2 size_px, std::span<const raster::Ids> ids, std::span<const glm::ivec2> also,
                           double enough_px, const IdsAt& ids_at, int threads) {
  const Pixels pixels(size_px, ids);
  VisibleEdges edges{length_of(pixels.crossings(), 1), 1};
  if (edges.length_px >= enough_px) return edges;
  const std::vector<glm::ivec2> fine = pixels.near_edges(also);
  const auto affordable = [&](int grid) { return fine.size() * std::uint64_t(grid) * grid <= kMaxEdgeRays; };
  for (int grid = 4; !fine.empty() && affordable(grid) && edges.length_px < enough_px; grid *= 2) {
    std::vector<std::uint64_t> crossings(fine.size());
    raster::parallel_for(fine.size(), raster::worker_count(threads),
                         [&](std::size_t i, int) { crossings[i] = crossings_in(fine[i], grid, ids_at); });
    std::uint64_t sum = 0;
    for (const std::uint64_t n : crossings) sum += n;
    edges = {length_of(sum, grid), grid};
  }
  return edges;
}

}  // namespace lode::experiments::truth
