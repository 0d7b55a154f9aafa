#pragma once
/// How a scene is to look: options that `render` and `explain` share.

#include <glm/vec4.hpp>
#include <string>

#include "experiments/technique_list.h"
#include "techniques/scene_draws.h"

namespace CLI {
class App;
}

namespace lode::experiments {

/// As the words stand on the command line.
struct LookOptions {
  std::string clear = "0,0,0,0";
  std::string shading = "material";
  std::string technique = "plain";
  std::string color_space = "srgb";
};

void add_look_options(CLI::App& app, LookOptions& options);

struct Look {
  /// In the target's unit. srgb: the display values rounded to 8 bits and decoded, then premultiplied; raw: times 255.
  glm::vec4 clear{0.0f};
  techniques::SceneDraws::Params draws;
  TechniqueChoice technique;
};

/// Throws Error: wrong_usage; bad_input for a technique's parameter.
[[nodiscard]] Look read_look_options(const LookOptions& options);

/// "srgb", "raw".
[[nodiscard]] const char* color_space_name(techniques::ColorSpace space);

}  // namespace lode::experiments
