#include "experiments/harness/row.h"

#include <algorithm>
#include <nlohmann/json.hpp>

#include "experiments/parameter.h"

namespace lode::experiments {
namespace {

using nlohmann::ordered_json;

std::string text_of(const Row::Value& value) {
  if (const auto* text = std::get_if<std::string>(&value)) return *text;
  if (const auto* whole = std::get_if<std::int64_t>(&value)) return std::to_string(*whole);
  return number_text(std::get<double>(value));
}

std::string csv_cell(const std::string& text) {
  if (text.find_first_of(",\"\r\n") == std::string::npos) return text;
  std::string quoted = "\"";
  for (const char c : text) quoted += c == '"' ? std::string("\"\"") : std::string(1, c);
  return quoted + "\"";
}

}  // namespace

const Row::Value* Row::find(std::string_view name) const {
  const auto found = std::find_if(cells_.begin(), cells_.end(), [&](const auto& cell) { return cell.first == name; });
  return found == cells_.end() ? nullptr : &found->second;
}

double Row::number(std::string_view name) const {
  const Value* value = find(name);
  if (value == nullptr) return 0.0;
  if (const auto* whole = std::get_if<std::int64_t>(value)) return double(*whole);
  const auto* number = std::get_if<double>(value);
  return number ? *number : 0.0;
}

std::string Row::text(std::string_view name) const {
  const Value* value = find(name);
  return value == nullptr ? std::string() : text_of(*value);
}

std::vector<Row> rows_with(const std::vector<Row>& rows, std::string_view column, const std::string& value) {
  std::vector<Row> found;
  for (const Row& row : rows) {
    if (row.text(column) == value) found.push_back(row);
  }
  return found;
}

std::vector<std::string> values_of(const std::vector<Row>& rows, std::string_view column) {
  std::vector<std::string> values;
  for (const Row& row : rows) {
    const std::string value = row.text(column);
    if (std::find(values.begin(), values.end(), value) == values.end()) values.push_back(value);
  }
  return values;
}

std::string csv_text(std::span<const Row> rows) {
  std::vector<std::string> columns;
  for (const Row& row : rows) {
    for (const auto& [name, value] : row.cells()) {
      if (std::find(columns.begin(), columns.end(), name) == columns.end()) columns.push_back(name);
    }
  }
  std::string text;
  for (const std::string& column : columns) text += (text.empty() ? "" : ",") + csv_cell(column);
  text += "\n";
  for (const Row& row : rows) {
    for (std::size_t i = 0; i < columns.size(); ++i) text += (i > 0 ? "," : "") + csv_cell(row.text(columns[i]));
    text += "\n";
  }
  return text;
}

std::string rows_json(std::span<const Row> rows) {
  ordered_json all = ordered_json::array();
  for (const Row& row : rows) {
    ordered_json one = ordered_json::object();
    for (const auto& cell : row.cells()) {
      std::visit([&](const auto& value) { one[cell.first] = value; }, cell.second);
    }
    all.push_back(std::move(one));
  }
  return all.dump(-1, ' ', false, ordered_json::error_handler_t::replace);
}

bool rows_of(std::string_view json, std::vector<Row>& rows) {
  const ordered_json all = ordered_json::parse(json, nullptr, false);
  if (!all.is_array()) return false;
  std::vector<Row> read;
  for (const ordered_json& one : all) {
    if (!one.is_object()) return false;
    Row& row = read.emplace_back();
    for (const auto& [name, value] : one.items()) {
      if (value.is_string()) {
        row.add(name, value.get<std::string>());
      } else if (value.is_number_integer()) {
        row.add(name, value.get<std::int64_t>());
      } else if (value.is_number()) {
        row.add(name, value.get<double>());
      } else {
        return false;
      }
    }
  }
  rows = std::move(read);
  return true;
}

}  // namespace lode::experiments
