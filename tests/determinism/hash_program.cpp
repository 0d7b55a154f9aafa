// Draws the set of pictures and prints one line a plane: name, plane, FNV-1a 64 of its bytes. The determinism test
// runs it in every build and on every machine, in every way to draw, and compares the lines.
//
//   hash_program [--pipelines reference,fast] [--targets all|NAME,...] [--threads N,N,...] [--tiles N,N,...]
//                [--only NAME] [--expect FILE] [--keep DIR | --against DIR]
//     --pipelines, --targets, --threads, --tiles
//                 every way to draw that they make: tiles are of the reference pipeline, targets of the fast one (all:
//                 each that can run here). The first one's hashes are printed, and what differs from it is an error.
//                 How many there were goes to standard error.
//     --expect    the lines must be those of the file; the ones that are not are listed
//     --keep      also writes every plane to DIR/NAME.PLANE
//     --against   compares with planes so kept and lists the first ten pixels that differ in each
#include <algorithm>
#include <bit>
#include <cstdio>
#include <filesystem>
#include <fstream>
#include <iterator>
#include <map>
#include <sstream>
#include <stdexcept>

#include "pictures.h"
#include "planes.h"

namespace {

using namespace lode::raster;
using namespace lode::pictures;

std::vector<std::string> words(const std::string& list) {
  std::vector<std::string> values;
  std::stringstream stream(list);
  for (std::string word; std::getline(stream, word, ',');) values.push_back(word);
  return values;
}

std::vector<int> numbers(const std::string& list) {
  std::vector<int> values;
  for (const std::string& word : words(list)) values.push_back(std::stoi(word));
  return values;
}

struct Options {
  std::vector<std::string> pipelines{"reference", "fast"};
  std::string targets = "all";
  std::vector<int> threads{1};
  std::vector<int> tiles{64};
  std::string only, expect, keep, against;
};

/// One way to draw a picture.
struct Way {
  std::string name;
  RenderOptions options;
};

std::vector<Target> targets_of(const std::string& list) {
  constexpr Target kAll[] = {Target::scalar, Target::sse4, Target::avx2, Target::avx512, Target::neon, Target::wasm};
  std::vector<Target> targets;
  if (list == "all") {
    std::copy_if(std::begin(kAll), std::end(kAll), std::back_inserter(targets), can_run);
    return targets;
  }
  for (const std::string& word : words(list)) {
    const auto found = std::find_if(std::begin(kAll), std::end(kAll), [&](Target t) { return name_of(t) == word; });
    if (found == std::end(kAll) || !can_run(*found)) throw std::runtime_error("target " + word + " cannot run here");
    targets.push_back(*found);
  }
  return targets;
}

/// The fast pipeline's frames share their memory, so that one picture's contents are in the way of the next.
std::vector<Way> ways_of(const Options& options, FrameMemory& memory) {
  std::vector<Way> ways;
  for (const std::string& pipeline : options.pipelines) {
    if (pipeline == "reference") {
      for (const int threads : options.threads) {
        for (const int tile : options.tiles) {
          ways.push_back({"reference, " + std::to_string(threads) + " threads, tile " + std::to_string(tile),
                          {.threads = threads, .tile_size_px = tile, .pipeline = Pipeline::reference}});
        }
      }
    } else if (pipeline == "fast") {
      for (const Target target : targets_of(options.targets)) {
        for (const int threads : options.threads) {
          ways.push_back({std::string("fast ") + name_of(target) + ", " + std::to_string(threads) + " threads",
                          {.threads = threads, .target = target, .memory = &memory}});
        }
      }
    } else {
      throw std::runtime_error("pipeline " + pipeline + ": expected reference or fast");
    }
  }
  if (ways.empty()) throw std::runtime_error("nothing to draw with");
  return ways;
}

/// "reference 21, fast scalar 7, ...": ways by what comes before the first comma.
std::string counts_of(const std::vector<Way>& ways) {
  std::vector<std::pair<std::string, int>> counts;
  for (const Way& way : ways) {
    const std::string kind = way.name.substr(0, way.name.find(','));
    if (counts.empty() || counts.back().first != kind) counts.emplace_back(kind, 0);
    ++counts.back().second;
  }
  std::string text;
  for (const auto& [kind, n] : counts) text += (text.empty() ? "" : ", ") + kind + " " + std::to_string(n);
  return text;
}

/// The lines of a file of hashes.
std::vector<std::string> lines_of(const std::string& path) {
  std::ifstream file(path);
  std::vector<std::string> lines;
  for (std::string line; std::getline(file, line);) lines.push_back(line);
  return lines;
}

/// Draws one picture in every way and adds its lines; returns how many planes differ from what they should be.
int hash_picture(const Picture& picture, const std::vector<Way>& ways, const Options& options,
                 std::vector<std::string>& lines) {
  std::vector<Plane> first;
  int n_wrong = 0;
  for (const Way& way : ways) {
    Image image = picture.image();
    render(picture.frame(), image, way.options);
    const std::vector<Plane> planes = planes_of(image);
    if (first.empty()) first = planes;
    for (std::size_t i = 0; i < planes.size(); ++i) {
      if (check_plane(picture.name, planes[i], first[i].bytes)) continue;
      std::printf("  with %s; expected as with %s\n", way.name.c_str(), ways[0].name.c_str());
      ++n_wrong;
    }
  }
  for (const Plane& plane : first) {
    lines.push_back(picture.name + " " + plane.name + " " + hash_of(plane));
    std::printf("%s\n", lines.back().c_str());
    const std::string file_name = picture.name + "." + plane.name;
    if (!options.keep.empty()) {
      std::ofstream(std::filesystem::path(options.keep) / file_name, std::ios::binary)
          .write(reinterpret_cast<const char*>(plane.bytes.data()), static_cast<std::streamsize>(plane.bytes.size()));
    }
    if (!options.against.empty()) {
      std::ifstream file(std::filesystem::path(options.against) / file_name, std::ios::binary);
      const std::vector<unsigned char> expected{std::istreambuf_iterator<char>(file), std::istreambuf_iterator<char>()};
      if (!check_plane(picture.name, plane, expected)) ++n_wrong;
    }
  }
  return n_wrong;
}

/// Lists the lines that are not those expected; returns how many.
int check_lines(const std::vector<std::string>& lines, const std::vector<std::string>& expected) {
  int n_wrong = 0;
  for (std::size_t i = 0; i < std::max(lines.size(), expected.size()); ++i) {
    const std::string drawn = i < lines.size() ? lines[i] : "nothing";
    const std::string right = i < expected.size() ? expected[i] : "nothing";
    if (drawn == right) continue;
    std::printf("expected %s, drawn %s\n", right.c_str(), drawn.c_str());
    ++n_wrong;
  }
  return n_wrong;
}

int run(const Options& options) {
  FrameMemory memory;
  const std::vector<Way> ways = ways_of(options, memory);
  int n_wrong = 0;
  std::vector<std::string> lines;
  for (const Picture& picture : all_pictures()) {
    if (options.only.empty() || options.only == picture.name) n_wrong += hash_picture(picture, ways, options, lines);
  }
  if (!options.expect.empty()) n_wrong += check_lines(lines, lines_of(options.expect));
  std::fprintf(stderr, "%zu planes x %zu: %s\n", lines.size(), ways.size(), counts_of(ways).c_str());
  return n_wrong == 0 ? 0 : 1;
}

}  // namespace

int main(int n_arguments, char** arguments) {
  static_assert(std::endian::native == std::endian::little, "the hashes are of little-endian bytes");
  Options options;
  const std::map<std::string, std::string*> texts = {{"--targets", &options.targets},
                                                     {"--only", &options.only},
                                                     {"--expect", &options.expect},
                                                     {"--keep", &options.keep},
                                                     {"--against", &options.against}};
  try {
    for (int i = 1; i < n_arguments; i += 2) {
      const std::string name = arguments[i], value = i + 1 < n_arguments ? arguments[i + 1] : "";
      if (texts.contains(name))
        *texts.at(name) = value;
      else if (name == "--pipelines")
        options.pipelines = words(value);
      else if (name == "--threads")
        options.threads = numbers(value);
      else if (name == "--tiles")
        options.tiles = numbers(value);
      else
        throw std::runtime_error("unknown option " + name);
    }
    return run(options);
  } catch (const std::exception& error) {
    std::fprintf(stderr, "hash_program: %s\n", error.what());
    return 2;
  }
}
