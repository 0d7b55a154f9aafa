#include "experiments/target.h"

#include <string>

#include "experiments/error.h"

namespace lode::experiments {
namespace {

struct NamedTarget {
  Target target;
  std::string_view name;
};

/// Widest first.
constexpr NamedTarget kTargets[] = {{Target::avx512, "avx512"}, {Target::avx2, "avx2"}, {Target::sse4, "sse4"},
                                    {Target::neon, "neon"},     {Target::wasm, "wasm"}, {Target::scalar, "scalar"}};

bool processor_has(Target target) {
  switch (target) {
    case Target::scalar:
      return true;
#if defined(__x86_64__) || defined(__i386__)
    case Target::sse4:
      return __builtin_cpu_supports("sse4.2");
    case Target::avx2:
      return __builtin_cpu_supports("avx2");
    case Target::avx512:  // what server processors have had since 2017
      return __builtin_cpu_supports("avx512f") && __builtin_cpu_supports("avx512bw") &&
             __builtin_cpu_supports("avx512cd") && __builtin_cpu_supports("avx512dq") &&
             __builtin_cpu_supports("avx512vl");
#elif defined(__aarch64__)
    case Target::neon:
      return true;
#elif defined(__wasm_simd128__)
    case Target::wasm:
      return true;
#endif
    default:
      return false;
  }
}

}  // namespace

std::string_view target_name(Target target) {
  for (const NamedTarget& t : kTargets) {
    if (t.target == target) return t.name;
  }
  return "";
}

Target read_target(std::string_view name) {
  for (const NamedTarget& t : kTargets) {
    const bool has = processor_has(t.target);
    if (name == "best" && has) return t.target;
    if (name != t.name) continue;
    if (has) return t.target;
    throw Error(Status::wrong_usage, "--target " + std::string(name) + ": this processor lacks it");
  }
  throw Error(Status::wrong_usage, "--target: expected best, scalar, sse4, avx2, avx512, neon or wasm, found \"" +
                                       shortened(name, 40) + "\"");
}

}  // namespace lode::experiments
