#include "experiments/convex_culling/convex_culling.h"

#include <cstdlib>
#include <memory>

#include "experiments/convex_culling/summary.h"
#include "experiments/harness/culling_case.h"
#include "experiments/harness/scene_hash.h"
#include "experiments/progress.h"
#include "experiments/scenes/builtin_scene.h"
#include "geometry/viewpoints.h"

namespace lode::experiments {
namespace {

/// Each with the renderer's occlusion skipping off, then with it.
constexpr const char* kMethods[] = {"plain",
                                    "frustum_culling",
                                    "hierarchical_z",
                                    "masked_occlusion",
                                    "inner_boxes",
                                    "convex_culling:mode=literal",
                                    "convex_culling:mode=safe",
                                    "convex_culling:mode=conservative"};

/// How much of a walk the quick size looks at.
constexpr int kQuickFrames = 12, kQuickViewpoints = 24, kFullViewpoints = 1000;
constexpr int kQuickRounds = 3, kFullRounds = 5;

/// Frame numbers spread over the walk: all of it, or a few.
std::vector<std::uint32_t> frames_of(int n_frames, bool full) {
  std::vector<std::uint32_t> frames;
  const int n = full ? n_frames : std::min(kQuickFrames, n_frames);
  for (int k = 0; k < n; ++k) frames.push_back(std::uint32_t(std::int64_t(k) * n_frames / n));
  return frames;
}

std::vector<CullingCase> cases_of(const geometry::Scene& scene, const ExperimentRun& run) {
  CullingCase base;
  base.scene = scene.name;
  base.scene_hash = hash_of(scene);
  base.seed = run.seed;
  base.n_rounds = run.full ? kFullRounds : kQuickRounds;
  std::vector<CullingCase> cases;
  for (const geometry::CameraPath& path : scene.paths) {
    CullingCase& one = cases.emplace_back(base);
    one.path = path.name;
    one.frames = frames_of(path.n_frames, run.full);
    for (const std::uint32_t frame : one.frames) one.cameras.push_back(geometry::camera_at(path, int(frame)));
  }
  CullingCase& random = cases.emplace_back(base);
  random.path = "random viewpoints";
  random.cameras = geometry::random_viewpoints(scene, run.seed, run.full ? kFullViewpoints : kQuickViewpoints);
  for (std::uint32_t k = 0; k < random.cameras.size(); ++k) random.frames.push_back(k);
  return cases;
}

std::vector<Method> methods() {
  std::vector<Method> all;
  for (const char* name : kMethods) {
    all.push_back(make_method(name));
    all.push_back(make_method(std::string(name) + " + skips"));
  }
  return all;
}

/// What a finished case depends on, beside the program itself.
std::string key_of(const CullingCase& one, const ExperimentRun& run) {
  std::string key = "convex_culling case 1; " + one.scene + "; " + one.scene_hash + "; " + one.path + "; seed " +
                    std::to_string(run.seed) + "; rounds " + std::to_string(one.n_rounds) + "; threads " +
                    std::to_string(run.common.threads) + "; frames " + std::to_string(one.frames.size()) + ";";
  for (const Method& method : methods()) key += " " + method.name;
  return key;
}

std::string text_of(const CaseResult& result) { return rows_json(result.results) + "\n" + rows_json(result.times); }
bool read_case(std::string_view text, CaseResult& result) {
  const std::size_t middle = text.find('\n');
  return middle != std::string_view::npos && rows_of(text.substr(0, middle), result.results) &&
         rows_of(text.substr(middle + 1), result.times);
}

/// A scene's world and the methods prepared on it, made when the first case needs them.
class SceneBench {
 public:
  SceneBench(const geometry::Scene& scene, const ExperimentRun& run) : scene_(scene), run_(run) {}

  CaseResult run(const CullingCase& one) {
    prepare();
    Progress progress(run_.streams, run_.common, one.scene + ", " + one.path, "frames",
                      one.cameras.size() * std::uint64_t(2 + one.n_rounds));
    std::vector<PreparedMethod*> pointers;
    for (const auto& method : methods_) pointers.push_back(method.get());
    return run_culling_case(one, *world_, pointers, run_.kept, run_.common.render_options(), [&] { progress.add(1); });
  }

 private:
  void prepare() {
    if (world_) return;
    const std::vector<Method> all = methods();
    Progress progress(run_.streams, run_.common, "preparing " + scene_.name, "methods", all.size() + 1);
    world_ = std::make_unique<techniques::World>(scene_, techniques::SceneDraws::Params{}, true, run_.common.threads);
    progress.add(1);
    for (const Method& method : all) {
      methods_.push_back(std::make_unique<PreparedMethod>(method, *world_, run_.common.render_options()));
      progress.add(1);
    }
  }

  const geometry::Scene& scene_;
  const ExperimentRun& run_;
  std::unique_ptr<techniques::World> world_;
  std::vector<std::unique_ptr<PreparedMethod>> methods_;
};

void add(const CaseResult& from, ExperimentResults& to) {
  to.results.insert(to.results.end(), from.results.begin(), from.results.end());
  to.times.insert(to.times.end(), from.times.begin(), from.times.end());
}

void run_scene(const std::string& name, const ExperimentRun& run, ExperimentResults& results) {
  const geometry::Scene scene = make_builtin_scene(name);
  SceneBench bench(scene, run);
  for (const CullingCase& one : cases_of(scene, run)) {
    const std::string key = key_of(one, run);
    CaseResult result;
    const std::optional<std::string> kept = run.kept.find(key);
    if (!kept || !read_case(*kept, result)) {
      result = bench.run(one);
      run.kept.keep(key, text_of(result));
    }
    add(result, results);
    add_summary(result, results.summary);
  }
}

ExperimentResults run(const ExperimentRun& run) {
  ExperimentResults results;
  std::vector<std::string> scenes = {"town179", "interior124"};
  if (std::getenv("LODESTONE_ASSETS") != nullptr) {
    scenes.insert(scenes.end(), {"kit_city", "kit_dungeon", "kit_rooms"});
  }
  for (const std::string& scene : scenes) run_scene(scene, run, results);
  return results;
}

}  // namespace

Experiment convex_culling_experiment() {
  return {
      "convex_culling", "What occlusion culling by convex hulls saves and what it loses, beside its rivals", {}, run};
}

}  // namespace lode::experiments
