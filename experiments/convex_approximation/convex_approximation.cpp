#include "experiments/convex_approximation/convex_approximation.h"

#include <cstdlib>

#include "experiments/convex_approximation/growth.h"
#include "experiments/convex_approximation/model_pictures.h"
#include "experiments/convex_approximation/section.h"
#include "experiments/convex_approximation/stage_clock.h"
#include "experiments/progress.h"
#include "geometry/model_file.h"
#include "geometry/procedural/furniture.h"
#include "geometry/scene.h"
#include "techniques/convex_culling/convex_approximation.h"
#include "techniques/convex_culling/coverage_error.h"
#include "techniques/world.h"

namespace lode::experiments {
namespace {

using namespace techniques::convex_culling;

/// A model and the limits M that it is approximated with: the vertices that the paper's Table 1 used, as upper limits.
struct Subject {
  std::string name;
  techniques::Shape shape;
  std::vector<std::size_t> limits;  ///< empty: 6 % and 13 % of its vertices
};

techniques::Shape shape_of(const geometry::Scene& scene) {
  techniques::Shape all;
  for (const geometry::Instance& instance : scene.instances) {
    const geometry::Mesh& mesh = scene.meshes[instance.mesh];
    if (mesh.kind != geometry::MeshKind::triangles) continue;
    const auto offset = std::uint32_t(all.positions.size());
    for (const glm::vec3& p : mesh.positions) {
      all.positions.push_back(glm::vec3(instance.world_from_object * glm::dvec4(p, 1.0)));
    }
    for (const std::uint32_t index : mesh.indices) all.indices.push_back(offset + index);
  }
  return all;
}

Subject built_in(const geometry::Model& model, std::vector<std::size_t> limits) {
  geometry::ModelScene scene(model.name);
  scene.place(model, model.name);
  return {model.name, shape_of(std::move(scene).take()), std::move(limits)};
}

std::vector<Subject> subjects() {
  std::vector<Subject> all;
  all.push_back(built_in(geometry::table(), {210, 282}));
  all.push_back(built_in(geometry::chair(), {286, 396}));
  all.push_back(built_in(geometry::sofa(), {158, 557}));
  const char* assets = std::getenv("LODESTONE_ASSETS");
  if (assets == nullptr) return all;
  for (const char* name : {"oakTable", "oakChair", "bedWithTexture"}) {
    const std::string file = std::string(assets) + "/furniture-cc0/" + name + "/" + name + ".obj";
    all.push_back({name, shape_of(geometry::read_model_file(file)), {}});
  }
  return all;
}

/// Over- and under-coverage in per cent of the model's silhouettes, added up over directions.
struct TwoSided {
  double over = 0.0, under = 0.0;
};
TwoSided two_sided(const Subject& subject, const ApproximationLevel& level, std::span<const glm::dvec3> directions) {
  double over = 0.0, under = 0.0, model = 0.0;
  for (const glm::dvec3& direction : directions) {
    const CoverageError e = coverage_error(subject.shape.positions, subject.shape.indices, level.hulls, direction);
    over += e.over, under += e.under, model += e.model_area;
  }
  return model > 0.0 ? TwoSided{100.0 * over / model, 100.0 * under / model} : TwoSided{};
}

void approximate_subject(const Subject& subject, const ExperimentRun& run, ExperimentResults& results) {
  const std::vector<glm::dvec3> all = measured_directions(run.full ? 100 : 20, run.seed);
  const std::span<const glm::dvec3> axes(all.data(), 3), random(all.data() + 3, all.size() - 3);
  for (const VertexCount count : {VertexCount::distinct, VertexCount::sum}) {
    for (const SplitOrder order : {SplitOrder::better, SplitOrder::least_error}) {
      // How the paper is to be read matters most where it has figures.
      const bool main_reading = count == VertexCount::distinct && order == SplitOrder::better;
      if (!run.full && subject.limits.empty() && !main_reading) continue;
      ApproximationParams params;
      params.limits = subject.limits;
      params.count = count;
      params.order = order;
      params.threads = run.common.threads;
      StageClock clock;
      params.on_stage = [&](ApproximationStage stage) { clock.enter(stage); };
      const ConvexApproximation a = approximate(subject.shape.positions, subject.shape.indices, params);
      const auto begin_row = [&] {
        Row row;
        row.add("model", subject.name);
        row.add("count", std::string(count == VertexCount::sum ? "sum" : "distinct"));
        return row.add("order", std::string(order == SplitOrder::better ? "better" : "as printed"));
      };
      if (main_reading) {
        write_hulls_picture(run.images + "/" + subject.name + kHullsPicture, subject.shape, a,
                            run.common.render_options());
      }
      Row& time = results.times.emplace_back(begin_row());
      clock.add_to(time);
      for (std::size_t l = 0; l < a.levels.size(); ++l) {
        const ApproximationLevel& level = a.levels[l];
        Row& row = results.results.emplace_back(begin_row());
        row.add("polygons", std::int64_t(a.n_triangles)).add("vertices", std::int64_t(a.n_vertices));
        row.add("level", std::int64_t(l + 1)).add("limit", std::int64_t(level.limit));
        row.add("hulls", std::int64_t(level.hulls.size())).add("distinct", std::int64_t(level.n_distinct));
        row.add("sum", std::int64_t(level.n_sum)).add("error_percent", 100.0 * a.relative_error(l));
        const TwoSided on_axes = two_sided(subject, level, axes), anywhere = two_sided(subject, level, random);
        row.add("over_axes_percent", on_axes.over).add("under_axes_percent", on_axes.under);
        row.add("over_random_percent", anywhere.over).add("under_random_percent", anywhere.under);
      }
    }
  }
}

ExperimentResults run(const ExperimentRun& run) {
  ExperimentResults results;
  const std::vector<Subject> all = subjects();
  Progress progress(run.streams, run.common, "approximating", "models", all.size());
  for (const Subject& subject : all) {
    approximate_subject(subject, run, results);
    write_boxes_picture(run.images + "/" + subject.name + kBoxesPicture, subject.shape, run.common.render_options());
    progress.add(1);
  }
  results.summary = results.results;
  add_growth(run, results);
  return results;
}

}  // namespace

Experiment convex_approximation_experiment() {
  return {"convex_approximation",
          "How well a few convex hulls keep a model's silhouettes: the paper's Table 1",
          {},
          run,
          convex_approximation_section};
}

}  // namespace lode::experiments
