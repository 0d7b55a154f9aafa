#pragma once
/// What a glTF file's "uri" may be: a file beside it, percent-encoded, or the bytes themselves. glTF 2.0, sec. 2.8.

#include <cstddef>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

namespace lode::geometry {

/// The bytes of a "data:...;base64," URI; nothing if it is one but is not base64 (RFC 4648, sec. 4; padding may lack).
[[nodiscard]] std::optional<std::vector<std::byte>> data_uri_bytes(std::string_view uri);

[[nodiscard]] bool is_data_uri(std::string_view uri);
/// Whether it begins with a scheme, such as "https:".
[[nodiscard]] bool has_scheme(std::string_view uri);

/// %20 to a space, and so on; what is no escape stays as it is.
[[nodiscard]] std::string percent_decoded(std::string_view uri);

}  // namespace lode::geometry
