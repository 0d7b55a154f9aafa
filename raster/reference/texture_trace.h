#pragma once
/// Which texels a lookup reads, and with which weights: the steps of texture_sample.cpp, kept instead of summed.

#include "raster/explain.h"
#include "raster/texture.h"

namespace lode::raster::reference {

[[nodiscard]] TextureLookup trace_lookup(const Texture& texture, const Sampler& sampler, const Footprint& footprint);

}  // namespace lode::raster::reference
