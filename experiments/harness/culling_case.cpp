#include "experiments/harness/culling_case.h"

#include <algorithm>
#include <cstring>
#include <iterator>
#include <map>
#include <numeric>

#include "experiments/harness/view_key.h"
#include "experiments/harness/visible_samples.h"
#include "raster/render.h"
#include "techniques/objects_in_view.h"

namespace lode::experiments {
namespace {

using techniques::ObjectId;

template <class Plane>
bool same(const Plane& a, const Plane& b) {
  return a.size() == b.size() && (a.empty() || std::memcmp(a.data(), b.data(), a.size() * sizeof a[0]) == 0);
}
bool same_picture(const raster::Image& a, const raster::Image& b) {
  return same(a.rgba8, b.rgba8) && same(a.rgba32f, b.rgba32f) && same(a.depth, b.depth) && same(a.ids, b.ids);
}

double median(std::vector<double> values) {
  if (values.empty()) return 0.0;
  std::sort(values.begin(), values.end());
  return 0.5 * (values[(values.size() - 1) / 2] + values[values.size() / 2]);
}

std::string key_of(const CullingCase& one, std::size_t i, const techniques::View& view) {
  return "visible samples 2; contract " + std::to_string(raster::kPixelContract) + "; scene " + one.scene_hash +
         "; seed " + std::to_string(one.seed) + "; view " + std::to_string(one.frames[i]) + "; " + view_key(view);
}

class CaseRunner {
 public:
  CaseRunner(const CullingCase& one, const techniques::World& world, std::span<PreparedMethod* const> methods,
             const KeptResults& truth, const raster::RenderOptions& options)
      : one_(one), world_(world), methods_(methods), truth_(truth), options_(options) {
    options_.memory = &memory_;
    const raster::Planes planes{.color = true, .depth = true, .ids = true};
    whole_ = raster::make_image(one.size_px, techniques::color_format(world.color_space()), planes);
    drawn_ = whole_;
    timed_ = raster::make_image(one.size_px, techniques::color_format(world.color_space()),
                                {.color = true, .depth = true, .ids = false});
  }

  void add_results(std::size_t i, CaseResult& result) {
    const techniques::View view{.camera = one_.cameras[i], .size_px = one_.size_px};
    const VisibleSamples truth = visible(i, view);
    const std::vector<ObjectId> inside = techniques::objects_in_view(world_, view);
    const std::vector<raster::Draw> draws = world_.draws().draws(view.camera, view.size_px);
    static_cast<void>(
        raster::render({.draws = draws, .clear = glm::vec4(0.0f), .viewport = {}, .scissor = {}}, whole_, options_));
    const auto owns = [&](ObjectId id) { return truth.centre[id] > 0; };
    const auto n_visible = std::int64_t(std::count_if(inside.begin(), inside.end(), owns));
    std::vector<ObjectId> seen;
    std::copy_if(inside.begin(), inside.end(), std::back_inserter(seen), owns);
    for (PreparedMethod* method : methods_) method->show(seen);
    const auto n_shown = std::int64_t(std::accumulate(truth.centre.begin(), truth.centre.end(), std::uint64_t{0}));
    for (PreparedMethod* method : methods_) {
      static_cast<void>(method->draw(view, drawn_));
      Row row = frame_row(i, *method);
      for (const char* name : {"objects_in_view", "occluders", "tested", "culled"}) {
        row.add(name, std::int64_t(method->counter(name)));
      }
      row.add("objects", std::int64_t(method->stage().work().objects));
      row.add("primitives", std::int64_t(method->stage().work().primitives));
      const auto drawn = [&](ObjectId id) { return method->stage().drawn(id); };
      row.add("objects_in_view_drawn", std::int64_t(std::count_if(inside.begin(), inside.end(), drawn)));
      row.add("shown_px", n_shown)
          .add("visible", n_visible)
          .add("could_be_culled", std::int64_t(inside.size()) - n_visible);
      add_losses(*method, truth, row);
      row.add("same_picture", std::int64_t(same_picture(whole_, drawn_)));
      row.add("triangles_in", std::int64_t(method->work().triangles_in));
      row.add("boxes_hidden", std::int64_t(method->work().boxes_hidden));
      row.add("fragments_covered", std::int64_t(method->work().fragments_covered));
      row.add("fragments_shaded", std::int64_t(method->work().fragments_shaded));
      result.results.push_back(std::move(row));
    }
  }

  /// After add_results of the same view, which warms up.
  void add_times(std::size_t i, const std::function<void()>& on_step, CaseResult& result) {
    const techniques::View view{.camera = one_.cameras[i], .size_px = one_.size_px};
    struct Timed {
      std::vector<double> technique, render, frame;
      std::map<std::string, std::vector<double>, std::less<>> parts;
    };
    std::vector<Timed> timed(methods_.size());
    for (int round = 0; round < one_.n_rounds; ++round) {
      for (std::size_t k = 0; k < methods_.size(); ++k) {
        const std::size_t m = (k + std::size_t(round)) % methods_.size();
        const PreparedMethod::Times t = methods_[m]->draw(view, timed_);
        timed[m].technique.push_back(t.technique_ms), timed[m].render.push_back(t.render_ms);
        timed[m].frame.push_back(t.frame_ms());
        for (const techniques::PartTime& part : methods_[m]->stage().times()) {
          timed[m].parts[std::string(part.part)].push_back(part.ms);
        }
      }
      on_step();
    }
    for (std::size_t m = 0; m < methods_.size(); ++m) {
      Row row = frame_row(i, *methods_[m]);
      row.add("technique_ms", median(timed[m].technique)).add("render_ms", median(timed[m].render));
      row.add("frame_ms", median(timed[m].frame));
      for (const auto& [part, ms] : timed[m].parts) row.add(part + "_ms", median(ms));
      result.times.push_back(std::move(row));
    }
  }

 private:
  [[nodiscard]] VisibleSamples visible(std::size_t i, const techniques::View& view) const {
    const auto make = [&] { return text_of(visible_samples(world_, view, one_.seed, one_.frames[i], options_)); };
    const std::string key = key_of(one_, i, view);
    VisibleSamples samples;
    if (read_visible_samples(truth_.get(key, make), world_.objects().size(), samples)) return samples;
    const std::string made = make();  // what was kept is of another scene by the same name
    truth_.keep(key, made);
    static_cast<void>(read_visible_samples(made, world_.objects().size(), samples));
    return samples;
  }

  [[nodiscard]] Row frame_row(std::size_t i, const PreparedMethod& method) const {
    Row row;
    row.add("scene", one_.scene).add("path", one_.path).add("frame", std::int64_t(one_.frames[i]));
    row.add("method", method.method().name).add("promise", std::string(techniques::name_of(method.promise())));
    return row;
  }

  void add_losses(const PreparedMethod& method, const VisibleSamples& truth, Row& row) const {
    std::int64_t objects = 0, px = 0, grid = 0, random = 0;
    for (ObjectId id = 0; id < world_.objects().size(); ++id) {
      if (method.stage().drawn(id)) continue;
      objects += truth.centre[id] > 0 ? 1 : 0;
      px += truth.centre[id], grid += truth.grid[id], random += truth.random[id];
    }
    row.add("false_objects", objects).add("false_px", px);
    row.add("false_samples_4x4", grid).add("false_samples_random", random);
  }

  const CullingCase& one_;
  const techniques::World& world_;
  std::span<PreparedMethod* const> methods_;
  const KeptResults& truth_;
  raster::RenderOptions options_;
  raster::FrameMemory memory_;
  raster::Image whole_, drawn_, timed_;
};

}  // namespace

CaseResult run_culling_case(const CullingCase& one, const techniques::World& world,
                            std::span<PreparedMethod* const> methods, const KeptResults& truth,
                            const raster::RenderOptions& options, const std::function<void()>& on_step) {
  CaseResult result;
  CaseRunner runner(one, world, methods, truth, options);
  for (std::size_t i = 0; i < one.cameras.size(); ++i) {
    runner.add_results(i, result);
    on_step();
    if (one.n_rounds > 0) runner.add_times(i, on_step, result);
  }
  return result;
}

}  // namespace lode::experiments
