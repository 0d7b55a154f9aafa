#pragma once
/// What times were taken on.

#include <string>

namespace lode::experiments {

struct Machine {
  std::string processor;  ///< "AMD EPYC 9R14"; "unknown" where the system does not tell
  std::string compiler;   ///< "g++ 12.2.0"
  std::string build;      ///< "Release"
  int n_processors = 1;
};

[[nodiscard]] Machine this_machine();

}  // namespace lode::experiments
