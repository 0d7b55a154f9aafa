#include "experiments/scenes/builtin_scene.h"

#include <algorithm>

#include "experiments/error.h"

namespace lode::experiments {
namespace {

[[noreturn]] void fail(std::string_view scene, const std::string& message) {
  throw Error(Status::bad_input, "scene " + shortened(scene, 80) + ": " + message);
}

template <class Named>
std::string names_of(std::span<const Named> list) {
  std::string names;
  for (const Named& item : list) names += (names.empty() ? "" : ", ") + item.name;
  return names;
}

std::string_view name_part(std::string_view text) { return text.substr(0, text.find(':')); }

}  // namespace

bool names_builtin_scene(std::string_view text) {
  const auto known = builtin_scenes();
  return std::any_of(known.begin(), known.end(), [&](const BuiltinScene& s) { return s.name == name_part(text); });
}

geometry::Scene make_builtin_scene(std::string_view text) {
  const std::string_view name = name_part(text);
  const auto known = builtin_scenes();
  const auto builtin = std::find_if(known.begin(), known.end(), [&](const BuiltinScene& s) { return s.name == name; });
  if (builtin == known.end()) {
    fail(text, "no such scene: expected a model file (.gltf, .glb, .obj, .ply, .stl) or one of " + names_of(known));
  }
  const std::string_view parameters = name.size() < text.size() ? text.substr(name.size() + 1) : std::string_view();
  const bool with_empty_list = name.size() < text.size() && parameters.empty();
  if (with_empty_list) fail(text, "expected NAME=VALUE after the colon");
  const SceneValues values = read_parameters("scene " + shortened(text, 80), builtin->parameters, parameters);
  geometry::Scene scene = builtin->make(values);
  scene.name = text;
  return scene;
}

}  // namespace lode::experiments
