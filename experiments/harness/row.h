#pragma once
/// What an experiment found, as rows of named values: one tidy row for each frame and setting.

#include <cstdint>
#include <span>
#include <string>
#include <string_view>
#include <utility>
#include <variant>
#include <vector>

namespace lode::experiments {

class Row {
 public:
  using Value = std::variant<std::string, std::int64_t, double>;

  Row& add(std::string name, Value value) {
    cells_.emplace_back(std::move(name), std::move(value));
    return *this;
  }
  [[nodiscard]] std::span<const std::pair<std::string, Value>> cells() const { return cells_; }
  /// Null if there is none of the name.
  [[nodiscard]] const Value* find(std::string_view name) const;
  /// The number of that name; 0 if there is none, or if it is a text.
  [[nodiscard]] double number(std::string_view name) const;
  [[nodiscard]] std::string text(std::string_view name) const;  ///< of any value; empty if there is none

 private:
  std::vector<std::pair<std::string, Value>> cells_;
};

/// Rows of the column's value.
[[nodiscard]] std::vector<Row> rows_with(const std::vector<Row>& rows, std::string_view column,
                                         const std::string& value);

/// The values of a column, each once, in the order in which they come.
[[nodiscard]] std::vector<std::string> values_of(const std::vector<Row>& rows, std::string_view column);

/// A header and a line a row (RFC 4180): columns in the order in which rows bring them, empty where a row has none.
/// Numbers are as short as they can be and read back as they were.
[[nodiscard]] std::string csv_text(std::span<const Row> rows);

/// JSON, and back. `rows_of` gives nothing for a text that rows_json did not make.
[[nodiscard]] std::string rows_json(std::span<const Row> rows);
[[nodiscard]] bool rows_of(std::string_view json, std::vector<Row>& rows);

}  // namespace lode::experiments
