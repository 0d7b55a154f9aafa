#pragma once
/// A technique as an experiment runs it: with its settings, and with the renderer's own occlusion skipping on or off.
/// And the oracle, which is no technique: it is told what can be seen and draws that, at no cost, so that nothing that
/// leaves out whole objects can be faster.

#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include "experiments/technique_list.h"

namespace lode::experiments {

/// The method that is told what can be seen; and what follows a method's name if the renderer skips, too.
inline constexpr std::string_view kOracle = "oracle", kWithSkips = " + skips";

/// A method's name without kWithSkips.
[[nodiscard]] std::string_view without_skips(std::string_view method);

struct Method {
  std::string name;  ///< of its rows: "convex_culling:mode=safe", with kWithSkips if the renderer skips, too
  TechniqueChoice technique;
  bool oracle = false;          ///< kOracle: the technique is not asked
  bool renderer_skips = false;  ///< what is behind what was drawn (Skips::occlusion); all other skips are always on
};

/// Every setting, those that were not named, too: what a method's results depend on.
[[nodiscard]] std::string settings_of(const Method& method);

/// "technique:k=v" or "oracle", either with " + skips" or without. Throws Error as read_technique does.
[[nodiscard]] Method make_method(std::string_view text);

/// A method at work on a world, prepared.
class PreparedMethod {
 public:
  PreparedMethod(const Method& method, const techniques::World& world, const raster::RenderOptions& options);

  /// What the method took for one frame, ms.
  struct Times {
    double technique_ms = 0.0, render_ms = 0.0;
    [[nodiscard]] double frame_ms() const { return technique_ms + render_ms; }
  };
  /// What the oracle draws in the frames that follow.
  void show(std::vector<techniques::ObjectId> objects) { shown_ = std::move(objects); }

  /// Forgets what it remembers from frame to frame.
  void cut() { technique_.cut(); }

  /// Decides and draws.
  Times draw(const techniques::View& view, raster::Image& image, const glm::vec4& clear = glm::vec4(0.0f));

  [[nodiscard]] const Method& method() const { return method_; }
  [[nodiscard]] techniques::Promise promise() const {
    return method_.oracle ? techniques::Promise::conservative_sampled : technique_.promise();
  }
  [[nodiscard]] double prepare_ms() const { return prepare_ms_; }
  // Of the last frame.
  [[nodiscard]] const techniques::Stage& stage() const { return stage_; }
  [[nodiscard]] const techniques::Counters& counters() const { return counters_; }
  [[nodiscard]] std::uint64_t counter(std::string_view name) const;  ///< 0 if the technique has none of the name
  [[nodiscard]] const raster::FrameStats& work() const { return work_; }

 private:
  Method method_;
  raster::RenderOptions options_;
  raster::FrameMemory memory_;
  techniques::Stage stage_;
  AnyTechnique technique_;
  std::vector<techniques::ObjectId> shown_;
  double prepare_ms_ = 0.0;
  techniques::Counters counters_;
  raster::FrameStats work_;
};

}  // namespace lode::experiments
