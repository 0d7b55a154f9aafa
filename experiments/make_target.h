#pragma once
/// Images of a size that the user chose. Where memory is promised that is not there, a picture that cannot fit must be
/// refused before it is filled, or the system ends the program.

#include "raster/image.h"

namespace lode::experiments {

/// Bytes of memory that this process can have at most: the machine's, or its control group's where that is less.
[[nodiscard]] std::uint64_t machine_memory_bytes();

/// As raster::make_image. Throws Error (machine_failed) also where the planes are larger than the machine's memory.
[[nodiscard]] raster::Image make_target(glm::ivec2 size_px, raster::ColorFormat format, raster::Planes planes);

}  // namespace lode::experiments
