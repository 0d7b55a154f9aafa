#pragma once
/// Text of unknown length for an error that is one line.

#include <string>
#include <string_view>

namespace lode::geometry {

/// The text if it has at most `n_max` bytes, else its beginning and its end around "...", cut between characters.
[[nodiscard]] std::string shortened(std::string_view text, std::size_t n_max);

}  // namespace lode::geometry
