#include "experiments/image_reuse/image_reuse.h"

#include <algorithm>
#include <cstdlib>
#include <memory>

#include "experiments/display_bytes.h"
#include "experiments/harness/finished_case.h"
#include "experiments/harness/png_file.h"
#include "experiments/harness/scene_hash.h"
#include "experiments/harness/sky.h"
#include "experiments/image_reuse/names.h"
#include "experiments/image_reuse/section.h"
#include "experiments/image_reuse/summary.h"
#include "experiments/image_reuse/walk.h"
#include "experiments/metrics/flip/flip.h"
#include "experiments/metrics/magma.h"
#include "experiments/progress.h"
#include "experiments/scenes/builtin_scene.h"

namespace lode::experiments {
namespace {

/// Beside the thresholds: what the paper prints, a guard that it does not have, and what has come since.
constexpr std::string_view kOthers[] = {kLiteral,
                                        "image_reuse:threshold=2,magnification=1.25",
                                        "predicted_reuse:cell=0",
                                        "predicted_reuse:cell=0,error=3",
                                        "predicted_reuse:cell=0,fade=8",
                                        "predicted_reuse",
                                        "predicted_reuse:error=3",
                                        "twelve_views:elevation=0",
                                        "octahedral_impostors",
                                        "mesh_lod",
                                        "mesh_lod:level=1",
                                        "mesh_lod:level=2",
                                        "mesh_lod:level=3",
                                        "mesh_lod:pixels=2,share1=0.2,share2=0.1",
                                        "mesh_lod:pixels=6,share1=0.2,share2=0.1"};

constexpr int kQuickFrames = 120, kQuickPasses = 1, kFullPasses = 3;
constexpr double kOfSize = -1.0;

/// A scene and how much of the question is asked of it.
struct Part {
  std::string scene;
  double each;       ///< triangles of a house; 0: models as they are
  bool all_methods;  ///< else no cache and the thresholds, the renderer's skips off
};

const std::vector<std::string> kSceneChoices = {"all", "houses24", "houses200", "kit_city"};

std::vector<Parameter> parameters() {
  return {choice_parameter("scene", "one alone, or all that the size has", kSceneChoices, 0),
          {"frames", "of each walk, from a quarter of it on; -1: as the size has it", kOfSize, 1e6, kOfSize, true},
          {"passes", "timed; 0: nothing is timed; -1: as the size has it", kOfSize, 1000, kOfSize, true}};
}

std::vector<Part> parts_of(const ExperimentRun& run) {
  std::vector<Part> parts;
  const auto houses = [&](const char* scene, int each, bool all_methods) {
    parts.push_back({std::string(scene) + ":each=" + std::to_string(each), double(each), all_methods});
  };
  houses("houses24", 4000, true);
  for (const int each : {1000, 2000, 8000, 16000}) {
    if (run.full || each == 1000 || each == 16000) houses("houses24", each, false);
  }
  const std::vector<Parameter> known = parameters();
  const double chosen = run.values.at("scene");
  const std::string scene = value_text(known.front(), chosen);
  if (run.full || scene == "houses200") houses("houses200", 4000, true);
  if (std::getenv("LODESTONE_ASSETS") != nullptr || scene == "kit_city") parts.push_back({"kit_city", 0.0, true});
  if (chosen > 0.0) std::erase_if(parts, [&](const Part& part) { return !part.scene.starts_with(scene); });
  return parts;
}

/// The quick size has the renderer's skips on for no cache and the thresholds only.
std::vector<Method> methods_of(const Part& part, bool full) {
  std::vector<std::string> names = {kNoCache};
  for (const char* degrees : kThresholds_deg) names.push_back(reuse_at(degrees));
  if (part.all_methods) names.insert(names.end(), std::begin(kOthers), std::end(kOthers));
  std::vector<Method> methods;
  for (const std::string& name : names) methods.push_back(make_method(name));
  const std::size_t n_with_skips = !part.all_methods ? 0 : (full ? names.size() : 1 + kThresholds_deg.size());
  for (std::size_t i = 0; i < n_with_skips; ++i) methods.push_back(make_method(names[i] + std::string(kWithSkips)));
  return methods;
}

std::vector<Walk> walks_of(const geometry::Scene& scene, const Part& part, const ExperimentRun& run) {
  std::vector<Walk> walks;
  for (const geometry::CameraPath& path : scene.paths) {
    Walk& walk = walks.emplace_back();
    walk.scene = part.scene, walk.path = path.name;
    const double frames = run.values.at("frames"), passes = run.values.at("passes");
    const int of_size = run.full ? path.n_frames : kQuickFrames;
    const int n = std::min(frames == kOfSize ? of_size : int(frames), path.n_frames);
    const int first = (path.n_frames - n) / 4;
    for (int k = first; k < first + n; ++k) {
      walk.frames.push_back(std::uint32_t(k));
      walk.cameras.push_back(geometry::camera_at(path, k));
    }
    walk.n_passes = passes == kOfSize ? (run.full ? kFullPasses : kQuickPasses) : int(passes);
  }
  std::erase_if(walks, [](const Walk& walk) { return walk.cameras.empty(); });
  return walks;
}

/// What a finished walk depends on, beside the program itself.
std::string key_of(const Walk& walk, const std::string& look, const std::vector<Method>& methods,
                   const ExperimentRun& run) {
  std::string key = "image_reuse walk 6; " + walk.scene + "; look " + look + "; " + walk.path + "; passes " +
                    std::to_string(walk.n_passes) + "; threads " + std::to_string(run.common.threads) + "; frames " +
                    std::to_string(walk.frames.front()) + " to " + std::to_string(walk.frames.back()) + ";";
  for (const Method& method : methods) key += " " + settings_of(method) + ";";
  return key;
}

/// The middle frame of the stretch as it is, with reuse at 2 degrees, and in the paper's placement; and what a person
/// sees of the difference. The methods walk from the stretch's begin.
std::vector<std::string> write_pictures(const Walk& walk, std::span<PreparedMethod* const> methods, int threads,
                                        const std::string& folder) {
  const std::size_t middle = walk.cameras.size() / 2;
  const std::string name =
      walk.scene.substr(0, walk.scene.find(':')) + "." + walk.path + "." + std::to_string(walk.frames[middle]);
  raster::Image image = raster::make_image(walk.size_px, raster::ColorFormat::rgba32f);
  std::vector<glm::u8vec4> whole;
  std::vector<std::string> files;
  const auto write = [&](std::string_view kind, std::span<const glm::u8vec4> colors) {
    files.push_back(name + std::string(kind));
    write_png(folder + "/" + files.back(), walk.size_px, colors);
  };
  for (PreparedMethod* method : methods) {
    const std::string& of = method->method().name;
    if (of != kNoCache && of != reuse_at("2") && of != kLiteral) continue;
    method->cut();
    for (std::size_t i = of == kNoCache ? middle : 0; i <= middle; ++i) {
      const techniques::View view{.camera = walk.cameras[i], .size_px = walk.size_px, .background = kSky};
      static_cast<void>(method->draw(view, image, kSky));
    }
    const std::vector<glm::u8vec4> shown = display_bytes(image.rgba32f);
    if (of == kNoCache) whole = shown;
    write(of == kNoCache ? kWholePicture : (of == kLiteral ? kLiteralPicture : kReusedPicture), shown);
    if (of != reuse_at("2")) continue;
    write(kReusedFlip, magma_picture(flip_map({walk.size_px, whole, shown}, {.threads = threads}).errors));
  }
  return files;
}

/// A scene's world and the methods on it, made when the first walk needs them.
class WalkBench {
 public:
  WalkBench(const geometry::Scene& scene, const Part& part, const ExperimentRun& run)
      : scene_(scene), part_(part), run_(run) {}

  FinishedCase run(const Walk& walk) {
    prepare();
    Progress progress(run_.streams, run_.common, walk.scene + ", " + walk.path, "frames",
                      walk.cameras.size() * std::uint64_t(1 + walk.n_passes));
    std::vector<PreparedMethod*> pointers;
    for (const auto& method : methods_) pointers.push_back(method.get());
    FinishedCase finished;
    finished.result = run_walk(walk, *world_, pointers, run_.common.threads, [&] { progress.add(1); });
    if (part_.all_methods) {
      add_files(run_.images, write_pictures(walk, pointers, run_.common.threads, run_.images), finished);
    }
    return finished;
  }

 private:
  void prepare() {
    if (world_) return;
    const std::vector<Method> all = methods_of(part_, run_.full);
    Progress progress(run_.streams, run_.common, "preparing " + part_.scene, "methods", all.size() + 1);
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
  const Part& part_;
  const ExperimentRun& run_;
  std::unique_ptr<techniques::World> world_;
  std::vector<std::unique_ptr<PreparedMethod>> methods_;
};

void run_part(const Part& part, const ExperimentRun& run, ExperimentResults& results) {
  const geometry::Scene scene = make_builtin_scene(part.scene);
  const std::string look = look_hash_of(scene);
  WalkBench bench(scene, part, run);
  for (const Walk& walk : walks_of(scene, part, run)) {
    const std::string key = key_of(walk, look, methods_of(part, run.full), run);
    FinishedCase finished;
    const std::optional<std::string> kept = run.kept.find(key);
    if (kept && read_case(*kept, finished)) {
      write_files(finished, run.images);
    } else {
      finished = bench.run(walk);
      run.kept.keep(key, text_of(finished));
    }
    const CaseResult& found = finished.result;
    results.results.insert(results.results.end(), found.results.begin(), found.results.end());
    results.times.insert(results.times.end(), found.times.begin(), found.times.end());
    add_summary(found, part.each, results.summary);
  }
}

ExperimentResults run(const ExperimentRun& run) {
  ExperimentResults results;
  for (const Part& part : parts_of(run)) run_part(part, run, results);
  add_crossovers(results.summary);
  return results;
}

}  // namespace

Experiment image_reuse_experiment() {
  return {"image_reuse",       "What reuse of pictures from frame to frame saves and what it costs, beside its rivals",
          parameters(),        run,
          image_reuse_section, image_reuse_headline};
}

}  // namespace lode::experiments
