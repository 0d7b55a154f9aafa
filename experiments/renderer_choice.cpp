#include "experiments/renderer_choice.h"

#include <algorithm>
#include <string>

#include "experiments/error.h"
#include "experiments/option_values.h"

namespace lode::experiments {
namespace {

using raster::Pipeline;
using raster::Skips;
using raster::Target;

constexpr std::string_view kPipelines[] = {"fast", "reference"};
constexpr std::string_view kTargets[] = {"best", "scalar", "sse4", "avx2", "avx512", "neon", "wasm"};

struct NamedSkip {
  std::string_view name;
  bool Skips::*skip;
};
constexpr NamedSkip kSkips[] = {{"frustum", &Skips::frustum},
                                {"facing", &Skips::facing},
                                {"occlusion", &Skips::occlusion},
                                {"samples", &Skips::samples},
                                {"blocks", &Skips::blocks}};

Skips all_skips(bool on) {
  Skips skips;
  for (const NamedSkip& named : kSkips) skips.*named.skip = on;
  return skips;
}

}  // namespace

Pipeline read_pipeline(std::string_view name) { return Pipeline(read_choice("--pipeline", name, kPipelines)); }

Target read_target(std::string_view name) {
  const auto target = Target(read_choice("--target", name, kTargets));
  if (target == Target::best) return raster::best_target();
  if (raster::can_run(target)) return target;
  throw Error(Status::wrong_usage, "--target " + std::string(name) + ": this processor lacks it");
}

Skips read_skips(std::string_view list) {
  if (list == "all" || list == "none") return all_skips(list == "all");
  Skips skips = all_skips(false);
  for (const std::string_view name : split(list, ',')) {
    const auto found = std::find_if(std::begin(kSkips), std::end(kSkips), [&](auto& s) { return s.name == name; });
    if (found == std::end(kSkips)) {
      std::string names;
      for (const NamedSkip& named : kSkips) names += (names.empty() ? "" : ", ") + std::string(named.name);
      fail_value("--skip", "all, none, or some of " + names, name);
    }
    skips.*found->skip = true;
  }
  return skips;
}

const char* pipeline_name(Pipeline pipeline) { return kPipelines[std::size_t(pipeline)].data(); }

const char* target_name(Pipeline pipeline, Target target) {
  return raster::name_of(pipeline == Pipeline::fast ? target : Target::scalar);
}

}  // namespace lode::experiments
