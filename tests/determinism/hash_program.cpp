// Draws the set of pictures and prints one line a plane: name, plane, FNV-1a 64 of its bytes. The determinism test
// runs it in every build, with several numbers of threads and tile sizes, and compares the lines.
//
//   hash_program [--threads N,N,...] [--tiles N,N,...] [--only NAME] [--expect FILE] [--keep DIR | --against DIR]
//     --threads, --tiles   every combination is drawn; the first is printed, and one that differs from it is an error
//     --expect             the lines must be those of the file; the ones that are not are listed
//     --keep               also writes every plane to DIR/NAME.PLANE
//     --against            compares with planes so kept and lists the first ten pixels that differ in each
#include <algorithm>
#include <bit>
#include <cstdio>
#include <cstring>
#include <filesystem>
#include <fstream>
#include <iterator>
#include <span>
#include <sstream>

#include "pictures.h"
#include "raster/srgb.h"

namespace {

using namespace lode::raster;
using lode::pictures::Picture;

struct Plane {
  std::string name;
  std::size_t bytes_per_pixel;
  int width_px;
  std::vector<unsigned char> bytes;
};

template <class T>
Plane plane_of(const char* name, const Image& image, const std::vector<T>& pixels) {
  Plane plane{name, sizeof(T), image.size_px.x, std::vector<unsigned char>(pixels.size() * sizeof(T))};
  if (!pixels.empty()) std::memcpy(plane.bytes.data(), pixels.data(), plane.bytes.size());
  return plane;
}

std::vector<Plane> planes_of(const Image& image) {
  std::vector<Plane> planes;
  if (image.format == ColorFormat::rgba8) {
    planes.push_back(plane_of("color", image, image.rgba8));
  } else {
    planes.push_back(plane_of("color", image, image.rgba32f));
    std::vector<glm::u8vec4> encoded;
    for (const glm::vec4& c : image.rgba32f) encoded.push_back(srgb8_from_linear(c));
    planes.push_back(plane_of("srgb", image, encoded));
  }
  if (!image.depth.empty()) planes.push_back(plane_of("depth", image, image.depth));
  if (!image.ids.empty()) planes.push_back(plane_of("ids", image, image.ids));
  return planes;
}

std::uint64_t fnv1a64(const std::vector<unsigned char>& bytes) {
  std::uint64_t hash = 0xCBF29CE484222325u;
  for (const unsigned char byte : bytes) hash = (hash ^ byte) * 0x100000001B3u;
  return hash;
}

std::string hex(const unsigned char* bytes, std::size_t n) {
  std::string text;
  char digits[4];
  for (std::size_t i = 0; i < n; ++i) {
    std::snprintf(digits, sizeof digits, "%02x", bytes[i]);
    text += digits;
  }
  return text;
}

/// Lists where two planes of the same picture differ; true if they do not.
bool same(const std::string& picture, const Plane& plane, const std::vector<unsigned char>& expected) {
  if (plane.bytes == expected) return true;
  std::printf("%s %s: ", picture.c_str(), plane.name.c_str());
  if (plane.bytes.size() != expected.size()) {
    std::printf("%zu bytes, expected %zu\n", plane.bytes.size(), expected.size());
    return false;
  }
  const std::size_t each = plane.bytes_per_pixel;
  std::size_t n_different = 0;
  std::string list;
  for (std::size_t at = 0; at < plane.bytes.size(); at += each) {
    if (std::memcmp(&plane.bytes[at], &expected[at], each) == 0 || ++n_different > 10) continue;
    const std::size_t pixel = at / each, width = std::size_t(plane.width_px);
    list += "  (" + std::to_string(pixel % width) + ", " + std::to_string(pixel / width) + "): " + hex(&plane.bytes[at], each) +
            ", expected " + hex(&expected[at], each) + "\n";
  }
  std::printf("%zu of %zu pixels differ; bytes of the first:\n%s", n_different, plane.bytes.size() / each, list.c_str());
  return false;
}

std::vector<int> numbers(const std::string& list) {
  std::vector<int> values;
  std::stringstream stream(list);
  for (std::string word; std::getline(stream, word, ',');) values.push_back(std::stoi(word));
  return values;
}

struct Options {
  std::vector<int> threads{1};
  std::vector<int> tiles{64};
  std::string only, expect, keep, against;
};

/// The lines of a file of hashes.
std::vector<std::string> lines_of(const std::string& path) {
  std::ifstream file(path);
  std::vector<std::string> lines;
  for (std::string line; std::getline(file, line);) lines.push_back(line);
  return lines;
}

/// Draws one picture in every combination and adds its lines; returns how many planes differ from what they should be.
int hash_picture(const Picture& picture, const Options& options, std::vector<std::string>& lines) {
  std::vector<Plane> first;
  int n_wrong = 0;
  for (const int threads : options.threads) {
    for (const int tile : options.tiles) {
      Image image = picture.image();
      RenderOptions render_options;
      render_options.threads = threads;
      render_options.tile_size_px = tile;
      render(picture.frame(), image, render_options);
      const std::vector<Plane> planes = planes_of(image);
      if (first.empty()) first = planes;
      for (std::size_t i = 0; i < planes.size(); ++i) {
        if (same(picture.name, planes[i], first[i].bytes)) continue;
        std::printf("  with %d threads, tile %d; expected as with %d threads, tile %d\n", threads, tile,
                    options.threads[0], options.tiles[0]);
        ++n_wrong;
      }
    }
  }
  for (const Plane& plane : first) {
    char hash[24];
    std::snprintf(hash, sizeof hash, "%016llx", static_cast<unsigned long long>(fnv1a64(plane.bytes)));
    lines.push_back(picture.name + " " + plane.name + " " + hash);
    std::printf("%s\n", lines.back().c_str());
    const std::string file_name = picture.name + "." + plane.name;
    if (!options.keep.empty()) {
      std::ofstream(std::filesystem::path(options.keep) / file_name, std::ios::binary)
          .write(reinterpret_cast<const char*>(plane.bytes.data()), static_cast<std::streamsize>(plane.bytes.size()));
    }
    if (!options.against.empty()) {
      std::ifstream file(std::filesystem::path(options.against) / file_name, std::ios::binary);
      const std::vector<unsigned char> expected{std::istreambuf_iterator<char>(file), std::istreambuf_iterator<char>()};
      if (!same(picture.name, plane, expected)) ++n_wrong;
    }
  }
  return n_wrong;
}

}  // namespace

int main(int n_arguments, char** arguments) {
  static_assert(std::endian::native == std::endian::little, "the hashes are of little-endian bytes");
  Options options;
  for (int i = 1; i < n_arguments; i += 2) {
    const std::string name = arguments[i], value = i + 1 < n_arguments ? arguments[i + 1] : "";
    if (name == "--threads") options.threads = numbers(value);
    else if (name == "--tiles") options.tiles = numbers(value);
    else if (name == "--only") options.only = value;
    else if (name == "--expect") options.expect = value;
    else if (name == "--keep") options.keep = value;
    else if (name == "--against") options.against = value;
    else return std::fprintf(stderr, "hash_program: unknown option %s\n", name.c_str()), 2;
  }
  int n_wrong = 0;
  std::vector<std::string> lines;
  for (const Picture& picture : lode::pictures::all_pictures()) {
    if (options.only.empty() || options.only == picture.name) n_wrong += hash_picture(picture, options, lines);
  }
  if (!options.expect.empty()) {
    const std::vector<std::string> expected = lines_of(options.expect);
    for (std::size_t i = 0; i < std::max(lines.size(), expected.size()); ++i) {
      const std::string drawn = i < lines.size() ? lines[i] : "nothing", right = i < expected.size() ? expected[i] : "nothing";
      if (drawn == right) continue;
      std::printf("expected %s, drawn %s\n", right.c_str(), drawn.c_str());
      ++n_wrong;
    }
  }
  return n_wrong == 0 ? 0 : 1;
}
