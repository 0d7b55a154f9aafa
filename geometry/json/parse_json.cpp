#include "geometry/json/parse_json.h"

#include <algorithm>
#include <nlohmann/json.hpp>
#include <utility>
#include <vector>

#include "geometry/error.h"
#include "geometry/shortened.h"

namespace lode::geometry {
namespace {

using nlohmann::json;

// Upper bounds for what one value takes: a number or literal in an array that has grown by doubling, the allocations of
// a string, an array or an object, and an object's element with its key.
constexpr std::size_t kValueBytes = 48, kAllocationBytes = 64, kElementBytes = 112;

/// Takes the parser's events and builds the document. The names are nlohmann's (json_sax).
class DocumentBuilder {
 public:
  DocumentBuilder(std::string_view text, const std::string& name, MemoryBudget* budget)
      : text_(text), name_(name), budget_(budget) {}

  bool null() { return add(nullptr); }
  bool boolean(bool value) { return add(value); }
  bool number_integer(json::number_integer_t value) { return add(value); }
  bool number_unsigned(json::number_unsigned_t value) { return add(value); }
  bool number_float(json::number_float_t value, const json::string_t&) { return add(value); }
  bool string(json::string_t& value) {
    take(kAllocationBytes + value.size());
    return add(std::move(value));
  }
  bool binary(json::binary_t&) { return false; }  // not in JSON text

  bool start_object(std::size_t) { return open(json::value_t::object); }
  bool start_array(std::size_t) { return open(json::value_t::array); }
  bool end_object() { return close(); }
  bool end_array() { return close(); }

  bool key(json::string_t& key) {
    const auto [element, is_new] = open_.back()->get_ref<json::object_t&>().try_emplace(key);
    if (!is_new) fail(place() + ": key \"" + shortened(key, 40) + "\" occurs twice");
    take(kElementBytes + key.size());
    keys_.back() = key;
    element_ = &element->second;
    return true;
  }

  bool parse_error(std::size_t n_read, const std::string&, const json::exception& error) {
    // nlohmann's text is "[...] parse error at line L, column C: what"; numbers out of range lack the position.
    const std::string_view before = text_.substr(0, n_read == 0 ? 0 : std::min(n_read, text_.size() + 1) - 1);
    const std::size_t line = 1 + std::size_t(std::count(before.begin(), before.end(), '\n'));
    const std::size_t column = before.size() - (before.rfind('\n') + 1) + 1;  // npos + 1 is 0
    std::string_view what = error.what();
    what.remove_prefix(std::min(what.size(), what.find("] ") + 2));
    if (what.starts_with("parse error at")) what.remove_prefix(std::min(what.size(), what.find(": ") + 2));
    fail("line " + std::to_string(line) + ", column " + std::to_string(column) + ": " + shortened(what, 200));
  }

  json document;

 private:
  void take(std::size_t n_bytes) {
    if (budget_) budget_->take(n_bytes, name_);
  }

  template <class Value>
  bool add(Value&& value) {
    take(kValueBytes);
    *next() = std::forward<Value>(value);
    return true;
  }

  /// Where the next value goes: the document, a new array element, or the element of the last key.
  json* next() {
    if (open_.empty()) return &document;
    if (!open_.back()->is_array()) return element_;
    return &open_.back()->get_ref<json::array_t&>().emplace_back();
  }

  bool open(json::value_t type) {
    if (open_.size() == kMaxJsonDepth) {
      fail(place() + ": nested deeper than " + std::to_string(kMaxJsonDepth) + " levels");
    }
    take(kValueBytes + kAllocationBytes);
    json* const container = next();
    *container = type;
    open_.push_back(container);  // stays valid: its array grows only after it is closed
    keys_.emplace_back();
    return true;
  }

  bool close() {
    open_.pop_back();
    keys_.pop_back();
    return true;
  }

  /// "draws[2].texture"
  std::string place() const {
    std::string path;
    for (std::size_t level = 0; level + 1 < open_.size(); ++level) {
      if (open_[level]->is_array()) {
        path.append("[").append(std::to_string(open_[level]->size() - 1)).append("]");
      } else {
        path.append(path.empty() ? "" : ".").append(shortened(keys_[level], 40));
      }
    }
    return path.empty() ? "the document" : path;
  }

  [[noreturn]] void fail(const std::string& what) const { throw Error(ErrorKind::bad_input, name_ + ": " + what); }

  std::string_view text_;
  const std::string& name_;
  MemoryBudget* budget_;
  std::vector<json*> open_;        ///< containers not closed yet, outermost first
  std::vector<std::string> keys_;  ///< of each, the key last read; empty for arrays
  json* element_ = nullptr;        ///< value of the key last read
};

}  // namespace

json parse_json(std::string_view text, const std::string& name, MemoryBudget* budget) {
  // The parser takes a NUL for the end of the text; what follows it must not be lost without a word.
  if (const std::size_t nul = text.find('\0'); nul != std::string_view::npos) {
    const std::string_view before = text.substr(0, nul);
    const auto line = 1 + std::count(before.begin(), before.end(), '\n');
    const std::size_t column = nul - (before.rfind('\n') == std::string_view::npos ? 0 : before.rfind('\n') + 1) + 1;
    throw Error(ErrorKind::bad_input, name + ": line " + std::to_string(line) + ", column " + std::to_string(column) +
                                          ": a NUL byte: expected JSON text");
  }
  DocumentBuilder builder(text, name, budget);
  if (!json::sax_parse(text.begin(), text.end(), &builder)) throw Error(ErrorKind::bad_input, name + ": not JSON");
  return std::move(builder.document);
}

}  // namespace lode::geometry
