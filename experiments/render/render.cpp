#include "experiments/render/render.h"

#include <chrono>
#include <utility>

#include "experiments/error.h"
#include "experiments/make_target.h"
#include "experiments/option_values.h"
#include "experiments/progress.h"
#include "experiments/render/render_stats.h"
#include "geometry/trigonometry.h"
#include "raster/error.h"
#include "raster/parallel.h"
#include "raster/render.h"

namespace lode::experiments {
namespace {

double now_ms() {
  return std::chrono::duration<double, std::milli>(std::chrono::steady_clock::now().time_since_epoch()).count();
}

/// The options, understood.
struct Request {
  ViewRequest view;
  Look look;
  int n_repeat = 1, n_before = 0;
  double orbit_rad = 0.0;
};

Request read_options(const RenderOptions& options) {
  Request request{read_scene_options(options.scene), read_look_options(options.look)};
  const std::optional<std::int64_t> repeat = whole_number_in(options.repeat);
  if (!repeat || *repeat < 1 || *repeat > 1'000'000) {
    fail_value("--repeat", "a whole number 1 to 1000000", options.repeat);
  }
  request.n_repeat = int(*repeat);
  const std::optional<std::int64_t> after = whole_number_in(options.after);
  if (!after || *after < 0 || *after > 1'000'000) fail_value("--after", "a whole number 0 to 1000000", options.after);
  request.n_before = int(*after);
  request.orbit_rad = read_number("--orbit", options.orbit) * geometry::kPi / 180.0;
  if (!(std::abs(request.orbit_rad) * (request.n_before + request.n_repeat) <= 1e6))
    fail_value("--orbit", "fewer degrees in all", options.orbit);

  const OutputPaths& outputs = options.outputs;
  check_output_paths(outputs, options.scene.scene);
  if (request.view.n_samples > 1 && (outputs.depth || outputs.ids)) {
    throw Error(Status::wrong_usage,
                "--samples " + options.scene.samples +
                    ": several samples a pixel have no depth and no ids: expected 1 for --depth and --ids");
  }
  if (options.no_color && outputs.out) throw Error(Status::wrong_usage, "--no-color and --out: expected one of them");
  return request;
}

/// Everything that one frame after the other is drawn from.
class FrameRenderer {
 public:
  FrameRenderer(const Request& request, const SceneView& view, const raster::RenderOptions& options)
      : request_(request),
        view_(view),
        options_(options),
        world_(view.scene, request.look.draws, options.pipeline == raster::Pipeline::fast, options.threads),
        stage_(world_, options),
        technique_(request.look.technique.make()) {
    technique_.prepare(stage_);
    options_.memory = &memory_;
  }

  /// Frame k of an orbit; all frames are the same without one.
  raster::FrameStats render(int k, raster::Image& image, Progress& progress) {
    const bool turned = k > 0 && request_.orbit_rad != 0.0;
    const geometry::Camera camera =
        turned ? geometry::orbited(view_.camera, view_.bounds.centre(), k * request_.orbit_rad) : view_.camera;
    const techniques::View view{.camera = camera, .size_px = view_.size_px, .background = request_.look.clear};
    stage_.begin(view);
    technique_counters_ = technique_.draw(view, stage_);
    options_.on_tile = [&progress] { progress.add(1); };
    const raster::Frame frame{.draws = stage_.draws(),
                              .clear = request_.look.clear,
                              .viewport = {},
                              .scissor = {},
                              .samples_fx8 = view_.samples_fx8};
    return raster::render(frame, image, options_);
  }

  [[nodiscard]] const techniques::Counters& technique_counters() const { return technique_counters_; }
  [[nodiscard]] const techniques::Stage& stage() const { return stage_; }

 private:
  const Request& request_;
  const SceneView& view_;
  raster::RenderOptions options_;
  raster::FrameMemory memory_;
  techniques::World world_;
  techniques::Stage stage_;
  AnyTechnique technique_;
  techniques::Counters technique_counters_;
};

void render_view(const Request& request, const SceneView& view, const RenderOptions& options,
                 const CommonOptions& common, const Streams& streams, OutputFiles& files) {
  RenderReport report{.scene = options.scene.scene,
                      .threads = raster::worker_count(common.threads),
                      .pipeline = common.pipeline,
                      .target = common.target,
                      .samples = request.view.n_samples,
                      .color_space = request.look.draws.color_space,
                      .frames_ms = {},
                      .counters = {}};
  const double prepare_begin_ms = now_ms();
  FrameRenderer renderer(request, view, common.render_options());
  report.prepare_ms = now_ms() - prepare_begin_ms;

  // Frames before are drawn for what a technique remembers. The first frame warms up, and is the one that is written
  // and hashed, with all the planes that this takes. Frames that are timed have colour and depth, and ids if they are
  // written.
  const bool with_stats = options.outputs.stats.has_value(), single = request.view.n_samples == 1;
  const int n_timed = with_stats || request.n_repeat > 1 ? request.n_repeat : 0;
  raster::Planes first_planes = files.planes(), timed_planes = first_planes;
  if (with_stats) first_planes = {.color = !options.no_color, .depth = single, .ids = single};
  timed_planes.color = !options.no_color;
  timed_planes.depth = single;

  const raster::ColorFormat format = techniques::color_format(request.look.draws.color_space);
  raster::Image first = make_target(view.size_px, format, first_planes);
  raster::Image timed;
  if (n_timed > 0) timed = make_target(view.size_px, format, timed_planes);

  Progress progress(
      streams, common, "rendering", "tiles",
      std::uint64_t(request.n_before + 1 + n_timed) * raster::n_tiles(view.size_px, common.render_options()));
  for (int k = 0; k < request.n_before; ++k) static_cast<void>(renderer.render(k, first, progress));
  report.counters = renderer.render(request.n_before, first, progress);
  report.technique = request.look.technique.entry->name;
  report.technique_counters = renderer.technique_counters();
  report.stage = renderer.stage().work();
  for (int k = 0; k < n_timed; ++k) {
    const double begin_ms = now_ms();
    static_cast<void>(renderer.render(request.n_before + k, timed, progress));
    report.frames_ms.push_back(now_ms() - begin_ms);
  }
  progress.finish();

  files.write(first);
  if (with_stats) files.write_stats(render_stats_json(report, first), streams.out);
}

}  // namespace

void render(const RenderOptions& options, const CommonOptions& common, const Streams& streams) {
  const Request request = read_options(options);
  OutputFiles files(options.outputs);
  const SceneView view = open_view(request.view);
  refuse_to_replace(view.scene.files, options.outputs);
  try {
    render_view(request, view, options, common, streams, files);
  } catch (const raster::Error& error) {
    const bool memory = error.kind() == raster::ErrorKind::out_of_memory;
    throw Error(memory ? Status::machine_failed : Status::bad_input, view.scene.name + ": " + error.what());
  }
  files.publish(streams.out);
}

}  // namespace lode::experiments
