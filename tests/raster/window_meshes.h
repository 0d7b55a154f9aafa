#pragma once
/// Random triangulations in window coordinates whose union is known: every sample inside the outline belongs to
/// exactly one triangle. Half of the vertices lie on sample centres or pixel edges. All predicates are exact.

#include <algorithm>
#include <utility>

#include "coverage_count.h"

namespace lode::raster::test {

struct WindowMesh {
  std::vector<Corners> triangles;   ///< clockwise as seen on screen
  std::vector<glm::ivec2> outline;  ///< likewise
};

/// Where a jittered vertex of a lattice lands: in the open cell around `at`, at times on a centre or a pixel edge.
[[nodiscard]] inline std::int32_t jittered(HashedNumbers& random, std::int32_t at, std::int32_t cell) {
  const std::int32_t reach = std::max((cell - 1) / 2, 0);
  const std::int32_t x = at + random.between(-reach, reach);
  const std::int32_t grid = 128 * ((x + 64) >> 7);
  return random.below(2) == 0 && std::abs(grid - at) <= reach ? grid : x;
}

/// Two triangles, along the diagonal that leaves neither turned over.
inline void add_quad(HashedNumbers& random, WindowMesh& mesh, glm::ivec2 a, glm::ivec2 b, glm::ivec2 c, glm::ivec2 d) {
  const bool ac_valid = doubled_area({a, b, c}) >= 0 && doubled_area({a, c, d}) >= 0;
  const bool bd_valid = doubled_area({b, c, d}) >= 0 && doubled_area({b, d, a}) >= 0;
  if (ac_valid && (!bd_valid || random.below(2) == 0)) {
    mesh.triangles.insert(mesh.triangles.end(), {{a, b, c}, {a, c, d}});
  } else {
    mesh.triangles.insert(mesh.triangles.end(), {{b, c, d}, {b, d, a}});
  }
}

/// n × m quads over the rectangle from (0, 0) to size_fx8, inner vertices moved anywhere in their cells.
[[nodiscard]] inline WindowMesh grid_mesh(HashedNumbers& random, glm::ivec2 size_fx8, int n, int m) {
  const glm::ivec2 cell{size_fx8.x / n, size_fx8.y / m};
  std::vector<glm::ivec2> v;
  for (int j = 0; j <= m; ++j) {
    for (int i = 0; i <= n; ++i) {
      const std::int32_t x = i == n ? size_fx8.x : i * cell.x, y = j == m ? size_fx8.y : j * cell.y;
      const std::int32_t moved_x = i == 0 || i == n ? x : jittered(random, x, cell.x);
      v.push_back({moved_x, j == 0 || j == m ? y : jittered(random, y, cell.y)});
    }
  }
  WindowMesh mesh;
  const auto at = [&](int i, int j) { return v[std::size_t(j * (n + 1) + i)]; };
  for (int j = 0; j < m; ++j) {
    for (int i = 0; i < n; ++i) add_quad(random, mesh, at(i, j), at(i + 1, j), at(i + 1, j + 1), at(i, j + 1));
  }
  mesh.outline = {{0, 0}, {size_fx8.x, 0}, size_fx8, {0, size_fx8.y}};
  return mesh;
}

/// n quads side by side: a strip with a ragged top in the upper half and a ragged bottom in the lower one.
[[nodiscard]] inline WindowMesh strip_mesh(HashedNumbers& random, glm::ivec2 size_fx8, int n) {
  const std::int32_t cell = size_fx8.x / n, quarter = size_fx8.y / 4;
  std::vector<glm::ivec2> top, bottom;
  for (int i = 0; i <= n; ++i) {
    top.push_back({jittered(random, i * cell, cell), jittered(random, quarter, 2 * quarter)});
    bottom.push_back({jittered(random, i * cell, cell), jittered(random, 3 * quarter, 2 * quarter)});
  }
  WindowMesh mesh;
  for (std::size_t i = 0; i < std::size_t(n); ++i) add_quad(random, mesh, top[i], top[i + 1], bottom[i + 1], bottom[i]);
  mesh.outline = top;
  mesh.outline.insert(mesh.outline.end(), bottom.rbegin(), bottom.rend());
  return mesh;
}

/// Random points sorted by their angle around a centre, one triangle between each two neighbours.
[[nodiscard]] inline WindowMesh fan_mesh(HashedNumbers& random, int size_px, int n) {
  const glm::ivec2 centre = 256 + random_point_fx8(random, size_px - 2);
  std::vector<glm::ivec2> ring = {{0, 0}, {256 * size_px, 0}, {256 * size_px, 256 * size_px}, {0, 256 * size_px}};
  for (int i = 0; i < n; ++i) ring.push_back(random_point_fx8(random, size_px));
  const auto side = [&](glm::ivec2 p) { return p.y > centre.y || (p.y == centre.y && p.x > centre.x) ? 0 : 1; };
  const auto before = [&](glm::ivec2 p, glm::ivec2 q) {
    if (side(p) != side(q)) return side(p) < side(q);
    return doubled_area({centre, p, q}) > 0;
  };
  std::erase(ring, centre);
  std::stable_sort(ring.begin(), ring.end(), before);
  const auto same_angle = [&](glm::ivec2 p, glm::ivec2 q) { return !before(p, q) && !before(q, p); };
  ring.erase(std::unique(ring.begin(), ring.end(), same_angle), ring.end());
  WindowMesh mesh;
  for (std::size_t i = 0; i < ring.size(); ++i)
    mesh.triangles.push_back({centre, ring[i], ring[(i + 1) % ring.size()]});
  mesh.outline = ring;
  return mesh;
}

/// The square from (0, 0) to size_px, n points dropped into it one after the other, each splitting the triangles it
/// lies in: many slivers.
[[nodiscard]] inline WindowMesh split_mesh(HashedNumbers& random, int size_px, int n) {
  const std::int32_t s = 256 * size_px;
  WindowMesh mesh;
  mesh.outline = {{0, 0}, {s, 0}, {s, s}, {0, s}};
  mesh.triangles = {{{{0, 0}, {s, 0}, {s, s}}}, {{{0, 0}, {s, s}, {0, s}}}};
  for (int i = 0; i < n; ++i) {
    glm::ivec2 p = random_point_fx8(random, size_px);
    if (random.below(4) == 0) {  // on or beside an edge
      const Corners& t = mesh.triangles[random.below(std::uint32_t(mesh.triangles.size()))];
      p = (t[0] + t[1]) / 2;
    }
    std::vector<Corners> split;
    for (const Corners& t : mesh.triangles) {
      const Corners parts[3] = {{t[0], t[1], p}, {t[1], t[2], p}, {t[2], t[0], p}};
      const bool inside = std::all_of(parts, parts + 3, [](const Corners& part) { return doubled_area(part) >= 0; });
      if (!inside) {
        split.push_back(t);
      } else {
        std::copy_if(parts, parts + 3, std::back_inserter(split),
                     [](const Corners& part) { return doubled_area(part) > 0; });
      }
    }
    mesh.triangles = std::move(split);
  }
  return mesh;
}

/// Whether p lies strictly inside the circle through a triangle's corners.
[[nodiscard]] inline bool in_circle(const Corners& t, glm::ivec2 p) {
  const std::int64_t ax = t[0].x - p.x, ay = t[0].y - p.y, bx = t[1].x - p.x, by = t[1].y - p.y, cx = t[2].x - p.x,
                     cy = t[2].y - p.y;
  const Int128 a = ax * ax + ay * ay, b = bx * bx + by * by, c = cx * cx + cy * cy;
  return a * (bx * cy - cx * by) - b * (ax * cy - cx * ay) + c * (ax * by - bx * ay) > 0;
}

/// The Delaunay triangulation of n random points in the square from (0, 0) to size_px, and its corners (Bowyer 1981,
/// Watson 1981).
[[nodiscard]] inline WindowMesh delaunay_mesh(HashedNumbers& random, int size_px, int n) {
  const std::int32_t s = 256 * size_px;
  WindowMesh mesh;
  mesh.outline = {{0, 0}, {s, 0}, {s, s}, {0, s}};
  mesh.triangles = {{{{0, 0}, {s, 0}, {s, s}}}, {{{0, 0}, {s, s}, {0, s}}}};
  for (int i = 0; i < n; ++i) {
    const glm::ivec2 p = random_point_fx8(random, size_px);
    std::vector<std::pair<glm::ivec2, glm::ivec2>> hole;  // directed edges of the triangles taken out
    std::erase_if(mesh.triangles, [&](const Corners& t) {
      if (!in_circle(t, p)) return false;
      for (std::size_t k = 0; k < 3; ++k) hole.emplace_back(t[k], t[(k + 1) % 3]);
      return true;
    });
    for (const auto& [a, b] : hole) {
      const bool inner = std::find(hole.begin(), hole.end(), std::pair(b, a)) != hole.end();
      if (!inner && doubled_area({a, b, p}) > 0) mesh.triangles.push_back({a, b, p});
    }
  }
  return mesh;
}

/// One of the above, in a square of size_px, at times with x and y exchanged.
[[nodiscard]] inline WindowMesh random_mesh(HashedNumbers& random, int size_px) {
  const glm::ivec2 size_fx8(256 * size_px);
  const glm::ivec2 cells{random.between(1, 24), random.between(1, 24)};
  WindowMesh mesh;
  switch (random.below(5)) {
    case 0:
      mesh = grid_mesh(random, size_fx8, cells.x, cells.y);
      break;
    case 1:
      mesh = strip_mesh(random, size_fx8, random.between(1, 4 * size_px));
      break;
    case 2:
      mesh = fan_mesh(random, size_px, random.between(0, 64));
      break;
    case 3:
      mesh = split_mesh(random, size_px, random.between(0, 24));
      break;
    default:
      mesh = delaunay_mesh(random, size_px, random.between(0, 48));
      break;
  }
  if (random.below(2) == 0) {
    for (Corners& t : mesh.triangles) t = {{{t[0].y, t[0].x}, {t[2].y, t[2].x}, {t[1].y, t[1].x}}};
    for (glm::ivec2& p : mesh.outline) std::swap(p.x, p.y);
    std::reverse(mesh.outline.begin(), mesh.outline.end());
  }
  return mesh;
}

/// Draws the mesh into counters of the window [0, size_px). Returns the number of samples whose count is not the
/// outline's winding number; a gap and a double each count once. Adds the samples tested to n_tests.
[[nodiscard]] inline int wrong_samples(const WindowMesh& mesh, int size_px, std::uint64_t& n_tests) {
  CoverageCount count({{0, 0}, {size_px, size_px}});
  for (const Corners& t : mesh.triangles) n_tests += count.add(t);
  const std::vector<std::int8_t> expected = winding_numbers(mesh.outline, glm::ivec2(size_px));
  int wrong = 0;
  std::size_t i = 0;
  count.for_each([&](glm::ivec2, int n) { wrong += n != expected[i++]; });
  return wrong;
}

}  // namespace lode::raster::test
