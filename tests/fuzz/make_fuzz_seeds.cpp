// Writes the files that fuzzing starts from: make_fuzz_seeds FOLDER fills FOLDER/model_fuzzer and
// FOLDER/picture_fuzzer.
#include <OpenImageIO/imageio.h>

#include <cstdio>
#include <filesystem>
#include <fstream>
#include <string>

#include "tests/geometry/small_models.h"
#include "tests/geometry/temporary_folder.h"

namespace {

namespace fs = std::filesystem;

void write(const fs::path& path, const std::string& bytes) { std::ofstream(path, std::ios::binary) << bytes; }

/// Which file the first byte stands for, see model_fuzzer.cpp.
char format_of(const std::string& name) {
  constexpr const char* kEndings[] = {".gltf", ".glb", ".obj", ".mtl", ".ply", ".stl"};
  char format = 0;
  while (!name.ends_with(kEndings[int(format)])) ++format;
  return format;
}

std::string jpeg(int n_channels) {
  const lode::tests::TemporaryFolder folder;
  const std::string path = folder.path("a.jpg");
  const auto output = OIIO::ImageOutput::create(path);
  std::string pixels;
  for (int i = 0; i < 20 * 18 * n_channels; ++i) pixels += char(i * i / 7);
  const OIIO::ImageSpec spec(20, 18, n_channels, OIIO::TypeDesc::UINT8);
  if (!output->open(path, spec) || !output->write_image(OIIO::TypeDesc::UINT8, pixels.data())) return "";
  output->close();
  std::ifstream file(path, std::ios::binary);
  return {std::istreambuf_iterator<char>(file), {}};
}

}  // namespace

int main(int argc, char** argv) {
  using namespace lode::tests;
  if (argc != 2) {
    std::fprintf(stderr, "usage: make_fuzz_seeds FOLDER\n");
    return 2;
  }
  const fs::path models = fs::path(argv[1]) / "model_fuzzer", pictures = fs::path(argv[1]) / "picture_fuzzer";
  fs::create_directories(models);
  fs::create_directories(pictures);
  int n = 0;
  for (const SmallFiles& files : small_models()) {
    for (const auto& [name, bytes] : files) {
      if (!name.ends_with(".png")) write(models / ("seed" + std::to_string(n++)), format_of(name) + bytes);
    }
  }
  write(pictures / "rgba.png", small_png());
  write(pictures / "interlaced.png", png_bytes({.width = 2,
                                                .height = 2,
                                                .color_type = 0,
                                                .interlace = 1,
                                                .before_data = {},
                                                .rows = {0, 10, 0, 20, 0, 30, 40}}));
  write(pictures / "palette.png", png_bytes({.width = 4,
                                             .bit_depth = 2,
                                             .color_type = 3,
                                             .before_data = png_chunk("PLTE", "\1\2\3\4\5\6") + png_chunk("tRNS", "\7"),
                                             .rows = {0, 0x11}}));
  write(pictures / "sixteen.png",
        png_bytes({.bit_depth = 16, .color_type = 4, .before_data = {}, .rows = {0, 1, 2, 3, 4}}));
  write(pictures / "grey.jpg", jpeg(1));
  write(pictures / "rgb.jpg", jpeg(3));
  return 0;
}
