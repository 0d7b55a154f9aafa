#include "experiments/convex_culling/convex_culling.h"

#include <algorithm>
#include <array>
#include <cstdlib>
#include <memory>

#include "experiments/convex_culling/attribution.h"
#include "experiments/convex_culling/names.h"
#include "experiments/convex_culling/section.h"
#include "experiments/convex_culling/summary.h"
#include "experiments/harness/case_pictures.h"
#include "experiments/harness/culling_case.h"
#include "experiments/harness/finished_case.h"
#include "experiments/harness/scene_hash.h"
#include "experiments/harness/true_error.h"
#include "experiments/progress.h"
#include "experiments/scenes/builtin_scene.h"
#include "experiments/whole_file.h"
#include "geometry/viewpoints.h"

namespace lode::experiments {
namespace {

/// Each with the renderer's occlusion skipping off, then with it.
constexpr std::string_view kMethods[] = {kEverything,
                                         kBaseline,
                                         kOracle,
                                         "hierarchical_z",
                                         "masked_occlusion",
                                         "masked_occlusion:shape=inner_boxes",
                                         "inner_boxes",
                                         "convex_culling:mode=literal",
                                         kPaper,
                                         "convex_culling:mode=conservative"};

/// Whose losses are traced to their causes.
constexpr std::array kAttributed = {"convex_culling:mode=literal", kPaper};

/// How much of a walk the quick size looks at.
constexpr int kQuickFrames = 10, kQuickViewpoints = 8, kFullViewpoints = 1000;
constexpr int kQuickRounds = 3, kFullRounds = 5;
constexpr int kQuickTruths = 1, kFullTruths = 4;

/// What a run may choose: -1 is what its size has.
constexpr double kOfSize = -1.0;
const std::vector<std::string> kScenes = {"town179", "interior124"},
                               kKitScenes = {"kit_city", "kit_dungeon", "kit_rooms"};

std::vector<Parameter> parameters() {
  std::vector<std::string> scenes = {"all"};
  scenes.insert(scenes.end(), kScenes.begin(), kScenes.end());
  scenes.insert(scenes.end(), kKitScenes.begin(), kKitScenes.end());
  const auto number = [](const char* name, const char* meaning, double high) {
    return Parameter{name, std::string(meaning) + "; -1: as the size has it", kOfSize, high, kOfSize, true};
  };
  return {choice_parameter("scene", "one alone, or all that there are", std::move(scenes), 0),
          number("frames", "looked at of each walk, at most", 1e6),
          number("viewpoints", "random ones in each scene", 1e6),
          number("truths", "views of each walk held against the true picture", 1e6),
          number("rounds", "timed, of all methods in turn; 0: nothing is timed", 1000)};
}

int chosen(const ExperimentRun& run, const char* name, int quick, int full) {
  const double value = run.values.at(name);
  return value == kOfSize ? (run.full ? full : quick) : int(value);
}

/// Frame numbers spread over the walk.
std::vector<std::uint32_t> frames_of(int n_frames, int n_most) {
  std::vector<std::uint32_t> frames;
  const int n = std::min(n_most, n_frames);
  for (int k = 0; k < n; ++k) frames.push_back(std::uint32_t(std::int64_t(k) * n_frames / n));
  return frames;
}

std::vector<CullingCase> cases_of(const geometry::Scene& scene, const ExperimentRun& run) {
  CullingCase base;
  base.scene = scene.name;
  base.scene_hash = hash_of(scene);
  base.seed = run.seed;
  base.n_rounds = chosen(run, "rounds", kQuickRounds, kFullRounds);
  std::vector<CullingCase> cases;
  for (const geometry::CameraPath& path : scene.paths) {
    CullingCase& one = cases.emplace_back(base);
    one.path = path.name;
    one.frames = frames_of(path.n_frames, chosen(run, "frames", kQuickFrames, path.n_frames));
    for (const std::uint32_t frame : one.frames) one.cameras.push_back(geometry::camera_at(path, int(frame)));
  }
  CullingCase& random = cases.emplace_back(base);
  random.path = kRandomViewpoints;
  random.cameras =
      geometry::random_viewpoints(scene, run.seed, chosen(run, "viewpoints", kQuickViewpoints, kFullViewpoints));
  for (std::uint32_t k = 0; k < random.cameras.size(); ++k) random.frames.push_back(k);
  std::erase_if(cases, [](const CullingCase& one) { return one.cameras.empty(); });
  return cases;
}

std::vector<Method> methods() {
  std::vector<Method> all;
  for (const std::string_view name : kMethods) {
    all.push_back(make_method(name));
    all.push_back(make_method(std::string(name) + std::string(kWithSkips)));
  }
  return all;
}

/// What a finished case depends on, beside the program itself.
std::string key_of(const CullingCase& one, const std::string& look, const ExperimentRun& run) {
  std::string key = "convex_culling case 6; " + one.scene + "; " + one.scene_hash + "; look " + look + "; " + one.path +
                    "; seed " + std::to_string(run.seed) + "; rounds " + std::to_string(one.n_rounds) + "; truths " +
                    std::to_string(chosen(run, "truths", kQuickTruths, kFullTruths)) + "; threads " +
                    std::to_string(run.common.threads) + "; frames " + std::to_string(one.frames.size()) + ";";
  for (const Method& method : methods()) key += " " + settings_of(method) + ";";
  return key;
}

/// The views whose pictures are held against the truth: the telling one, then others spread over the walk.
std::vector<std::size_t> views_with_truth(const CullingCase& one, std::size_t telling, int n) {
  std::vector<std::size_t> views;
  if (n > 0) views.push_back(telling);
  const std::size_t n_spread = std::min(std::size_t(n), one.frames.size());
  for (std::size_t k = 1; k < n_spread; ++k) {
    const std::size_t view = k * one.frames.size() / n_spread;
    if (std::find(views.begin(), views.end(), view) == views.end()) views.push_back(view);
  }
  return views;
}

/// A scene's world and the methods prepared on it, made when the first case needs them.
class SceneBench {
 public:
  SceneBench(const geometry::Scene& scene, const std::string& look, const ExperimentRun& run)
      : scene_(scene), look_(look), run_(run) {}

  FinishedCase run(const CullingCase& one) {
    prepare();
    Progress progress(run_.streams, run_.common, one.scene + ", " + one.path, "frames",
                      one.cameras.size() * std::uint64_t(1 + one.n_rounds));
    std::vector<PreparedMethod*> pointers;
    for (const auto& method : methods_) pointers.push_back(method.get());
    FinishedCase finished;
    finished.result =
        run_culling_case(one, *world_, pointers, run_.kept, run_.common.render_options(), [&] { progress.add(1); });
    for (const Row& row : attributed_losses(one, finished.result, *world_, {kAttributed.begin(), kAttributed.end()},
                                            run_.common.render_options())) {
      finished.result.losses.push_back(row);
    }
    const std::size_t frame = telling_frame(one, finished.result, kPaper);
    for (const std::size_t view : views_with_truth(one, frame, chosen(run_, "truths", kQuickTruths, kFullTruths))) {
      add_true_errors(one, view, *world_, look_, pointers, run_.kept, run_.common.render_options(), finished.result);
    }
    std::vector<PreparedMethod*> rivals;
    for (const char* name : kRivals) rivals.push_back(method_of(name));
    add_files(
        run_.images,
        write_case_pictures(one, frame, *world_, *method_of(kPaper), rivals, run_.common.render_options(), run_.images),
        finished);
    return finished;
  }

 private:
  /// One of kMethods.
  [[nodiscard]] PreparedMethod* method_of(std::string_view name) const {
    return std::find_if(methods_.begin(), methods_.end(), [&](const auto& m) { return m->method().name == name; })
        ->get();
  }

  void prepare() {
    if (world_) return;
    const std::vector<Method> all = methods();
    Progress progress(run_.streams, run_.common, "preparing " + scene_.name, "methods", all.size() + 1);
    progress.show();
    world_ = std::make_unique<techniques::World>(scene_, techniques::SceneDraws::Params{}, true, run_.common.threads);
    progress.add(1);
    for (const Method& method : all) {
      progress.show();
      methods_.push_back(std::make_unique<PreparedMethod>(method, *world_, run_.common.render_options()));
      progress.add(1);
    }
  }

  const geometry::Scene& scene_;
  const std::string& look_;
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
  const std::string look = look_hash_of(scene);
  SceneBench bench(scene, look, run);
  for (const CullingCase& one : cases_of(scene, run)) {
    const std::string key = key_of(one, look, run);
    FinishedCase finished;
    const std::optional<std::string> kept = run.kept.find(key);
    if (kept && read_case(*kept, finished)) {
      write_files(finished, run.images);
    } else {
      finished = bench.run(one);
      run.kept.keep(key, text_of(finished));
    }
    add(finished.result, results);
    add_summary(finished.result, results.summary);
  }
}

ExperimentResults run(const ExperimentRun& run) {
  ExperimentResults results;
  std::vector<std::string> scenes = kScenes;
  if (std::getenv("LODESTONE_ASSETS") != nullptr) scenes.insert(scenes.end(), kKitScenes.begin(), kKitScenes.end());
  const std::vector<Parameter> known = parameters();
  if (const double scene = run.values.at("scene"); scene > 0.0) scenes = {value_text(known.front(), scene)};
  for (const std::string& scene : scenes) run_scene(scene, run, results);
  return results;
}

}  // namespace

Experiment convex_culling_experiment() {
  return {"convex_culling",       "What occlusion culling by convex hulls saves and what it loses, beside its rivals",
          parameters(),           run,
          convex_culling_section, convex_culling_headline};
}

}  // namespace lode::experiments
