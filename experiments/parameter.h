#pragma once
/// A number that a scene, a technique or an experiment takes by name.

#include <string>

namespace lode::experiments {

struct Parameter {
  std::string name;
  std::string meaning;
  double low, high;  ///< both included
  double default_value;
  bool whole = false;  ///< whole numbers only
};

/// A number as short as it can be: "0.4", "1e+06".
[[nodiscard]] std::string number_text(double value);

}  // namespace lode::experiments
