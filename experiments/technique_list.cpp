#include "experiments/technique_list.h"

#include "experiments/option_values.h"
#include "geometry/shortened.h"
#include "techniques/frustum_culling/frustum_culling.h"
#include "techniques/plain/plain.h"

namespace lode::experiments {
namespace {

std::vector<TechniqueEntry> make_list() {
  return {
      {"plain",
       "The scene as it is: every object is drawn",
       {},
       [](const ParameterValues&) { return AnyTechnique(techniques::Plain{}); }},
      {"frustum_culling",
       "Objects whose box is outside the view are left out",
       {},
       [](const ParameterValues&) { return AnyTechnique(techniques::FrustumCulling{}); }},
  };
}

}  // namespace

std::span<const TechniqueEntry> technique_list() {
  static const std::vector<TechniqueEntry> list = make_list();
  return list;
}

TechniqueChoice read_technique(std::string_view option, std::string_view text) {
  const std::string_view name = text.substr(0, text.find(':'));
  std::vector<std::string_view> names;
  for (const TechniqueEntry& technique : technique_list()) names.push_back(technique.name);
  const TechniqueEntry& entry = technique_list()[read_choice(option, name, names)];
  const std::string where = "technique " + geometry::shortened(text, 80);
  const std::string_view parameters = name.size() < text.size() ? text.substr(name.size() + 1) : std::string_view();
  return {&entry, read_parameters(where, entry.parameters, parameters)};
}

}  // namespace lode::experiments
