#pragma once
/// Pictures from files: PNG and JPEG, told apart by their first bytes. Texels are the file's own numbers, with straight
/// alpha: nothing is premultiplied, no profile and no gamma is applied, no rotation. Grey becomes three equal channels,
/// palettes and 1, 2 and 4 bits become 8, a transparent colour becomes alpha, and 16 bits v become
/// round(v · 255 / 65535).
///
/// Damaged and hostile files are one Error. Only the chunks that hold the picture itself reach a decoder: a picture is
/// taken apart and put together again without comments, profiles, thumbnails and whatever else it carries, and sizes
/// that its data cannot hold are refused before anything is allocated for them.

#include <cstddef>
#include <span>
#include <string>

#include "geometry/material.h"
#include "geometry/memory_budget.h"

namespace lode::geometry {

/// Largest width and height accepted.
inline constexpr int kMaxPictureSize_px = 16384;

/// Throws Error: bad_input naming the file, machine if there is no memory.
[[nodiscard]] Picture read_picture(const std::string& path);

/// A picture of bytes in memory; `name` is what errors call it, and becomes the picture's. Memory is taken from the
/// budget: the texels for good.
[[nodiscard]] Picture decode_picture(std::span<const std::byte> bytes, std::string name, MemoryBudget& budget);

}  // namespace lode::geometry
