#pragma once
/// Pictures against the truth, as the report says it.

#include <string>
#include <vector>

#include "experiments/harness/row.h"

namespace lode::experiments {

/// How far the picture of everything is from the true picture by itself, and what each method adds to that: a sentence,
/// and a table of the methods whose pictures differ. HTML; empty for a summary (add_summary) without true errors.
[[nodiscard]] std::string truth_table(const std::vector<Row>& summary);

}  // namespace lode::experiments
