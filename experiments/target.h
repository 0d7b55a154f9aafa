#pragma once
/// Instruction sets that the renderer's kernels can be built for, and which of them this processor has.

#include <cstdint>
#include <string_view>

namespace lode::experiments {

enum class Target : std::uint8_t { scalar, sse4, avx2, avx512, neon, wasm };

/// "scalar", "sse4", ...
[[nodiscard]] std::string_view target_name(Target target);

/// The target that --target asks for; "best" is the widest that this processor has.
/// Throws Error (wrong_usage) for a name that is none, and for one that this processor lacks.
[[nodiscard]] Target read_target(std::string_view name);

}  // namespace lode::experiments
