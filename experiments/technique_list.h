#pragma once
/// The techniques that --technique and experiments can name.

#include <functional>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "experiments/any_technique.h"
#include "experiments/parameter.h"

namespace lode::experiments {

struct TechniqueEntry {
  std::string name;
  std::string summary;
  std::vector<Parameter> parameters;
  std::function<AnyTechnique(const ParameterValues&)> make;
};

[[nodiscard]] std::span<const TechniqueEntry> technique_list();

/// What "name:parameter=value,…" asks for.
struct TechniqueChoice {
  const TechniqueEntry* entry = nullptr;
  ParameterValues values;
  [[nodiscard]] AnyTechnique make() const { return entry->make(values); }
};

/// Throws Error: wrong_usage for a name that is unknown, with those that are known; bad_input for a parameter.
[[nodiscard]] TechniqueChoice read_technique(std::string_view option, std::string_view text);

}  // namespace lode::experiments
