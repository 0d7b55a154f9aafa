#pragma once
/// What a scene, a technique or an experiment takes by name, as "name=value,name=value".

#include <map>
#include <span>
#include <string>
#include <string_view>
#include <vector>

namespace lode::experiments {

/// A number, or one of some words.
struct Parameter {
  std::string name;
  std::string meaning;
  double low, high;  ///< both included
  double default_value;
  bool whole = false;                     ///< whole numbers only
  std::vector<std::string> choices = {};  ///< if any: the value is one of these words, kept as its index
};

/// A parameter that is one of some words.
[[nodiscard]] Parameter choice_parameter(std::string name, std::string meaning, std::vector<std::string> choices,
                                         std::size_t default_choice);

/// Values by parameter name: all that there are, checked.
using ParameterValues = std::map<std::string, double, std::less<>>;

[[nodiscard]] ParameterValues default_values(std::span<const Parameter> parameters);

/// Sets what "name=value" says. Throws Error (bad_input), beginning with `where`: a name that is unknown, with those
/// that are known; a value out of range.
void read_parameter(std::string_view where, std::span<const Parameter> known, std::string_view word,
                    ParameterValues& values);

/// The defaults, but for what "name=value,…" says; an empty text says nothing.
[[nodiscard]] ParameterValues read_parameters(std::string_view where, std::span<const Parameter> known,
                                              std::string_view text);

/// A number as short as it can be: "0.4", "1e+06".
[[nodiscard]] std::string number_text(double value);

/// A value as it would be typed: a number, or the word.
[[nodiscard]] std::string value_text(const Parameter& parameter, double value);

/// What a value may be: "0 to 1", "3 to 64, whole", "nearest, bilinear".
[[nodiscard]] std::string range_text(const Parameter& parameter);

}  // namespace lode::experiments
