#include "geometry/model_file/line_reader.h"

#include <algorithm>
#include <charconv>
#include <cmath>
#include <system_error>

#include "geometry/error.h"
#include "geometry/shortened.h"

namespace lode::geometry {
namespace {

bool is_blank(char c) { return c == ' ' || c == '\t' || c == '\r' || c == '\v' || c == '\f'; }

template <class Number>
std::errc parse_whole(std::string_view word, Number& value) {
  if (word.starts_with('+')) word.remove_prefix(1);
  const auto [end, error] = std::from_chars(word.data(), word.data() + word.size(), value);
  return error == std::errc() && end != word.data() + word.size() ? std::errc::invalid_argument : error;
}

/// Of a number that does not fit: whether it is too small, not too large. Its exponent tells, or its leading zero.
bool is_tiny(std::string_view word) {
  const std::size_t exponent = word.find_first_of("eE");
  if (exponent != std::string_view::npos) return word.substr(exponent + 1).starts_with('-');
  return word.substr(word.find_first_not_of("+-")).find_first_of("0.") == 0;
}

}  // namespace

std::string_view Words::next() {
  std::size_t begin = 0;
  while (begin < left.size() && is_blank(left[begin])) ++begin;
  std::size_t end = begin;
  while (end < left.size() && !is_blank(left[end])) ++end;
  const std::string_view word = left.substr(begin, end - begin);
  left.remove_prefix(end);
  return word;
}

std::string_view Words::rest() const {
  std::string_view text = left;
  while (!text.empty() && is_blank(text.front())) text.remove_prefix(1);
  while (!text.empty() && is_blank(text.back())) text.remove_suffix(1);
  return text;
}

bool parse_number(std::string_view word, double& value) {
  const std::errc error = parse_whole(word, value);
  if (error == std::errc::result_out_of_range && is_tiny(word)) {
    value = 0.0;
    return true;
  }
  return error == std::errc() && std::isfinite(value);
}

bool parse_number(std::string_view word, float& value) {
  const std::errc error = parse_whole(word, value);
  if (error == std::errc::result_out_of_range) {
    double wide = 0.0;
    if (!parse_number(word, wide) || std::fabs(wide) > 1.0) return false;
    value = float(wide);  // 0: all that float can hold has been held
    return true;
  }
  return error == std::errc() && std::isfinite(value);
}

bool parse_number(std::string_view word, std::int64_t& value) { return parse_whole(word, value) == std::errc(); }

std::string_view LineReader::take_line() {
  const std::size_t end = std::min(text_.find('\n', at_), text_.size());
  std::string_view line = text_.substr(at_, end - at_);
  if (line.ends_with('\r')) line.remove_suffix(1);
  at_ = end + 1;
  return line;
}

bool LineReader::next_line() {
  number_ += 1 + n_joined_;
  n_joined_ = 0;
  if (at_ >= text_.size()) return false;
  std::string_view line = take_line();
  if (joins_ && line.ends_with('\\')) {
    joined_.clear();
    while (line.ends_with('\\')) {
      joined_.append(line.substr(0, line.size() - 1)).append(" ");
      ++n_joined_;
      line = at_ < text_.size() ? take_line() : std::string_view();
    }
    joined_.append(line);
    line = joined_;
  }
  words.left = line;
  return true;
}

float LineReader::number(std::string_view expected) {
  const std::string_view found = word();
  float value = 0.0f;
  if (!parse_number(found, value)) fail_expected(expected, found);
  return value;
}

std::int64_t LineReader::integer(std::string_view expected) {
  const std::string_view found = word();
  std::int64_t value = 0;
  if (!parse_number(found, value)) fail_expected(expected, found);
  return value;
}

void LineReader::fail(const std::string& what) const {
  throw Error(ErrorKind::bad_input, name_ + ": line " + std::to_string(number_) + ": " + what);
}

void LineReader::fail_expected(std::string_view expected, std::string_view found) const {
  fail("expected " + std::string(expected) + ", found " +
       (found.empty() ? "the end of the line" : "\"" + shortened(found, 40) + "\""));
}

}  // namespace lode::geometry
