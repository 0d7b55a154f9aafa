#include "experiments/run/machine.h"

#include <fstream>
#include <thread>

namespace lode::experiments {
namespace {

std::string processor() {
  std::ifstream file("/proc/cpuinfo");
  for (std::string line; std::getline(file, line);) {
    const std::size_t colon = line.find(": ");
    if (line.starts_with("model name") && colon != std::string::npos) return line.substr(colon + 2);
  }
  return "unknown";
}

}  // namespace

Machine this_machine() {
#if defined(__clang__)
  const std::string compiler = "clang++ " __clang_version__;
#else
  const std::string compiler = "g++ " __VERSION__;
#endif
#if defined(NDEBUG)
  const std::string build = "optimized";
#else
  const std::string build = "with assertions";
#endif
  return {processor(), compiler, build, int(std::thread::hardware_concurrency())};
}

}  // namespace lode::experiments
