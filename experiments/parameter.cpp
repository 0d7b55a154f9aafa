#include "experiments/parameter.h"

#include <algorithm>
#include <charconv>
#include <cmath>
#include <optional>
#include <set>

#include "experiments/error.h"
#include "experiments/option_values.h"

namespace lode::experiments {
namespace {

std::string listed(std::span<const std::string> words) {
  std::string text;
  for (const std::string& word : words) text += (text.empty() ? "" : ", ") + word;
  return text;
}

std::string listed(std::span<const Parameter> parameters) {
  std::vector<std::string> names;
  for (const Parameter& p : parameters) names.push_back(p.name);
  return listed(names);
}

/// The value that the text stands for, if it is one that the parameter can have.
std::optional<double> value_in(const Parameter& p, std::string_view text) {
  if (!p.choices.empty()) {
    const auto found = std::find(p.choices.begin(), p.choices.end(), text);
    if (found == p.choices.end()) return std::nullopt;
    return double(found - p.choices.begin());
  }
  const std::optional<double> value = number_in(text);
  const bool fits = value && *value >= p.low && *value <= p.high && (!p.whole || *value == std::floor(*value));
  return fits ? value : std::nullopt;
}

std::string expected(const Parameter& p) {
  if (!p.choices.empty()) return "one of " + listed(p.choices);
  return std::string("a ") + (p.whole ? "whole " : "") + "number " + number_text(p.low) + " to " + number_text(p.high);
}

}  // namespace

Parameter choice_parameter(std::string name, std::string meaning, std::vector<std::string> choices,
                           std::size_t default_choice) {
  const double last = double(choices.size()) - 1.0;
  return {std::move(name), std::move(meaning), 0.0, last, double(default_choice), true, std::move(choices)};
}

ParameterValues default_values(std::span<const Parameter> parameters) {
  ParameterValues values;
  for (const Parameter& p : parameters) values[p.name] = p.default_value;
  return values;
}

void read_parameter(std::string_view where, std::span<const Parameter> known, std::string_view word,
                    ParameterValues& values) {
  const auto fail = [&](const std::string& message) {
    throw Error(Status::bad_input, std::string(where) + ": " + message);
  };
  const std::size_t equals = word.find('=');
  const std::string_view key = word.substr(0, equals);
  const auto parameter = std::find_if(known.begin(), known.end(), [&](const Parameter& p) { return p.name == key; });
  if (equals == std::string_view::npos || parameter == known.end()) {
    const std::string found = "\"" + shortened(word, 40) + "\": expected ";
    fail(found + (known.empty() ? "nothing, as there are no parameters" : "NAME=VALUE with one of " + listed(known)));
  }
  const std::string_view text = word.substr(equals + 1);
  const std::optional<double> value = value_in(*parameter, text);
  if (!value) fail(parameter->name + ": expected " + expected(*parameter) + ", found \"" + shortened(text, 40) + "\"");
  values[parameter->name] = *value;
}

ParameterValues read_parameters(std::string_view where, std::span<const Parameter> known, std::string_view text) {
  ParameterValues values = default_values(known);
  if (text.empty()) return values;
  std::set<std::string_view> given;
  for (const std::string_view word : split(text, ',')) {
    read_parameter(where, known, word, values);
    const std::string_view name = word.substr(0, word.find('='));
    if (!given.insert(name).second) {
      throw Error(Status::bad_input, std::string(where) + ": " + std::string(name) + ": expected once, found twice");
    }
  }
  return values;
}

std::string number_text(double value) {
  char text[40];
  const auto [end, error] = std::to_chars(text, text + sizeof text, value);
  return {text, error == std::errc() ? end : text};
}

std::string value_text(const Parameter& p, double value) {
  return p.choices.empty() ? number_text(value) : p.choices[std::size_t(value)];
}

std::string range_text(const Parameter& p) {
  if (!p.choices.empty()) return listed(p.choices);
  return number_text(p.low) + " to " + number_text(p.high) + (p.whole ? ", whole" : "");
}

}  // namespace lode::experiments
