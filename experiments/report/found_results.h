#pragma once
/// What `lodestone run` left in a folder, read back for a report.

#include <string>
#include <vector>

#include "experiments/harness/row.h"

namespace lode::experiments {

struct FoundResults {
  std::string experiment, question, size, command;
  std::string machine;  ///< "AMD EPYC …, 2 processors, 2 threads, avx512, g++ 12.2.0"
  std::string images;   ///< the folder of its pictures
  std::vector<Row> results, times, summary;
};

/// Throws Error (bad_input), naming the file, if what is there is not what `run` writes.
[[nodiscard]] FoundResults read_results(const std::string& folder);

/// Rows of a CSV text as csv_text makes it; numbers are numbers again. Throws Error (bad_input), naming file and line.
[[nodiscard]] std::vector<Row> rows_of_csv(const std::string& file, std::string_view text);

}  // namespace lode::experiments
