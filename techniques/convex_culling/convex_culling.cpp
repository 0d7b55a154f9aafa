#include "techniques/convex_culling/convex_culling.h"

#include <algorithm>
#include <cmath>
#include <string>

#include "raster/parallel.h"

namespace lode::techniques {
namespace {

using convex_culling::ConvexApproximation;

/// The value that the given share of all is not above.
double quantile(std::vector<double> values, double share) {
  if (values.empty()) return 0.0;
  const auto at = std::size_t(std::min(std::ceil(share * double(values.size())), double(values.size() - 1)));
  std::nth_element(values.begin(), values.begin() + std::ptrdiff_t(at), values.end());
  return values[at];
}

/// Of the shapes that are wanted; the others have no levels.
std::vector<ConvexApproximation> approximations(const World& world, std::span<const std::uint8_t> wanted,
                                                convex_culling::ApproximationParams params, int threads) {
  params.threads = 1;  // the shapes are side by side
  std::vector<ConvexApproximation> all(world.n_shapes());
  raster::parallel_for(all.size(), raster::worker_count(threads), [&](std::size_t i, int) {
    if (wanted[i] == 0) return;
    const Shape shape = world.shape(std::uint32_t(i));
    all[i] = convex_culling::approximate(shape.positions, shape.indices, params);
  });
  return all;
}

/// Everything that the approximations of a world depend on.
std::string key_of(const ConvexCulling::Params& p) {
  const convex_culling::ApproximationParams& a = p.approximation;
  std::string key = "convex approximations;";
  for (const std::size_t limit : a.limits) key += " " + std::to_string(limit);
  for (const double value :
       {p.least_area_quantile, double(a.count), double(a.order), a.weld_tolerance, a.direction_step_deg, double(a.rule),
        double(a.relative_error), double(a.n_lines), double(a.n_cluster_lines), double(a.n_grid)}) {
    key += "; " + std::to_string(value);
  }
  return key;
}

}  // namespace

ConvexCulling::Params ConvexCulling::params_for(Mode mode) {
  Params params;
  params.mode = mode;
  params.slabs.depth_rule = params.slabs.test_occluders = mode != Mode::literal;
  params.slabs.whole_occluders_only = mode == Mode::conservative;
  params.slabs.slabs = mode == Mode::conservative ? geometry::SlabMode::conservative : geometry::SlabMode::paper;
  return params;
}

void ConvexCulling::prepare(Stage& stage) {
  const World& world = stage.world();
  std::vector<double> areas = occluder_areas(world);
  const double least_area = quantile(areas, params_.least_area_quantile);
  std::vector<std::uint8_t> wanted(world.n_shapes(), 0);
  for (ObjectId id = 0; id < areas.size(); ++id) {
    if (areas[id] < least_area) areas[id] = 0.0;
    if (areas[id] > 0.0) wanted[world.objects()[id].shape] = 1;
  }
  const auto found = world.once<std::vector<ConvexApproximation>>(
      key_of(params_), [&] { return approximations(world, wanted, params_.approximation, stage.threads()); });
  std::vector<OccluderShape> shapes(world.n_shapes());
  for (std::size_t i = 0; i < shapes.size(); ++i) {
    const ConvexApproximation& approximation = (*found)[i];
    const std::size_t n_levels = approximation.levels.size();
    if (n_levels == 0 || approximation.relative_error(n_levels - 1) > params_.largest_error) continue;
    for (const convex_culling::ApproximationLevel& level : approximation.levels) {
      shapes[i].levels.push_back(level.hulls);
    }
  }
  culling_.prepare(std::move(shapes), std::move(areas));
}

}  // namespace lode::techniques
