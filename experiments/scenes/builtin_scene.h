#pragma once
/// Scenes that the program makes by itself, by name and parameters: "sphere:radius=2,segments=200".

#include <functional>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "experiments/parameter.h"
#include "geometry/scene.h"

namespace lode::experiments {

using SceneValues = ParameterValues;

struct BuiltinScene {
  std::string name;
  std::string summary;
  std::vector<Parameter> parameters;
  std::function<geometry::Scene(const SceneValues&)> make;
};

/// All of them, in the order in which `list` has them.
[[nodiscard]] std::span<const BuiltinScene> builtin_scenes();

/// Whether the text before a ':' is the name of one.
[[nodiscard]] bool names_builtin_scene(std::string_view text);

/// The scene that "name:parameter=value,…" describes. Pure: the same text gives the same scene.
/// Throws Error (bad_input): an unknown name or parameter, with those that are known; a value out of range.
[[nodiscard]] geometry::Scene make_builtin_scene(std::string_view text);

}  // namespace lode::experiments
