#pragma once
/// The program as a function, so that tests can call it.

#include <iosfwd>

namespace lode::experiments {

/// Parses the arguments and runs a command. Errors become one line on `err`, and the exit status.
[[nodiscard]] int run_lodestone(int argc, const char* const* argv, std::istream& in, std::ostream& out,
                                std::ostream& err);

}  // namespace lode::experiments
