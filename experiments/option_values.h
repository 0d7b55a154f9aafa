#pragma once
/// Values of options as words on the command line. Every function throws Error (wrong_usage) that names the option,
/// what was expected and what was found. Numbers are C's decimal ones, the same in every locale.

#include <glm/vec2.hpp>
#include <glm/vec3.hpp>
#include <glm/vec4.hpp>
#include <optional>
#include <span>
#include <string>
#include <string_view>
#include <vector>

namespace lode::experiments {

/// The whole text as a finite number; nothing if it is none.
[[nodiscard]] std::optional<double> number_in(std::string_view text);
/// The whole text as a whole number without a sign, below 2^63; nothing if it is none.
[[nodiscard]] std::optional<std::int64_t> whole_number_in(std::string_view text);
/// The parts between the separators; one part, perhaps empty, if there are none.
[[nodiscard]] std::vector<std::string_view> split(std::string_view text, char separator);

[[noreturn]] void fail_value(std::string_view option, std::string_view expected, std::string_view found);

[[nodiscard]] double read_number(std::string_view option, std::string_view text);
[[nodiscard]] glm::dvec3 read_vector(std::string_view option, std::string_view text);  ///< "x,y,z"
[[nodiscard]] glm::dvec4 read_color(std::string_view option, std::string_view text);   ///< "r,g,b,a", each 0…1
[[nodiscard]] glm::ivec2 read_size(std::string_view option, std::string_view text);    ///< "WxH", 1…32768 a side
[[nodiscard]] glm::ivec2 read_pixel(std::string_view option, std::string_view text);   ///< "X,Y", each 0…32767

/// The place of the text among the names.
[[nodiscard]] std::size_t read_choice(std::string_view option, std::string_view text,
                                      std::span<const std::string_view> names);

}  // namespace lode::experiments
