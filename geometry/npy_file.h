#pragma once
/// NumPy's array format, version 1.0: a magic word, a header padded to a multiple of 64 bytes, and the bytes.
/// https://numpy.org/doc/stable/reference/generated/numpy.lib.format.html

#include <cstddef>
#include <initializer_list>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "geometry/input_file.h"
#include "geometry/output_file.h"

namespace lode::geometry {

/// Writes an array in C order. `descr` is NumPy's name of the element type ("|u1", "<f4", "<u4"); the shape's
/// product times the element's size is bytes.size(), which is not checked.
void write_npy(OutputFile& file, std::string_view descr, std::initializer_list<int> shape,
               std::span<const std::byte> bytes);

/// An array as a file has it.
struct NpyArray {
  std::string descr;               ///< "|u1", "<f4", "<u4"
  std::vector<std::size_t> shape;  ///< C order
  FileBytes file;
  std::span<const std::byte> bytes;  ///< of the elements, inside the file's
};

/// Reads a version 1 file with elements of one of the three types above. Throws Error (bad_input, machine).
[[nodiscard]] NpyArray read_npy(const std::string& path);

}  // namespace lode::geometry
