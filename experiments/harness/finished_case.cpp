#include "experiments/harness/finished_case.h"

#include <algorithm>

#include "experiments/file_bytes.h"
#include "experiments/report/html.h"
#include "experiments/whole_file.h"

namespace lode::experiments {

void add_files(const std::string& folder, const std::vector<std::string>& names, FinishedCase& one) {
  for (const std::string& name : names) {
    Row row;
    row.add("name", name);
    row.add("bytes", base64(file_bytes(folder + "/" + name).value_or("")));
    one.files.push_back(std::move(row));
  }
}

void write_files(const FinishedCase& one, const std::string& folder) {
  for (const Row& file : one.files) {
    write_whole_file(folder + "/" + file.text("name"), from_base64(file.text("bytes")));
  }
}

std::string text_of(const FinishedCase& one) {
  return rows_json(one.result.results) + "\n" + rows_json(one.result.times) + "\n" + rows_json(one.result.losses) +
         "\n" + rows_json(one.files);
}

bool read_case(std::string_view text, FinishedCase& one) {
  for (std::vector<Row>* rows : {&one.result.results, &one.result.times, &one.result.losses, &one.files}) {
    const std::size_t end = std::min(text.find('\n'), text.size());
    if (!rows_of(text.substr(0, end), *rows)) return false;
    text.remove_prefix(std::min(end + 1, text.size()));
  }
  return true;
}

}  // namespace lode::experiments
