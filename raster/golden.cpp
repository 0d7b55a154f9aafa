#include "raster/golden.h"

#include <cstdio>
#include <filesystem>
#include <fstream>
#include <sstream>

#include "raster/error.h"

namespace lode::raster {

namespace {

constexpr int kMostPixelsListed = 10;

void check_has_rgba8(const Image& image) {
  const std::size_t n_px = std::size_t(image.size_px.x) * std::size_t(image.size_px.y);
  if (image.format != ColorFormat::rgba8 || image.rgba8.size() != n_px) {
    throw Error(ErrorKind::bad_input, "golden: expected an rgba8 image with a colour plane of %zu pixels, found %zu",
                n_px, image.rgba8.size());
  }
}

std::string text(glm::u8vec4 c) {
  char buffer[32];
  std::snprintf(buffer, sizeof buffer, "(%d, %d, %d, %d)", c.r, c.g, c.b, c.a);
  return buffer;
}

/// Why the two pictures are not the same; empty if they are.
std::string difference(const Image& actual, const Image& expected) {
  std::ostringstream out;
  if (actual.size_px != expected.size_px) {
    out << "expected " << expected.size_px.x << " x " << expected.size_px.y << " pixels, drawn " << actual.size_px.x
        << " x " << actual.size_px.y << "\n";
    return out.str();
  }
  std::size_t n_different = 0;
  for (std::size_t i = 0; i < actual.rgba8.size(); ++i) {
    if (actual.rgba8[i] == expected.rgba8[i]) continue;
    if (++n_different > kMostPixelsListed) continue;
    const std::size_t width = std::size_t(actual.size_px.x);
    out << "  pixel (" << i % width << ", " << i / width << "): expected " << text(expected.rgba8[i]) << ", drawn "
        << text(actual.rgba8[i]) << "\n";
  }
  if (n_different == 0) return {};
  return std::to_string(n_different) + " of " + std::to_string(actual.rgba8.size()) + " pixels differ; the first:\n" +
         out.str();
}

}  // namespace

void write_pam(const Image& image, const std::string& path) {
  check_has_rgba8(image);
  std::ofstream file(path, std::ios::binary);
  file << "P7\nWIDTH " << image.size_px.x << "\nHEIGHT " << image.size_px.y
       << "\nDEPTH 4\nMAXVAL 255\nTUPLTYPE RGB_ALPHA\nENDHDR\n";
  file.write(reinterpret_cast<const char*>(image.rgba8.data()),
             static_cast<std::streamsize>(image.rgba8.size() * sizeof(glm::u8vec4)));
  if (!file.flush()) throw Error(ErrorKind::bad_input, "%s: cannot be written", path.c_str());
}

Image read_pam(const std::string& path) {
  std::ifstream file(path, std::ios::binary);
  if (!file) throw Error(ErrorKind::bad_input, "%s: there is no such file", path.c_str());

  std::string line;
  glm::ivec2 size_px{-1, -1};
  int n_channels = 0;
  int maximum = 0;
  if (!std::getline(file, line) || line != "P7")
    throw Error(ErrorKind::bad_input, "%s: expected a PAM file", path.c_str());
  while (std::getline(file, line) && line != "ENDHDR") {
    std::istringstream words(line);
    std::string key;
    words >> key;
    if (key == "WIDTH") words >> size_px.x;
    if (key == "HEIGHT") words >> size_px.y;
    if (key == "DEPTH") words >> n_channels;
    if (key == "MAXVAL") words >> maximum;
  }
  if (n_channels != 4 || maximum != 255) {
    throw Error(ErrorKind::bad_input, "%s: expected 4 channels of maximum 255, found %d of %d", path.c_str(),
                n_channels, maximum);
  }
  // What the header claims is believed only as far as the file reaches.
  const auto here = file.tellg();
  const auto left = file.seekg(0, std::ios::end).tellg() - here;
  file.seekg(here);
  if (size_px.x > 0 && size_px.y > 0 && left / 4 / size_px.x < size_px.y) {
    throw Error(ErrorKind::bad_input, "%s: expected %d x %d pixels of 4 bytes, found %lld bytes", path.c_str(),
                size_px.x, size_px.y, static_cast<long long>(left));
  }
  Image image = make_image(size_px, ColorFormat::rgba8, {.color = true, .depth = false, .ids = false});
  const auto n_bytes = static_cast<std::streamsize>(image.rgba8.size() * sizeof(glm::u8vec4));
  if (n_bytes > 0 && !file.read(reinterpret_cast<char*>(image.rgba8.data()), n_bytes)) {
    throw Error(ErrorKind::bad_input, "%s: cannot be read", path.c_str());
  }
  return image;
}

std::string compare_golden(const Image& image, const std::string& path) {
  check_has_rgba8(image);
  std::string report;
  try {
    report = difference(image, read_pam(path));
    if (report.empty()) return {};
    report = path + ": " + report;
  } catch (const Error& error) {
    if (error.kind() != ErrorKind::bad_input) throw;
    report = std::string(error.what()) + "\n";
  }
  const std::string actual_path = std::filesystem::path(path).stem().string() + ".actual.pam";
  try {
    write_pam(image, actual_path);
  } catch (const Error& error) {  // the difference is what counts
    return report + "the picture drawn could not be kept: " + error.what() + "\n";
  }
  return report + "drawn: " + std::filesystem::absolute(actual_path).string() + "\nif that is right: cp '" +
         std::filesystem::absolute(actual_path).string() + "' '" + path + "'\n";
}

}  // namespace lode::raster
