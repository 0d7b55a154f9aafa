#include "experiments/option_values.h"

#include <charconv>
#include <cmath>

#include "experiments/error.h"
#include "raster/image.h"

namespace lode::experiments {
namespace {

template <class Number>
std::optional<Number> all_of(std::string_view text) {
  Number value{};
  const auto [end, error] = std::from_chars(text.data(), text.data() + text.size(), value);
  if (error != std::errc() || end != text.data() + text.size()) return std::nullopt;
  return value;
}

/// n numbers between separators, or nothing.
template <glm::length_t n>
std::optional<glm::vec<n, double>> numbers_in(std::string_view text) {
  const std::vector<std::string_view> parts = split(text, ',');
  if (parts.size() != std::size_t(n)) return std::nullopt;
  glm::vec<n, double> v;
  for (glm::length_t i = 0; i < n; ++i) {
    const std::optional<double> value = number_in(parts[std::size_t(i)]);
    if (!value) return std::nullopt;
    v[i] = *value;
  }
  return v;
}

/// Two whole numbers, each in [low, high], or nothing.
std::optional<glm::ivec2> whole_pair(std::string_view text, char separator, std::int64_t low, std::int64_t high) {
  const std::vector<std::string_view> parts = split(text, separator);
  if (parts.size() != 2) return std::nullopt;
  const auto x = whole_number_in(parts[0]), y = whole_number_in(parts[1]);
  if (!x || !y || *x < low || *x > high || *y < low || *y > high) return std::nullopt;
  return glm::ivec2(int(*x), int(*y));
}

}  // namespace

std::optional<double> number_in(std::string_view text) {
  if (text.starts_with('+')) text.remove_prefix(1);
  const std::optional<double> value = all_of<double>(text);
  return value && std::isfinite(*value) ? value : std::nullopt;
}

std::optional<std::int64_t> whole_number_in(std::string_view text) {
  return text.starts_with('-') ? std::nullopt : all_of<std::int64_t>(text);
}

std::vector<std::string_view> split(std::string_view text, char separator) {
  std::vector<std::string_view> parts;
  for (;;) {
    const std::size_t at = text.find(separator);
    parts.push_back(text.substr(0, at));
    if (at == std::string_view::npos) return parts;
    text.remove_prefix(at + 1);
  }
}

void fail_value(std::string_view option, std::string_view expected, std::string_view found) {
  throw Error(Status::wrong_usage,
              std::string(option) + ": expected " + std::string(expected) + ", found \"" + shortened(found, 60) + "\"");
}

double read_number(std::string_view option, std::string_view text) {
  const std::optional<double> value = number_in(text);
  if (!value) fail_value(option, "a number", text);
  return *value;
}

glm::dvec3 read_vector(std::string_view option, std::string_view text) {
  const std::optional<glm::dvec3> v = numbers_in<3>(text);
  if (!v) fail_value(option, "three numbers x,y,z", text);
  return *v;
}

glm::dvec4 read_color(std::string_view option, std::string_view text) {
  const std::optional<glm::dvec4> v = numbers_in<4>(text);
  bool inside = v.has_value();
  for (glm::length_t i = 0; inside && i < 4; ++i) inside = (*v)[i] >= 0.0 && (*v)[i] <= 1.0;
  if (!inside) fail_value(option, "four numbers r,g,b,a from 0 to 1", text);
  return *v;
}

glm::ivec2 read_size(std::string_view option, std::string_view text) {
  const std::optional<glm::ivec2> size = whole_pair(text, 'x', 1, raster::kMaxTargetSize_px);
  if (!size) fail_value(option, "WIDTHxHEIGHT, each 1 to " + std::to_string(raster::kMaxTargetSize_px), text);
  return *size;
}

glm::ivec2 read_pixel(std::string_view option, std::string_view text) {
  const std::optional<glm::ivec2> pixel = whole_pair(text, ',', 0, raster::kMaxTargetSize_px - 1);
  if (!pixel) fail_value(option, "X,Y in whole pixels", text);
  return *pixel;
}

std::size_t read_choice(std::string_view option, std::string_view text, std::span<const std::string_view> names) {
  std::string expected;
  for (std::size_t i = 0; i < names.size(); ++i) {
    if (names[i] == text) return i;
    expected += (i == 0 ? "" : (i + 1 == names.size() ? " or " : ", ")) + std::string(names[i]);
  }
  fail_value(option, expected, text);
}

}  // namespace lode::experiments
