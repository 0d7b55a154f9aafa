#pragma once
/// How the renderer does its work, as words on the command line: which pipeline, for which instruction set, with which
/// skips. None of it moves a pixel. Every reader throws Error (wrong_usage).

#include <string_view>

#include "raster/render.h"

namespace lode::experiments {

[[nodiscard]] raster::Pipeline read_pipeline(std::string_view name);

/// "best" is the widest that this processor has; one that it lacks is an error, as is a name that is none.
[[nodiscard]] raster::Target read_target(std::string_view name);

/// The skips that are on: "all", "none", or names with commas between them.
[[nodiscard]] raster::Skips read_skips(std::string_view list);

/// "fast", "reference".
[[nodiscard]] const char* pipeline_name(raster::Pipeline pipeline);
/// The instruction set that a pipeline's inner loops were written for: the reference has none of its own.
[[nodiscard]] const char* target_name(raster::Pipeline pipeline, raster::Target target);

}  // namespace lode::experiments
