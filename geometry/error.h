#pragma once
/// The one exception type that geometry/ throws, at its edges only: a file or parameter that cannot be used
/// (bad_input), or a machine that fails (machine: disk full, no memory). One line: where, expected, found.

#include <stdexcept>
#include <string>

namespace lode::geometry {

enum class ErrorKind { bad_input, machine };

class Error : public std::runtime_error {
 public:
  Error(ErrorKind kind, const std::string& message) : std::runtime_error(message), kind_(kind) {}
  [[nodiscard]] ErrorKind kind() const noexcept { return kind_; }

 private:
  ErrorKind kind_;
};

}  // namespace lode::geometry
