#include "experiments/scenes/builtin_scene.h"

#include <algorithm>
#include <cmath>

#include "experiments/error.h"
#include "experiments/option_values.h"

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

void read_parameter(std::string_view scene, const BuiltinScene& builtin, std::string_view word, SceneValues& values) {
  const std::size_t equals = word.find('=');
  const std::string_view key = word.substr(0, equals);
  const auto& known = builtin.parameters;
  const auto parameter = std::find_if(known.begin(), known.end(), [&](const auto& p) { return p.name == key; });
  if (equals == std::string_view::npos || parameter == known.end()) {
    fail(scene, "\"" + shortened(word, 40) + "\": expected NAME=VALUE with one of " +
                    names_of(std::span<const Parameter>(known)));
  }
  const std::string_view text = word.substr(equals + 1);
  const std::optional<double> value = number_in(text);
  const bool fits = value && *value >= parameter->low && *value <= parameter->high &&
                    (!parameter->whole || *value == std::floor(*value));
  if (!fits) {
    fail(scene, parameter->name + ": expected a " + (parameter->whole ? "whole " : "") + "number " +
                    number_text(parameter->low) + " to " + number_text(parameter->high) + ", found \"" +
                    shortened(text, 40) + "\"");
  }
  values[parameter->name] = *value;
}

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
  SceneValues values;
  for (const Parameter& p : builtin->parameters) values[p.name] = p.default_value;
  if (name.size() < text.size()) {
    for (const std::string_view word : split(text.substr(name.size() + 1), ',')) {
      read_parameter(text, *builtin, word, values);
    }
  }
  geometry::Scene scene = builtin->make(values);
  scene.name = text;
  return scene;
}

}  // namespace lode::experiments
