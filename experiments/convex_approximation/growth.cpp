#include "experiments/convex_approximation/growth.h"

#include <cmath>

#include "experiments/convex_approximation/stage_clock.h"
#include "experiments/progress.h"
#include "geometry/procedural.h"
#include "techniques/convex_culling/convex_approximation.h"

namespace lode::experiments {
namespace {

using namespace techniques::convex_culling;

/// Squares along the ring, half of the squares around it: of 2 · around · along triangles.
geometry::Mesh torus_of(int around) { return geometry::torus(glm::dvec3(0.0), 3.0, 1.0, 2 * around, around); }

struct Point {
  double x, y;
};

/// Of the straight line that is nearest in y.
double slope(const std::vector<Point>& points) {
  double x = 0.0, y = 0.0, xx = 0.0, xy = 0.0;
  for (const Point& p : points) x += p.x / double(points.size()), y += p.y / double(points.size());
  for (const Point& p : points) xx += (p.x - x) * (p.x - x), xy += (p.x - x) * (p.y - y);
  return xy / xx;
}

}  // namespace

void add_growth(const ExperimentRun& run, ExperimentResults& results) {
  std::vector<int> sizes = {16, 32, 64, 128};  // of 4 · size² triangles
  if (run.full) sizes.insert(sizes.end(), {256, 512});
  Progress progress(run.streams, run.common, "growth", "tori", sizes.size());
  std::vector<Point> measured, promised;
  double seconds = 0.0, hull_seconds = 0.0;
  for (const int size : sizes) {
    const geometry::Mesh mesh = torus_of(size);
    ApproximationParams params;
    params.threads = run.common.threads;
    StageClock clock;
    params.on_stage = [&](ApproximationStage stage) { clock.enter(stage); };
    const ConvexApproximation a = approximate(mesh.positions, mesh.indices, params);
    const auto begin_row = [&] {
      Row row;
      row.add("model", "torus " + std::to_string(a.n_triangles / 1000) + "k");
      row.add("count", std::string("distinct")).add("order", std::string("better"));
      return row.add("polygons", std::int64_t(a.n_triangles));
    };
    clock.add_to(results.times.emplace_back(begin_row()));
    for (std::size_t l = 0; l < a.levels.size(); ++l) {
      Row& row = results.results.emplace_back(begin_row());
      row.add("vertices", std::int64_t(a.n_vertices)).add("level", std::int64_t(l + 1));
      row.add("limit", std::int64_t(a.levels[l].limit)).add("hulls", std::int64_t(a.levels[l].hulls.size()));
      row.add("distinct", std::int64_t(a.levels[l].n_distinct)).add("sum", std::int64_t(a.levels[l].n_sum));
      row.add("error_percent", 100.0 * a.relative_error(l));
    }
    const double log_n = std::log(double(a.n_triangles));
    measured.push_back({log_n, std::log(clock.seconds())});
    promised.push_back({log_n, log_n + 2.0 * std::log(log_n)});
    seconds += clock.seconds(), hull_seconds += clock.hull_seconds();
    progress.add(1);
  }
  Row& row = results.summary.emplace_back();
  row.add("model", std::string(kGrowth)).add("polygons", std::int64_t(4 * sizes.back() * sizes.back()));
  row.add("exponent", slope(measured)).add("exponent_n_log2_n", slope(promised));
  row.add("hulls_percent", 100.0 * hull_seconds / seconds);
}

}  // namespace lode::experiments
