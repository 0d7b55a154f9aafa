#pragma once
/// Reads the JSON of `lodestone draw` (`lodestone draw --help` lists what may be in it). Every key, type and
/// range is checked; what is wrong is said with its JSON path.

#include <iosfwd>
#include <string>
#include <string_view>

#include "experiments/draw/picture.h"

namespace lode::experiments {

/// Bytes of the file, or of standard input for "-"; at most 256 MiB. Throws Error (bad_input, machine_failed).
[[nodiscard]] std::string read_text(const std::string& path, std::istream& standard_input);

/// The picture that the JSON text describes; `name` is what errors call it. Throws Error (bad_input).
[[nodiscard]] Picture read_picture(std::string_view json_text, const std::string& name);

}  // namespace lode::experiments
