#pragma once
/// How the program fails: an exit status and one line that says where, what was expected, and what was found.

#include <stdexcept>
#include <string>
#include <string_view>

#include "geometry/shortened.h"

namespace lode::experiments {

/// The program's exit statuses.
enum class Status : int { done = 0, check_failed = 1, wrong_usage = 2, bad_input = 3, machine_failed = 4 };

class Error : public std::runtime_error {
 public:
  Error(Status status, const std::string& message) : std::runtime_error(message), status_(status) {}
  [[nodiscard]] Status status() const noexcept { return status_; }

 private:
  Status status_;
};

/// The text with every control character (a line break in a file name, say) made '?'.
[[nodiscard]] std::string one_line(std::string_view text);

using geometry::shortened;

}  // namespace lode::experiments
