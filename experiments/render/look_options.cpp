#include "experiments/render/look_options.h"

#include <CLI/CLI.hpp>
#include <cmath>

#include "experiments/error.h"
#include "experiments/option_values.h"
#include "raster/srgb.h"

namespace lode::experiments {
namespace {

constexpr std::string_view kShadings[] = {"material", "lambert", "unlit"};
constexpr std::string_view kColorSpaces[] = {"srgb", "raw"};

glm::vec4 clear_color(const glm::dvec4& display, techniques::ColorSpace space) {
  if (space == techniques::ColorSpace::raw) return glm::vec4(255.0 * display);
  const auto alpha = float(display.a);
  const auto linear = [&](double value) {
    return raster::srgb_decode(static_cast<std::uint8_t>(std::floor(255.0 * value + 0.5))) * alpha;
  };
  return {linear(display.r), linear(display.g), linear(display.b), alpha};
}

}  // namespace

void add_look_options(CLI::App& app, LookOptions& o) {
  app.add_option("--clear", o.clear,
                 "Background, display values 0 to 1 in steps of 1/255, premultiplied if raw (default 0,0,0,0)")
      ->option_text("R,G,B,A");
  app.add_option("--shading", o.shading,
                 "material (default: lit unless the material is unlit), lambert (all lit) or unlit")
      ->option_text("NAME");
  app.add_option("--technique", o.technique, "What is drawn in which way (default plain: the scene as it is)")
      ->option_text("NAME[:k=v,...]");
  app.add_option("--color-space", o.color_space,
                 "srgb (default: linear light inside) or raw (8-bit values as they are)")
      ->option_text("NAME");
}

Look read_look_options(const LookOptions& options) {
  Look look;
  look.draws.shading = techniques::Shading(read_choice("--shading", options.shading, kShadings));
  look.draws.color_space = techniques::ColorSpace(read_choice("--color-space", options.color_space, kColorSpaces));
  look.clear = clear_color(read_color("--clear", options.clear), look.draws.color_space);
  look.technique = read_technique("--technique", options.technique);
  return look;
}

const char* color_space_name(techniques::ColorSpace space) { return kColorSpaces[std::size_t(space)].data(); }

}  // namespace lode::experiments
