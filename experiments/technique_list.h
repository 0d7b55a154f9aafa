#pragma once
/// The techniques that --technique can name.

#include <span>
#include <string>
#include <vector>

#include "experiments/parameter.h"

namespace lode::experiments {

struct TechniqueEntry {
  std::string name;
  std::string summary;
  std::vector<Parameter> parameters;
};

[[nodiscard]] std::span<const TechniqueEntry> technique_list();

}  // namespace lode::experiments
