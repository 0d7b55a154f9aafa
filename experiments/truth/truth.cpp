#include "experiments/truth/truth.h"

#include <algorithm>
#include <chrono>
#include <nlohmann/json.hpp>

#include "experiments/error.h"
#include "experiments/option_values.h"
#include "experiments/progress.h"
#include "experiments/sha256.h"
#include "experiments/truth/check_report.h"
#include "experiments/truth/solid_draws.h"
#include "experiments/truth/tour.h"
#include "experiments/truth/trace_picture.h"
#include "raster/error.h"
#include "raster/parallel.h"

namespace lode::experiments::truth {
namespace {

/// The options, understood.
struct Request {
  ViewRequest view;
  Look look;
  bool check = false;
};

Request read_options(const TruthOptions& options) {
  Request request{read_scene_options(options.scene), read_look_options(options.look), options.check || options.tour};
  const OutputPaths& outputs = options.outputs;
  check_output_paths(outputs, options.scene.scene, options.map);
  const auto fail = [](const std::string& message) { throw Error(Status::wrong_usage, message); };
  if (request.view.n_samples > 1 && (outputs.depth || outputs.ids || request.check)) {
    fail("--samples " + options.scene.samples +
         ": several samples a pixel have no depth and no ids: expected 1 for --depth, --ids and --check");
  }
  const CameraOptions& camera = options.scene.camera;
  if (options.tour && (request.view.camera.name || request.view.camera.placed)) {
    fail("--tour and" + command_line(camera) + ": expected one of them");
  }
  if (options.tour && (outputs.out || outputs.depth || outputs.ids || options.map)) {
    fail("--tour: a picture of eight views: expected --check for --out, --depth, --ids and --map");
  }
  if (options.map && !request.check) fail("--map " + *options.map + ": expected --check with it");
  if (options.map && !geometry::image_format(*options.map)) {
    fail("--map " + *options.map + ": expected a file ending in .png, .exr or .npy");
  }
  if (request.check && outputs.stats == "-") fail("--check --stats -: two outputs on one standard output");
  return request;
}

CheckReport check_views(const TruthOptions& options, const SceneView& view, techniques::SceneDraws& draws,
                        const CommonOptions& common, const Streams& streams) {
  CheckReport report{options.scene.scene, view.size_px, {}};
  if (options.tour) {
    for (TourStop& stop : tour(view.bounds, view.size_px))
      report.views.push_back({stop.name, command_line(stop.options), {}});
  } else {
    report.views.push_back({"", command_line(options.scene.camera), {}});
  }
  const std::vector<TourStop> stops = options.tour ? tour(view.bounds, view.size_px) : std::vector<TourStop>{};
  const std::uint64_t n_pixels = std::uint64_t(view.size_px.x) * std::uint64_t(view.size_px.y);
  raster::FrameMemory memory;
  raster::RenderOptions raster_options = common.render_options();
  raster_options.memory = &memory;
  if (common.pipeline == raster::Pipeline::fast) draws.cut_clusters(common.threads);
  Progress progress(streams, common, "checking", "pixels", report.views.size() * n_pixels);
  for (std::size_t i = 0; i < report.views.size(); ++i) {
    const geometry::Camera camera =
        options.tour ? choose_camera(read_camera_options(stops[i].options), view.scene, view.bounds, view.size_px)
                     : view.camera;
    report.views[i].check =
        check_view(draws, camera, view.bounds, view.size_px, raster_options, [&](std::uint64_t n) { progress.add(n); });
  }
  progress.finish();
  return report;
}

/// A colour for each verdict, and around each pixel that differs its eight neighbours in half of it, so that a single
/// one is seen in a picture shown smaller; what both drew alike is grey.
std::vector<glm::u8vec4> verdict_map(const PictureCheck& check, glm::ivec2 size_px) {
  constexpr glm::u8vec3 kColors[kVerdicts] = {{64, 64, 64}, {255, 220, 0}, {40, 120, 255},
                                              {0, 200, 80}, {255, 0, 255}, {255, 0, 0}};
  std::vector<glm::u8vec4> map(check.verdicts.size(), glm::u8vec4(kColors[0], 255));
  const auto at = [&](int x, int y) { return std::size_t(y) * std::size_t(size_px.x) + std::size_t(x); };
  const auto color_of = [&](std::size_t i) { return kColors[std::size_t(check.verdicts[i])]; };
  for (int y = 0; y < size_px.y; ++y) {
    for (int x = 0; x < size_px.x; ++x) {
      if (check.verdicts[at(x, y)] == Verdict::same) continue;
      for (int ny = std::max(0, y - 1); ny <= std::min(size_px.y - 1, y + 1); ++ny) {
        for (int nx = std::max(0, x - 1); nx <= std::min(size_px.x - 1, x + 1); ++nx) {
          if (check.verdicts[at(nx, ny)] == Verdict::same)
            map[at(nx, ny)] = {color_of(at(x, y)) / std::uint8_t(2), 255};
        }
      }
      map[at(x, y)] = {color_of(at(x, y)), 255};
    }
  }
  return map;
}

struct TracedPicture {
  raster::Image image;
  double ms = 0.0;
};

TracedPicture trace(const Request& request, const SceneView& view, const techniques::SceneDraws& draws,
                    raster::Planes planes, const CommonOptions& common, const Streams& streams) {
  const auto begin = std::chrono::steady_clock::now();
  Progress progress(streams, common, "tracing", "rows", std::uint64_t(view.size_px.y));
  TracedPicture traced;
  traced.image = trace_picture(draws, view.camera, view.bounds,
                               {.size_px = view.size_px,
                                .samples_fx8 = view.samples_fx8,
                                .clear = request.look.clear,
                                .format = techniques::color_format(request.look.draws.color_space),
                                .planes = planes},
                               common.threads, [&] { progress.add(1); });
  progress.finish();
  traced.ms = std::chrono::duration<double, std::milli>(std::chrono::steady_clock::now() - begin).count();
  return traced;
}

template <class Element>
void add_hash(nlohmann::ordered_json& hashes, const char* plane, const raster::PixelPlane<Element>& elements) {
  if (!elements.empty()) hashes[plane] = sha256_hex(std::as_bytes(std::span(elements)));
}

std::string stats_json(const TruthOptions& options, const SceneView& view, const techniques::SceneDraws& draws,
                       const TracedPicture& traced, const CommonOptions& common) {
  nlohmann::ordered_json hashes = nlohmann::ordered_json::object();
  add_hash(hashes, "color", traced.image.rgba8);
  add_hash(hashes, "color", traced.image.rgba32f);
  add_hash(hashes, "depth", traced.image.depth);
  add_hash(hashes, "ids", traced.image.ids);
  const LeftOut left_out = solid_draws(view.scene, draws.draws(view.camera, view.size_px)).left_out;
  const nlohmann::ordered_json json = {
      {"scene", options.scene.scene},
      {"size", {view.size_px.x, view.size_px.y}},
      {"samples", view.samples_fx8.size()},
      {"color_space", color_space_name(read_look_options(options.look).draws.color_space)},
      {"threads", raster::worker_count(common.threads)},
      {"left_out", {{"lines", left_out.lines}, {"points", left_out.points}}},
      {"trace_ms", traced.ms},
      {"sha256", hashes}};
  return json.dump(1, ' ', false, nlohmann::ordered_json::error_handler_t::replace) + "\n";
}

Status run(const TruthOptions& options, const Request& request, const SceneView& view, const CommonOptions& common,
           const Streams& streams, OutputFiles& files, std::optional<WholeFile>& map) {
  techniques::SceneDraws draws(view.scene, request.look.draws);
  Status status = Status::done;
  if (request.check) {
    const CheckReport report = check_views(options, view, draws, common, streams);
    const std::string json = check_json(report);
    streams.out << json;
    if (options.outputs.stats) files.write_stats(json, streams.out);
    if (map) {
      geometry::write_color(map->file(), *geometry::image_format(*options.map), view.size_px,
                            verdict_map(report.views.front().check.picture, view.size_px));
    }
    status = conclude(report, streams.err);
  }
  raster::Planes planes = files.planes();
  const bool with_stats = options.outputs.stats && !request.check, single = view.samples_fx8.size() == 1;
  if (with_stats) planes = {.color = true, .depth = single, .ids = single};
  if (planes.color || planes.depth || planes.ids || !request.check) {
    const TracedPicture traced = trace(request, view, draws, planes, common, streams);
    files.write(traced.image);
    if (with_stats) files.write_stats(stats_json(options, view, draws, traced, common), streams.out);
  }
  return status;
}

}  // namespace

Status run_truth(const TruthOptions& options, const CommonOptions& common, const Streams& streams) {
  const Request request = read_options(options);
  OutputFiles files(options.outputs);
  std::optional<WholeFile> map;
  if (options.map) map.emplace(*options.map);
  const SceneView view = open_view(request.view);
  refuse_to_replace(view.scene.files, options.outputs, options.map);
  Status status = Status::done;
  try {
    status = run(options, request, view, common, streams, files, map);
  } catch (const raster::Error& error) {
    const bool memory = error.kind() == raster::ErrorKind::out_of_memory;
    throw Error(memory ? Status::machine_failed : Status::bad_input, view.scene.name + ": " + error.what());
  }
  files.publish(streams.out, map ? &*map : nullptr);
  return status;
}

}  // namespace lode::experiments::truth
