#include "experiments/draw/draw_stats.h"

#include <nlohmann/json.hpp>

#include "experiments/renderer_choice.h"
#include "experiments/sha256.h"

namespace lode::experiments {

std::string draw_stats_json(const DrawReport& report, const raster::Image& image) {
  using nlohmann::ordered_json;
  ordered_json draws = ordered_json::array();
  for (const raster::DrawStats& d : report.per_draw) draws.push_back({{"covered", d.covered}, {"visible", d.visible}});

  ordered_json counters = ordered_json::object();
  raster::for_each_counter(report.counters, [&](const char* name, std::uint64_t value) { counters[name] = value; });

  // An empty picture has planes of no bytes, and they have a hash too; a plane left out of a full one has not.
  const bool empty = image.size_px.x == 0 || image.size_px.y == 0;
  ordered_json sha256;
  sha256["color"] = sha256_hex(std::as_bytes(std::span(image.rgba8)));
  if (empty || !image.depth.empty()) sha256["depth"] = sha256_hex(std::as_bytes(std::span(image.depth)));
  if (empty || !image.ids.empty()) sha256["ids"] = sha256_hex(std::as_bytes(std::span(image.ids)));

  const ordered_json json = {{"picture", report.picture},
                             {"size", {image.size_px.x, image.size_px.y}},
                             {"threads", report.threads},
                             {"target", target_name(report.pipeline, report.target)},
                             {"pipeline", pipeline_name(report.pipeline)},
                             {"pixel_contract", raster::kPixelContract},
                             {"draws", draws},
                             {"counters", counters},
                             {"sha256", sha256}};
  // A path need not be UTF-8; JSON must be.
  return json.dump(1, ' ', false, ordered_json::error_handler_t::replace) + "\n";
}

}  // namespace lode::experiments
