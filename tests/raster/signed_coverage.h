#pragma once
/// How often each sample of a projected mesh must be covered, signed: a front-facing triangle counts +1, a back-facing
/// one −1 (the snap may turn small ones over; so the signed count is the one that is exact).
///
/// Added up over a mesh, the outlines of its projected triangles cancel along shared edges. What is left are the mesh's
/// own border and the cuts along the near and far planes: the signed count of a sample is the winding number of those
/// around it. A closed mesh that no plane cuts has 0 everywhere; from inside one, it is −1 everywhere.

#include <set>
#include <utility>

#include "coverage_count.h"
#include "frames.h"
#include "projection_scenes.h"
#include "raster/reference/assemble.h"

namespace lode::raster::test {

// ---- What is drawn.

struct SignedCoverage {
  std::vector<int> sum, count;  ///< per sample: front − back, front + back
  std::uint64_t n_tests = 0, n_front = 0, n_back = 0, n_clipped = 0,
                n_turned = 0;  ///< pieces, of which of cut triangles
};

[[nodiscard]] inline SignedCoverage signed_coverage(const Frame& frame, glm::ivec2 size_px) {
  SignedCoverage result;
  result.sum.assign(std::size_t(size_px.x) * std::size_t(size_px.y), 0);
  result.count = result.sum;
  const reference::Assembly assembly = reference::assemble(frame, size_px, 1);
  for (const reference::Piece& piece : assembly.pieces) {
    const auto& triangle = std::get<reference::Triangle>(piece.shape);
    ++(piece.front_facing ? result.n_front : result.n_back);
    result.n_clipped += triangle.polygon != nullptr;
    result.n_turned += triangle.polygon && triangle.polygon->has_turned_piece;
    result.n_tests += pixels_in(piece.bounds_px);
    reference::for_each_covered(triangle, piece.bounds_px, kCentre_fx8, [&](glm::ivec2 px) {
      const std::size_t i = std::size_t(px.y) * std::size_t(size_px.x) + std::size_t(px.x);
      result.sum[i] += piece.front_facing ? 1 : -1;
      ++result.count[i];
    });
  }
  return result;
}

[[nodiscard]] inline Draw draw_of(const Scene& scene) {
  Draw draw = triangles_of(ObjectVertices{scene.mesh.positions, scene.clip_from_object});
  draw.indices = scene.mesh.indices;
  return draw;
}

// ---- What must be drawn, in double: certain but for samples within kMargin_px of the border and the cuts.

inline constexpr double kMargin_px = 1.0 / 32.0;

struct ExpectedSum {
  std::vector<int> sum;
  std::vector<bool> certain;
};

/// A directed edge of the border or of a cut, in pixels.
struct BorderEdge {
  glm::dvec2 a, b;
};

[[nodiscard]] inline std::vector<BorderEdge> border_of(const Scene& scene) {
  const std::vector<std::uint32_t>& v = scene.mesh.indices;
  std::set<std::pair<std::uint32_t, std::uint32_t>> edges;
  for (std::size_t i = 0; i < v.size(); ++i) edges.emplace(v[i], v[i % 3 == 2 ? i - 2 : i + 1]);
  const Vertices vertices = ObjectVertices{scene.mesh.positions, scene.clip_from_object};
  struct Corner {
    glm::dvec4 p;
    bool open;  ///< the edge that starts here has no neighbour
  };
  std::vector<BorderEdge> border;
  for (std::size_t t = 0; t < v.size(); t += 3) {
    std::vector<Corner> polygon;
    for (std::size_t k = 0; k < 3; ++k) {
      const std::uint32_t a = v[t + k], b = v[t + (k + 1) % 3];
      polygon.push_back({reference::clip_position(vertices, a), !edges.contains({b, a})});
    }
    for (const auto& inside :
         {+[](const glm::dvec4& p) { return p.w - p.z; }, +[](const glm::dvec4& p) { return p.z; }}) {
      std::vector<Corner> rest;
      for (std::size_t k = 0; k < polygon.size(); ++k) {
        const Corner &a = polygon[k], &b = polygon[(k + 1) % polygon.size()];
        const double d_a = inside(a.p), d_b = inside(b.p);
        if (d_a >= 0.0) rest.push_back(a);
        if ((d_a >= 0.0) == (d_b >= 0.0)) continue;
        const glm::dvec4 cut = (a.p * -d_b + b.p * d_a) / (d_a - d_b);
        rest.push_back({cut, d_a >= 0.0 ? true : a.open});  // where the polygon leaves, the cut begins
      }
      polygon = std::move(rest);
    }
    const glm::dvec2 half = glm::dvec2(scene.size_px) * 0.5;
    const auto to_px = [&](const glm::dvec4& p) { return half + glm::dvec2(p.x, -p.y) / p.w * half; };
    for (std::size_t k = 0; k < polygon.size(); ++k) {
      if (polygon[k].open) border.push_back({to_px(polygon[k].p), to_px(polygon[(k + 1) % polygon.size()].p)});
    }
  }
  return border;
}

[[nodiscard]] inline ExpectedSum expected_sum(const Scene& scene) {
  const glm::ivec2 size = scene.size_px;
  ExpectedSum expected{std::vector<int>(std::size_t(size.x) * std::size_t(size.y)),
                       std::vector<bool>(std::size_t(size.x) * std::size_t(size.y), true)};
  const std::vector<BorderEdge> border = border_of(scene);
  for (int row = 0; row < size.y; ++row) {
    const double y = row + 0.5, top = y - kMargin_px, bottom = y + kMargin_px;
    const auto first = std::size_t(row) * std::size_t(size.x);
    std::vector<int> steps(std::size_t(size.x) + 1, 0);
    int winding = 0;  // counter-clockwise as seen; left of everything
    const auto column_right_of = [&](double x) { return int(std::clamp(std::ceil(x - 0.5), 0.0, double(size.x))); };
    for (const BorderEdge& edge : border) {
      if (std::min(edge.a.y, edge.b.y) > bottom || std::max(edge.a.y, edge.b.y) < top) continue;
      const auto x_at = [&](double at) {
        const double t = edge.a.y == edge.b.y ? 0.0 : (at - edge.a.y) / (edge.b.y - edge.a.y);
        return edge.a.x + std::clamp(t, 0.0, 1.0) * (edge.b.x - edge.a.x);
      };
      const int up = int(edge.a.y > y) - int(edge.b.y > y);
      winding += up;
      steps[std::size_t(column_right_of(x_at(y)))] -= up;
      double low = std::min(x_at(top), x_at(bottom)), high = std::max(x_at(top), x_at(bottom));
      if (edge.a.y == edge.b.y) {
        low = std::min(edge.a.x, edge.b.x);
        high = std::max(edge.a.x, edge.b.x);
      }
      const int end = column_right_of(high + kMargin_px);
      for (int x = column_right_of(low - kMargin_px); x < end; ++x) expected.certain[first + std::size_t(x)] = false;
    }
    for (int x = 0; x < size.x; ++x) {
      winding += steps[std::size_t(x)];
      expected.sum[first + std::size_t(x)] = winding;
    }
  }
  return expected;
}

struct SceneResult {
  SignedCoverage coverage;
  std::uint64_t n_wrong = 0, n_uncertain = 0, n_inside = 0;  ///< samples; inside: certain and not 0
  std::string first_wrong;
};

/// Draws the scene and compares the signed counts.
[[nodiscard]] inline SceneResult check_scene(const Scene& scene) {
  const Draw draw = draw_of(scene);
  SceneResult result;
  result.coverage = signed_coverage(frame_of(draw), scene.size_px);
  const ExpectedSum expected = expected_sum(scene);
  for (std::size_t i = 0; i < expected.sum.size(); ++i) {
    result.n_inside += expected.certain[i] && expected.sum[i] != 0;
    if (!expected.certain[i]) {
      ++result.n_uncertain;
    } else if (expected.sum[i] != result.coverage.sum[i]) {
      if (++result.n_wrong == 1) {
        const int x = int(i) % scene.size_px.x, y = int(i) / scene.size_px.x;
        result.first_wrong = scene.name + ": pixel " + std::to_string(x) + ", " + std::to_string(y) + ": " +
                             std::to_string(result.coverage.sum[i]) + " instead of " + std::to_string(expected.sum[i]);
      }
    }
  }
  return result;
}

}  // namespace lode::raster::test
