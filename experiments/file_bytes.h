#pragma once
/// A whole file in memory.

#include <optional>
#include <string>

namespace lode::experiments {

/// Its bytes; nothing if it cannot be opened, or not be read to its end (a folder, say).
[[nodiscard]] std::optional<std::string> file_bytes(const std::string& path);

}  // namespace lode::experiments
