#pragma once
/// Pixel-exact picture tests for any test framework: one committed reference file, no tolerance.
///
///   const std::string difference = compare_golden(image, "golden/cube.pam");
///   EXPECT_EQ(difference, "");
///
/// The file is a binary PAM (netpbm; ImageMagick, GIMP and ffmpeg open it), 8-bit RGBA, straight as the plane has it.

#include <string>

#include "raster/image.h"

namespace lode::raster {

/// Compares the colour plane with the picture in the file.
///   image     rgba8, with a colour plane; else Error bad_input is thrown
///   returns   empty if every byte is the same; else a report of several lines: the reason or the number of differing
///             pixels, the first ten of them with both values, and where the picture drawn has been written:
///             <file name without its ending>.actual.pam in the working directory. If that picture is right, copy it over the reference.
///   A reference that is missing, not readable or of another size is a difference.
[[nodiscard]] std::string compare_golden(const Image& image, const std::string& path);

/// Writes the colour plane as a PAM file. Throws Error bad_input if it cannot be written.
void write_pam(const Image& image, const std::string& path);

/// Reads a PAM file as write_pam makes it: 4 channels, maximum 255. Throws Error bad_input.
[[nodiscard]] Image read_pam(const std::string& path);

}  // namespace lode::raster
