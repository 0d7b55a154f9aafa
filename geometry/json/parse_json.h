#pragma once
/// JSON text to a document, for files that people write by hand or that are hostile: syntax errors give line
/// and column; a key twice in one object and nesting deeper than any picture needs are errors too, not
/// silently dropped or followed down.

#include <nlohmann/json_fwd.hpp>
#include <string>
#include <string_view>

#include "geometry/memory_budget.h"

namespace lode::geometry {

/// Deepest nesting accepted. A picture has six levels: {draws: [{discs: [{center: [x]}]}]}.
inline constexpr int kMaxJsonDepth = 32;

/// The document. `name` is what errors call the text. The document's memory, which can be fifty times the text's, is
/// taken from the budget, if one is given. Throws Error (bad_input).
[[nodiscard]] nlohmann::json parse_json(std::string_view text, const std::string& name, MemoryBudget* budget = nullptr);

}  // namespace lode::geometry
