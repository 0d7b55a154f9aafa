#include "experiments/render/render_stats.h"

#include <algorithm>
#include <nlohmann/json.hpp>

#include "experiments/render/look_options.h"
#include "experiments/renderer_choice.h"
#include "experiments/sha256.h"

namespace lode::experiments {
namespace {

using nlohmann::ordered_json;

ordered_json summary_of(std::vector<double> times_ms) {
  std::sort(times_ms.begin(), times_ms.end());
  const std::size_t n = times_ms.size();
  return {{"median", 0.5 * (times_ms[(n - 1) / 2] + times_ms[n / 2])},
          {"min", times_ms.front()},
          {"max", times_ms.back()},
          {"n", n}};
}

template <class Element>
void add_hash(ordered_json& hashes, const char* plane, const raster::PixelPlane<Element>& elements) {
  if (!elements.empty()) hashes[plane] = sha256_hex(std::as_bytes(std::span(elements)));
}

}  // namespace

std::string render_stats_json(const RenderReport& report, const raster::Image& image) {
  ordered_json counters = ordered_json::object();
  raster::for_each_counter(report.counters, [&](const char* name, std::uint64_t value) { counters[name] = value; });
  ordered_json work = {
      {"objects", report.stage.objects},        {"primitives", report.stage.primitives},
      {"stand_ins", report.stage.stand_ins},    {"stand_in_primitives", report.stage.stand_in_primitives},
      {"plates", report.stage.plates},          {"captures", report.stage.captures},
      {"captured_px", report.stage.captured_px}};
  for (const techniques::Counter& c : report.technique_counters) work[c.name] = c.value;
  ordered_json hashes = ordered_json::object();
  add_hash(hashes, "color", image.rgba8);
  add_hash(hashes, "color", image.rgba32f);
  add_hash(hashes, "depth", image.depth);
  add_hash(hashes, "ids", image.ids);
  const ordered_json json = {{"scene", report.scene},
                             {"size", {image.size_px.x, image.size_px.y}},
                             {"samples", report.samples},
                             {"color_space", color_space_name(report.color_space)},
                             {"threads", report.threads},
                             {"target", target_name(report.pipeline, report.target)},
                             {"pipeline", pipeline_name(report.pipeline)},
                             {"pixel_contract", raster::kPixelContract},
                             {"prepare_ms", report.prepare_ms},
                             {"frame_ms", summary_of(report.frames_ms)},
                             {"counters", counters},
                             {"technique", report.technique},
                             {"technique_counters", work},
                             {"sha256", hashes}};
  // A path need not be UTF-8; JSON must be.
  return json.dump(1, ' ', false, ordered_json::error_handler_t::replace) + "\n";
}

}  // namespace lode::experiments
