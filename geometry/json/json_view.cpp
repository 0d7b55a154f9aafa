#include "geometry/json/json_view.h"

#include <algorithm>
#include <cfloat>
#include <cmath>
#include <nlohmann/json.hpp>

#include "geometry/error.h"
#include "geometry/shortened.h"

namespace lode::geometry {
namespace {

using nlohmann::json;

/// The value as an error shows it: as it is if it is small, else what kind of thing it is.
std::string brief(const json& value) {
  if (value.is_object()) return value.empty() ? "{}" : "an object";
  const bool is_short =
      value.size() <= 8 && std::none_of(value.begin(), value.end(), [](const json& element) {
        return element.is_structured() || (element.is_string() && element.get_ref<const std::string&>().size() > 20);
      });
  if (value.is_array() && !is_short) return "an array of " + std::to_string(value.size());
  if (value.is_string()) return "\"" + shortened(value.get_ref<const std::string&>(), 40) + "\"";
  return value.dump();
}

}  // namespace

std::string JsonView::path() const {
  if (!parent_) return "";
  const std::string before = parent_->path();
  if (parent_->value_.is_array()) return before + "[" + std::to_string(index_) + "]";
  return before + (before.empty() ? "" : ".") + shortened(key_, 40);
}

std::string JsonView::place() const {
  const std::string within = path();
  return within.empty() ? name_ : name_ + ": " + within;
}

void JsonView::fail(std::string_view what) const {
  throw Error(ErrorKind::bad_input, place() + ": " + std::string(what));
}

void JsonView::fail_expected(std::string_view expected) const {
  fail("expected " + std::string(expected) + ", found " + brief(value_));
}

std::size_t JsonView::size(std::string_view expected) const {
  if (!value_.is_array()) fail_expected(expected);
  return value_.size();
}

JsonView JsonView::at(std::size_t index) const& { return {value_[index], *this, {}, index}; }

std::optional<JsonView> JsonView::find(std::string_view key) const& {
  const auto member = value_.find(key);
  if (member == value_.end()) return std::nullopt;
  return JsonView(*member, *this, key, 0);
}

JsonView JsonView::require(std::string_view key) const& {
  if (!value_.is_object()) fail_expected("an object");
  const auto member = value_.find(key);
  if (member == value_.end()) fail("expected \"" + std::string(key) + "\"");
  return JsonView(*member, *this, key, 0);
}

void JsonView::check_keys(std::span<const std::string_view> allowed) const {
  if (!value_.is_object()) fail_expected("an object");
  for (const auto& [key, value] : value_.items()) {
    if (std::find(allowed.begin(), allowed.end(), key) != allowed.end()) continue;
    std::string list;
    for (const std::string_view a : allowed) list.append(list.empty() ? "" : ", ").append(a);
    fail("unknown key \"" + shortened(key, 40) + "\": expected one of " + list);
  }
}

bool JsonView::boolean() const {
  if (!value_.is_boolean()) fail_expected("true or false");
  return value_.get<bool>();
}

std::int64_t JsonView::integer(std::int64_t low, std::int64_t high) const {
  // Compared as doubles: exact here, and neither huge integers nor huge floats need a cast.
  const double v = value_.is_number() ? value_.get<double>() : NAN;
  if (!(v >= double(low) && v <= double(high) && v == std::floor(v))) {
    fail_expected("a whole number " + std::to_string(low) + " to " + std::to_string(high));
  }
  return std::int64_t(v);
}

double JsonView::number(double low, double high) const {
  const double v = value_.is_number() ? value_.get<double>() : NAN;
  if (!(v >= low && v <= high)) {
    const bool any = low == -DBL_MAX && high == DBL_MAX;
    fail_expected(any ? "a number" : "a number " + json(low).dump() + " to " + json(high).dump());
  }
  return v;
}

float JsonView::float_number() const {
  const double v = value_.is_number() ? value_.get<double>() : NAN;
  if (!(std::fabs(v) <= double(FLT_MAX))) fail_expected("a number that a float holds");
  return float(v);
}

std::size_t JsonView::index(std::size_t n, std::string_view what) const {
  const double v = value_.is_number() ? value_.get<double>() : NAN;
  if (!(v >= 0.0 && v < double(n) && v == std::floor(v))) {
    fail_expected("an index of one of the " + std::to_string(n) + " " + std::string(what));
  }
  return std::size_t(v);
}

const std::string& JsonView::string() const {
  if (!value_.is_string()) fail_expected("a string");
  return value_.get_ref<const std::string&>();
}

std::size_t JsonView::choice(std::initializer_list<std::string_view> choices) const {
  std::string list;
  std::size_t index = 0;
  for (const std::string_view c : choices) {
    if (value_.is_string() && value_.get_ref<const std::string&>() == c) return index;
    ++index;
    list += list.empty() ? "" : index == choices.size() ? " or " : ", ";
    list.append("\"").append(c).append("\"");
  }
  fail_expected(list);
}

glm::vec4 JsonView::color() const {
  if (size("[r, g, b, a]") != 4) fail_expected("[r, g, b, a]");
  glm::vec4 color;
  for (int c = 0; c < 4; ++c) color[c] = float(at(std::size_t(c)).integer(0, 255));
  return color;
}

}  // namespace lode::geometry
