#include "experiments/technique_list.h"

namespace lode::experiments {

std::span<const TechniqueEntry> technique_list() {
  static const std::vector<TechniqueEntry> list = {{"plain", "The scene as it is: every instance is a draw", {}}};
  return list;
}

}  // namespace lode::experiments
