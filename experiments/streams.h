#pragma once
/// Where a command reads and writes besides its files.

#include <iosfwd>

namespace lode::experiments {

struct Streams {
  std::istream& in;
  std::ostream& out;
  std::ostream& err;             ///< errors and progress
  bool err_is_terminal = false;  ///< progress is shown on a terminal only
};

}  // namespace lode::experiments
