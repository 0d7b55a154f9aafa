#pragma once
/// NumPy's array format, version 1.0: a magic word, a header padded to a multiple of 64 bytes, and the bytes.
/// https://numpy.org/doc/stable/reference/generated/numpy.lib.format.html

#include <cstddef>
#include <initializer_list>
#include <span>
#include <string_view>

#include "geometry/output_file.h"

namespace lode::geometry {

/// Writes an array in C order. `descr` is NumPy's name of the element type ("|u1", "<f4", "<u4"); the shape's
/// product times the element's size is bytes.size(), which is not checked.
void write_npy(OutputFile& file, std::string_view descr, std::initializer_list<int> shape,
               std::span<const std::byte> bytes);

}  // namespace lode::geometry
