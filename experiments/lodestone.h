#pragma once
/// The program as a function, so that tests can call it.

#include "experiments/streams.h"

namespace lode::experiments {

/// Parses the arguments and runs a command. Errors become one line on `streams.err`, and the exit status.
[[nodiscard]] int run_lodestone(int argc, const char* const* argv, const Streams& streams);

}  // namespace lode::experiments
