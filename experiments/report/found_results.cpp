#include "experiments/report/found_results.h"

#include <charconv>
#include <nlohmann/json.hpp>

#include "experiments/error.h"
#include "experiments/file_bytes.h"

namespace lode::experiments {
namespace {

using json = nlohmann::ordered_json;  // rows keep the order of their values

std::string text_of_file(const std::string& path) {
  std::optional<std::string> text = file_bytes(path);
  if (!text) throw Error(Status::bad_input, path + ": cannot be read: expected what lodestone run writes");
  return *std::move(text);
}

/// One line's cells; `at` goes to the next line.
std::vector<std::string> cells_of_line(std::string_view text, std::size_t& at) {
  std::vector<std::string> cells(1);
  bool quoted = false;
  for (; at < text.size(); ++at) {
    const char c = text[at];
    if (quoted && c == '"' && at + 1 < text.size() && text[at + 1] == '"') {
      cells.back() += c;
      ++at;
    } else if (c == '"') {
      quoted = !quoted;
    } else if (!quoted && c == ',') {
      cells.emplace_back();
    } else if (!quoted && c == '\n') {
      ++at;
      break;
    } else {
      cells.back() += c;
    }
  }
  return cells;
}

Row::Value value_of(const std::string& text) {
  std::int64_t whole = 0;
  const char *begin = text.data(), *end = begin + text.size();
  if (const auto r = std::from_chars(begin, end, whole); r.ec == std::errc() && r.ptr == end) return whole;
  double number = 0.0;
  if (const auto r = std::from_chars(begin, end, number); r.ec == std::errc() && r.ptr == end) return number;
  return text;
}

std::string count_text(const json& count) {
  if (!count.is_number_unsigned()) throw json::other_error::create(501, "expected a whole number", &count);
  return std::to_string(count.get<std::uint64_t>());
}

/// The rows of a file beside the summary, as many as that says.
std::vector<Row> rows_beside(const std::string& path, const json& count) {
  std::vector<Row> rows = rows_of_csv(path, text_of_file(path));
  if (std::to_string(rows.size()) != count_text(count)) {
    throw Error(Status::bad_input, path + ": expected " + count_text(count) + " rows, as the summary says, found " +
                                       std::to_string(rows.size()));
  }
  return rows;
}

std::string machine_text(const json& m) {
  return m.at("processor").get<std::string>() + ", " + count_text(m.at("processors")) + " processors, " +
         count_text(m.at("threads")) + " threads, " + m.at("target").get<std::string>() + ", " +
         m.at("compiler").get<std::string>() + ", " + m.at("build").get<std::string>();
}

}  // namespace

std::vector<Row> rows_of_csv(const std::string& file, std::string_view text) {
  std::size_t at = 0, line = 1;
  const std::vector<std::string> names = cells_of_line(text, at);
  std::vector<Row> rows;
  while (at < text.size()) {
    ++line;
    const std::vector<std::string> cells = cells_of_line(text, at);
    if (cells.size() != names.size()) {
      throw Error(Status::bad_input, file + ":" + std::to_string(line) + ": expected " + std::to_string(names.size()) +
                                         " cells, found " + std::to_string(cells.size()));
    }
    Row& row = rows.emplace_back();
    for (std::size_t i = 0; i < names.size(); ++i) {
      if (!cells[i].empty()) row.add(names[i], value_of(cells[i]));
    }
  }
  return rows;
}

FoundResults read_results(const std::string& folder) {
  const std::string path = folder + "/summary.json";
  FoundResults found;
  try {
    const json summary = json::parse(text_of_file(path));
    found.experiment = summary.at("experiment");
    found.question = summary.at("question");
    found.size = summary.at("size");
    found.command = summary.at("command");
    found.machine = machine_text(summary.at("machine"));
    if (!rows_of(summary.at("summary").dump(), found.summary)) {
      throw Error(Status::bad_input, path + ": summary: expected rows of numbers and words");
    }
    found.results = rows_beside(folder + "/results.csv", summary.at("rows").at("results"));
    found.times = rows_beside(folder + "/times.csv", summary.at("rows").at("times"));
  } catch (const json::exception&) {
    throw Error(Status::bad_input, path + ": expected the summary that lodestone run writes");
  }
  found.images = folder + "/images";
  return found;
}

}  // namespace lode::experiments
