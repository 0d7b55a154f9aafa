#include "experiments/harness/method.h"

#include <algorithm>
#include <chrono>

#include "raster/render.h"

namespace lode::experiments {
namespace {

double now_ms() {
  return std::chrono::duration<double, std::milli>(std::chrono::steady_clock::now().time_since_epoch()).count();
}

}  // namespace

std::string_view without_skips(std::string_view method) {
  return method.ends_with(kWithSkips) ? method.substr(0, method.size() - kWithSkips.size()) : method;
}

Method make_method(std::string_view text) {
  const std::string_view technique = without_skips(text);
  const bool oracle = technique == kOracle;
  return {std::string(text), read_technique("method", oracle ? "plain" : technique), oracle,
          text.ends_with(kWithSkips)};
}

std::string settings_of(const Method& method) {
  std::string text = method.oracle ? std::string(kOracle) : method.technique.entry->name;
  for (const Parameter& p : method.technique.entry->parameters) {
    text += " " + p.name + "=" + value_text(p, method.technique.values.at(p.name));
  }
  return text + std::string(method.renderer_skips ? kWithSkips : "");
}

PreparedMethod::PreparedMethod(const Method& method, const techniques::World& world,
                               const raster::RenderOptions& options)
    : method_(method), options_(options), stage_(world, options), technique_(method.technique.make()) {
  options_.memory = &memory_;
  options_.skips.occlusion = method.renderer_skips;
  const double begin_ms = now_ms();
  technique_.prepare(stage_);
  prepare_ms_ = now_ms() - begin_ms;
}

PreparedMethod::Times PreparedMethod::draw(const techniques::View& view, raster::Image& image, const glm::vec4& clear) {
  Times times;
  const double begin_ms = now_ms();
  stage_.begin(view);
  if (method_.oracle) {
    for (const techniques::ObjectId id : shown_) stage_.object(id);
  } else {
    counters_ = technique_.draw(view, stage_);
  }
  const std::span<const raster::Draw> draws = stage_.draws();
  const double decided_ms = now_ms();
  work_ = raster::render({.draws = draws, .clear = clear, .viewport = {}, .scissor = {}}, image, options_);
  times.technique_ms = decided_ms - begin_ms;
  times.render_ms = now_ms() - decided_ms;
  return times;
}

std::uint64_t PreparedMethod::counter(std::string_view name) const {
  const auto found = std::find_if(counters_.begin(), counters_.end(), [&](const auto& c) { return c.name == name; });
  return found == counters_.end() ? 0 : found->value;
}

}  // namespace lode::experiments
