#pragma once
/// What a technique is: a plain struct that turns (scene, camera) into a frame. There is no base class; a technique has
/// the members that the concept below names, and whoever runs techniques erases their types.
///
///   struct Everything {
///     Promise promise() const { return Promise::exact; }
///     void prepare(Stage&) {}                       // once per scene
///     void cut() {}                                 // forget what was remembered from frame to frame
///     Counters draw(const View&, Stage& stage) {    // once per frame
///       for (ObjectId id = 0; id < stage.world().objects().size(); ++id) stage.object(id);
///       return {};
///     }
///   };

#include <concepts>
#include <cstdint>
#include <glm/vec2.hpp>
#include <glm/vec4.hpp>
#include <utility>
#include <vector>

#include "geometry/camera.h"

namespace lode::techniques {

class Stage;

/// What a frame is asked for.
struct View {
  geometry::Camera camera;
  glm::ivec2 size_px{0, 0};
  double time_s = 0.0;         ///< of the animation; still scenes ignore it
  glm::vec4 background{0.0f};  ///< where nothing is: premultiplied, in the target's unit
};

/// How a technique's picture differs from that of the whole scene.
enum class Promise : std::uint8_t {
  exact,                    ///< not at all: it leaves nothing out but what is outside the view
  conservative_sampled,     ///< no sample of the picture loses its winner
  conservative_continuous,  ///< no point of the screen does, so that no sample can, wherever it lies
  approximate               ///< it may; how often is measured
};
[[nodiscard]] const char* name_of(Promise promise);

/// Work that a technique did in one frame, by name; deterministic, the same names in every frame. A technique that
/// does nothing worth counting has none.
struct Counter {
  const char* name;
  std::uint64_t value;
};
using Counters = std::vector<Counter>;

template <class T>
concept Technique = requires(T technique, const View& view, Stage& stage) {
  { std::as_const(technique).promise() } -> std::same_as<Promise>;
  technique.prepare(stage);
  technique.cut();
  { technique.draw(view, stage) } -> std::same_as<Counters>;
};

}  // namespace lode::techniques
