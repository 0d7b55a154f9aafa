#include "geometry/inner_boxes.h"

#include <algorithm>
#include <array>
#include <optional>
#include <stdexcept>
#include <string>
#include <utility>

#include "geometry/inner_grid.h"

namespace lode::geometry {
namespace {

constexpr std::size_t kDeepSeeds = 16;    // cells with the largest cubes around them
constexpr std::size_t kSpreadSeeds = 48;  // evenly over all that are not covered
constexpr int kBisections = 6;            // of a cell, when a box grows on beyond the grid

/// Moves a side of the box by one cell, if all stays inside. side: 2·axis, + 1 for the upper one.
bool grow(const InnerGrid& grid, CellBox& box, int side) {
  const int axis = side / 2;
  CellBox next = box;
  if (side % 2 == 0 ? --next.low[axis] < 0 : ++next.high[axis] > grid.size()[axis]) return false;
  if (!grid.all_inside(next)) return false;
  box = next;
  return true;
}

/// As far as it goes along one axis after the other.
CellBox grown_along(const InnerGrid& grid, CellBox box, const std::array<int, 3>& axes) {
  for (const int axis : axes) {
    while (grow(grid, box, 2 * axis)) continue;
    while (grow(grid, box, 2 * axis + 1)) continue;
  }
  return box;
}

/// All sides in turn.
CellBox grown_evenly(const InnerGrid& grid, CellBox box) {
  for (bool grew = true; grew;) {
    grew = false;
    for (int side = 0; side < 6; ++side) grew = grow(grid, box, side) || grew;
  }
  return box;
}

/// Cells between it and the nearest that is not inside, along the axes and diagonally.
int depth(const InnerGrid& grid, const glm::ivec3& i) {
  int n = 0;
  const auto fits = [&](int reach) {
    const CellBox cube = {i - reach, i + reach + 1};
    for (int axis = 0; axis < 3; ++axis) {
      if (cube.low[axis] < 0 || cube.high[axis] > grid.size()[axis]) return false;
    }
    return grid.all_inside(cube);
  };
  while (fits(n + 1)) ++n;
  return n;
}

std::vector<glm::ivec3> seeds(const InnerGrid& grid) {
  std::vector<std::pair<int, glm::ivec3>> cells;  // by −depth
  for (int z = 0; z < grid.size().z; ++z) {
    for (int y = 0; y < grid.size().y; ++y) {
      for (int x = 0; x < grid.size().x; ++x) {
        const glm::ivec3 i(x, y, z);
        if (grid.uncovered_cell(i)) cells.emplace_back(-depth(grid, i), i);
      }
    }
  }
  std::vector<glm::ivec3> result;
  const std::size_t step = std::max<std::size_t>(1, cells.size() / kSpreadSeeds);
  for (std::size_t k = step / 2; k < cells.size(); k += step) result.push_back(cells[k].second);
  std::ranges::stable_sort(cells, {}, [](const auto& cell) { return cell.first; });
  for (std::size_t k = 0; k < std::min(cells.size(), kDeepSeeds); ++k) result.push_back(cells[k].second);
  return result;
}

struct FloatBox {
  std::array<glm::vec3, 2> ends;  ///< low, high
};

struct Candidate {
  CellBox cells;
  double added = 0.0;  ///< volume not covered before
};

/// As it leaves its grid.
struct GridBox {
  FloatBox box;
  FloatBox limits;  ///< a cell farther out on all sides, where there is one
  double added = 0.0;
};

GridBox leave(const InnerGrid& grid, const Candidate& c) {
  return {
      {{grid.corner(c.cells.low), grid.corner(c.cells.high)}},
      {{grid.corner(glm::max(c.cells.low - 1, glm::ivec3(0))), grid.corner(glm::min(c.cells.high + 1, grid.size()))}},
      c.added};
}

/// Of the boxes grown from all seeds the one with the greatest product of silhouettes, seen along the axes, and of the
/// share of it that is new; the first of equal ones.
std::optional<Candidate> best_box(const InnerGrid& grid) {
  static constexpr std::array<std::array<int, 3>, 6> kOrders = {
      {{0, 1, 2}, {0, 2, 1}, {1, 0, 2}, {1, 2, 0}, {2, 0, 1}, {2, 1, 0}}};
  std::optional<Candidate> best;
  double best_score = 0.0;
  const auto consider = [&](const CellBox& box) {
    const glm::dvec3 side = glm::dvec3(grid.corner(box.high)) - glm::dvec3(grid.corner(box.low));
    const double added = grid.uncovered(box), volume = side.x * side.y * side.z;
    const double score = (side.x * side.y + side.y * side.z + side.z * side.x) * (added / volume);
    if (!(score > best_score)) return;
    best = Candidate{box, added};
    best_score = score;
  };
  const CellBox everything = {glm::ivec3(0), grid.size()};
  if (grid.all_inside(everything)) {
    consider(everything);
    return best;
  }
  for (const glm::ivec3& seed : seeds(grid)) {
    consider(grown_evenly(grid, {seed, seed + 1}));
    for (const auto& axes : kOrders) consider(grown_along(grid, {seed, seed + 1}, axes));
  }
  return best;
}

bool is_inside(const Solid& solid, const FloatBox& box) { return solid.contains_box(box.ends[0], box.ends[1]); }

/// The cells' box, or what is left of it after it shrank until it is proven to be inside.
std::optional<FloatBox> proven(const Solid& solid, const FloatBox& box) {
  const glm::vec3 centre = 0.5f * box.ends[0] + 0.5f * box.ends[1];
  for (const float left : {1.0f, 0.9999f, 0.99f, 0.95f, 0.9f, 0.8f}) {
    const FloatBox next = {{centre + (box.ends[0] - centre) * left, centre + (box.ends[1] - centre) * left}};
    if (is_inside(solid, left == 1.0f ? box : next)) return left == 1.0f ? box : next;
  }
  return std::nullopt;
}

/// Moves one side towards `limit`, as far as halving the way finds.
void grow_side(const Solid& solid, FloatBox& box, std::size_t end, int axis, float limit) {
  for (int k = 0; k <= kBisections && box.ends[end][axis] != limit; ++k) {
    FloatBox next = box;
    next.ends[end][axis] = limit;
    if (is_inside(solid, next)) {
      box = next;
      return;
    }
    limit = 0.5f * limit + 0.5f * box.ends[end][axis];
  }
}

/// Grows each side by a cell at most, which the surface passes through.
void grow_to_surface(const Solid& solid, const FloatBox& limits, FloatBox& box) {
  for (int axis = 0; axis < 3; ++axis) {
    for (std::size_t end = 0; end < 2; ++end) grow_side(solid, box, end, axis, limits.ends[end][axis]);
  }
}

void check(const InnerBoxesParams& params) {
  const bool good = params.resolution >= 1 && params.resolution <= 64 && params.n_most >= 0 && params.n_most <= 1000 &&
                    params.least_share >= 0.001 && params.least_share <= 1.0;
  if (!good) {
    throw std::logic_error(
        "inner_boxes: expected resolution in [1, 64], n_most in [0, 1000], least_share in "
        "[0.001, 1], found " +
        std::to_string(params.resolution) + ", " + std::to_string(params.n_most) + ", " +
        std::to_string(params.least_share));
  }
}

}  // namespace

std::vector<Bounds> inner_boxes(const Solid& solid, const InnerBoxesParams& params) {
  check(params);
  const double least = params.least_share * solid.volume();
  std::vector<GridBox> found;
  for (std::size_t part = 0; part < solid.parts().size(); ++part) {
    if (solid.parts()[part].volume < least) continue;
    InnerGrid grid(solid, part, params.resolution);
    for (int n = 0; n < params.n_most; ++n) {
      const std::optional<Candidate> best = best_box(grid);
      if (!best || best->added < least) break;
      grid.cover(best->cells);
      found.push_back(leave(grid, *best));
    }
  }
  std::ranges::stable_sort(found, {}, [](const GridBox& g) { return -g.added; });
  std::vector<Bounds> boxes;
  for (const GridBox& grid_box : found) {
    if (boxes.size() >= std::size_t(params.n_most)) break;
    std::optional<FloatBox> box = proven(solid, grid_box.box);
    if (!box) continue;
    grow_to_surface(solid, grid_box.limits, *box);
    boxes.push_back({glm::dvec3(box->ends[0]), glm::dvec3(box->ends[1])});
  }
  return boxes;
}

}  // namespace lode::geometry
