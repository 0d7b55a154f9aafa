#pragma once
/// A finished case as it is kept, so that a run that was stopped goes on after it.

#include <string>
#include <string_view>
#include <vector>

#include "experiments/harness/culling_case.h"

namespace lode::experiments {

struct FinishedCase {
  CaseResult result;
  std::vector<Row> files;  ///< its pictures: name, bytes (base64)
};

/// Takes the files of these names into the case.
void add_files(const std::string& folder, const std::vector<std::string>& names, FinishedCase& one);
/// And writes them. Throws Error as write_whole_file does.
void write_files(const FinishedCase& one, const std::string& folder);

/// As text, and back: false for a text that is none.
[[nodiscard]] std::string text_of(const FinishedCase& one);
[[nodiscard]] bool read_case(std::string_view text, FinishedCase& one);

}  // namespace lode::experiments
