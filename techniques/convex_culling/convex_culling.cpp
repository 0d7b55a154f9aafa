#include "techniques/convex_culling/convex_culling.h"

#include <algorithm>
#include <cmath>

#include "raster/parallel.h"

namespace lode::techniques {
namespace {

/// The value that the given share of all is not above.
double quantile(std::vector<double> values, double share) {
  if (values.empty()) return 0.0;
  const auto at = std::size_t(std::min(std::ceil(share * double(values.size())), double(values.size() - 1)));
  std::nth_element(values.begin(), values.begin() + std::ptrdiff_t(at), values.end());
  return values[at];
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
  std::vector<OccluderShape> shapes(world.n_shapes());
  convex_culling::ApproximationParams approximation = params_.approximation;
  approximation.threads = 1;
  raster::parallel_for(shapes.size(), raster::worker_count(stage.threads()), [&](std::size_t i, int) {
    if (wanted[i] == 0) return;
    const Shape shape = world.shape(std::uint32_t(i));
    const auto approximate = convex_culling::approximate(shape.positions, shape.indices, approximation);
    const std::size_t last = approximate.levels.size() - 1;
    if (approximate.relative_error(last) > params_.largest_error) return;
    for (const convex_culling::ApproximationLevel& level : approximate.levels) {
      shapes[i].levels.push_back(level.hulls);
    }
  });
  culling_.prepare(std::move(shapes), std::move(areas));
}

}  // namespace lode::techniques
