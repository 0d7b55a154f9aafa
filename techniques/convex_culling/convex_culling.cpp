#include "techniques/convex_culling/convex_culling.h"

#include <algorithm>
#include <cmath>
#include <string>

#include "geometry/inner_hulls.h"
#include "geometry/solid.h"
#include "raster/parallel.h"
#include "techniques/convex_culling/excess.h"

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

/// Of a shape with few vertices, 6 and 13 % would not do for one hull: it gets as many as one hull, or two, may have.
constexpr std::size_t kSmallShape = 400, kDirections = 26;

/// Of the shapes that are wanted; the others have no levels.
std::vector<ConvexApproximation> approximations(const World& world, std::span<const std::uint8_t> wanted,
                                                convex_culling::ApproximationParams params, int threads) {
  params.threads = 1;  // the shapes are side by side
  std::vector<ConvexApproximation> all(world.n_shapes());
  raster::parallel_for(all.size(), raster::worker_count(threads), [&](std::size_t i, int) {
    if (wanted[i] == 0) return;
    const Shape shape = world.shape(std::uint32_t(i));
    convex_culling::ApproximationParams own = params;
    if (own.limits.empty() && shape.positions.size() < kSmallShape) own.limits = {kDirections, 2 * kDirections};
    all[i] = convex_culling::approximate(shape.positions, shape.indices, own);
  });
  return all;
}

bool is_finite(const Shape& shape) {
  return std::all_of(shape.positions.begin(), shape.positions.end(),
                     [](const glm::vec3& p) { return std::isfinite(p.x) && std::isfinite(p.y) && std::isfinite(p.z); });
}

using Levels = std::vector<std::vector<std::vector<glm::vec3>>>;  ///< OccluderParts::levels

/// [shapes][levels]; of levels that no one asks, empty.
using Excesses = std::vector<std::vector<convex_culling::Excess>>;

Excesses excesses_of(const World& world, std::span<const ConvexApproximation> approximations, LevelRule rule,
                     int threads) {
  Excesses all(approximations.size());
  raster::parallel_for(all.size(), raster::worker_count(threads), [&](std::size_t i, int) {
    const std::vector<convex_culling::ApproximationLevel>& levels = approximations[i].levels;
    if (levels.empty()) return;
    const Shape shape = world.shape(std::uint32_t(i));
    all[i].resize(levels.size());
    for (std::size_t l = rule == LevelRule::last ? levels.size() - 1 : 0; l < levels.size(); ++l) {
      all[i][l] = convex_culling::excess(shape.positions, shape.indices, levels[l].hulls);
    }
  });
  return all;
}

/// Of hulls that hide more than they may, none.
OccluderParts parts_of(const ConvexApproximation& approximation, std::span<const convex_culling::Excess> excesses,
                       const ConvexCulling::Params& params) {
  const std::size_t n_levels = approximation.levels.size();
  if (approximation.relative_error(n_levels - 1) > params.largest_error) return {};
  if (!excesses.empty() && excesses[n_levels - 1].model > params.largest_excess) return {};
  OccluderParts parts;
  for (std::size_t l = 0; l < n_levels; ++l) {
    auto& hulls = parts.levels.emplace_back();
    auto& hides_occluders = parts.hides_occluders.emplace_back();
    for (std::size_t i = 0; i < approximation.levels[l].hulls.size(); ++i) {
      const bool known = !excesses.empty() && !excesses[l].hulls.empty();
      const double excess = known ? excesses[l].hulls[i] : 0.0;
      if (excess > params.largest_hull_excess || (known && excesses[l].sizes[i] < params.least_hull_size)) continue;
      hulls.push_back(approximation.levels[l].hulls[i]);
      hides_occluders.push_back(excess <= params.largest_occluder_excess);
    }
  }
  return parts;
}

/// The hulls, shrunk into the models. A shape whose positions were rounded is not the model to the last bit: it has
/// none.
std::vector<Levels> inner_levels(const World& world, std::span<const ConvexApproximation> approximations, int threads) {
  std::vector<Levels> all(approximations.size());
  raster::parallel_for(all.size(), raster::worker_count(threads), [&](std::size_t i, int) {
    if (approximations[i].levels.empty()) return;
    const Shape shape = world.shape(std::uint32_t(i));
    if (!shape.exact || !is_finite(shape)) return;
    const geometry::Solid solid(shape.positions, shape.indices);
    for (const convex_culling::ApproximationLevel& level : approximations[i].levels) {
      auto& inner = all[i].emplace_back();
      for (geometry::InnerHull& hull : geometry::inner_hulls(solid, level.hulls))
        inner.push_back(std::move(hull.points));
    }
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
  if (mode == Mode::safe) params.largest_occluder_excess = 0.05, params.least_hull_size = 0.01;
  if (mode == Mode::conservative) {  // nothing is lost by looking at more
    params.slabs.angle_limit_deg = 180.0;
    params.slabs.occluders.most = 32;
  }
  // Counted as a sum, a limit that all vertices keep does not turn hulls into single polygons, which have no inside.
  if (mode == Mode::conservative) params.approximation.count = convex_culling::VertexCount::sum;
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
  std::shared_ptr<const std::vector<Levels>> inner;
  if (params_.mode == Mode::conservative) {
    inner = world.once<std::vector<Levels>>(key_of(params_) + "; inner",
                                            [&] { return inner_levels(world, *found, stage.threads()); });
  }
  std::shared_ptr<const Excesses> excesses;
  const double least_limit =
      std::min({params_.largest_excess, params_.largest_hull_excess, params_.largest_occluder_excess});
  if (params_.mode != Mode::conservative && (least_limit < kAny || params_.least_hull_size > 0.0)) {
    const LevelRule rule = params_.slabs.levels;
    excesses = world.once<Excesses>(key_of(params_) + "; excess " + std::to_string(int(rule)),
                                    [&] { return excesses_of(world, *found, rule, stage.threads()); });
  }
  std::vector<OccluderParts> shapes(world.n_shapes());
  for (std::size_t i = 0; i < shapes.size(); ++i) {
    const ConvexApproximation& approximation = (*found)[i];
    if (approximation.levels.empty()) continue;
    if (inner) {  // however they err as approximations, they hide nothing that is seen
      shapes[i].levels = (*inner)[i];
    } else {
      using List = std::span<const convex_culling::Excess>;
      shapes[i] = parts_of(approximation, excesses ? List((*excesses)[i]) : List(), params_);
    }
  }
  culling_.prepare(std::move(shapes), std::move(areas));
}

}  // namespace lode::techniques
