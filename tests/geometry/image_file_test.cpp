/// Image files hold what they were given: read back by OpenImageIO itself.

#include "geometry/image_file.h"

#include <OpenImageIO/imageio.h>
#include <gtest/gtest.h>

#include <cstdio>
#include <filesystem>
#include <fstream>
#include <sstream>
#include <string>
#include <vector>

#include "geometry/error.h"

namespace lode::geometry {
namespace {

/// A path of this process in the temporary directory, removed at the end.
struct TemporaryPath {
  explicit TemporaryPath(const std::string& name)
      : path((std::filesystem::temp_directory_path() / ("lodestone-" + std::to_string(::getpid()) + name)).string()) {}
  ~TemporaryPath() { std::remove(path.c_str()); }
  std::string path;
};

OutputFile open_output(const std::string& path) { return {std::fopen(path.c_str(), "wb"), path}; }

std::string bytes_of(const std::string& path) {
  std::ostringstream text;
  text << std::ifstream(path, std::ios::binary).rdbuf();
  return text.str();
}

/// Pixels of a file in its own number format, without any conversion.
template <class T>
std::vector<T> read_back(const std::string& path, OIIO::TypeDesc type, std::vector<std::string> channels) {
  OIIO::ImageSpec as_stored;
  as_stored.attribute("oiio:UnassociatedAlpha", 1);
  const auto input = OIIO::ImageInput::open(path, &as_stored);
  if (!input) return {};
  const OIIO::ImageSpec& spec = input->spec();
  EXPECT_EQ(spec.format, type);
  EXPECT_EQ(spec.channelnames, channels);
  std::vector<T> pixels(std::size_t(spec.width) * std::size_t(spec.height) * std::size_t(spec.nchannels));
  EXPECT_TRUE(input->read_image(0, 0, 0, spec.nchannels, type, pixels.data()));
  return pixels;
}

TEST(ImageFile, FormatsGoByTheEnding) {
  EXPECT_EQ(image_format("a/b.png"), ImageFormat::png);
  EXPECT_EQ(image_format("B.EXR"), ImageFormat::exr);
  EXPECT_EQ(image_format("x.y.npy"), ImageFormat::npy);
  for (const char* path : {"", "png", ".png", "dir/.png", "a.pngx", "a.jpg", "a.png/"})
    EXPECT_FALSE(image_format(path)) << path;
}

TEST(ImageFile, PngKeepsEveryByteAsGiven) {
  // Colours brighter than their alpha, alpha 0 with colour: a premultiplying writer would change them.
  std::vector<glm::u8vec4> colors;
  for (int i = 0; i < 100 * 3; ++i) colors.emplace_back(i, 255 - i / 2, 7 * i, i % 5 == 0 ? 0 : i);
  const TemporaryPath file("a.png");
  OutputFile output = open_output(file.path);
  write_color(output, ImageFormat::png, {3, 100}, colors);
  output.close();
  const auto pixels = read_back<std::uint8_t>(file.path, OIIO::TypeDesc::UINT8, {"R", "G", "B", "A"});
  ASSERT_EQ(pixels.size(), 4 * colors.size());
  for (std::size_t i = 0; i < pixels.size(); ++i) ASSERT_EQ(pixels[i], colors[i / 4][int(i % 4)]) << i;
}

TEST(ImageFile, ExrHoldsBytesAsFractionsOf255) {
  std::vector<glm::u8vec4> colors;
  for (int i = 0; i < 256; ++i) colors.emplace_back(i, i, i, 255 - i);
  const TemporaryPath file("b.exr");
  OutputFile output = open_output(file.path);
  write_color(output, ImageFormat::exr, {2, 128}, colors);
  output.close();
  const auto pixels = read_back<float>(file.path, OIIO::TypeDesc::FLOAT, {"R", "G", "B", "A"});
  ASSERT_EQ(pixels.size(), 1024u);
  for (int i = 0; i < 256; ++i) {
    EXPECT_EQ(pixels[4 * std::size_t(i)], float(i) / 255.0f);
    EXPECT_EQ(pixels[4 * std::size_t(i) + 3], float(255 - i) / 255.0f);
  }
}

TEST(ImageFile, ExrHoldsDepthAndIdsExactly) {
  const std::vector<float> depths = {0.0f, 1.0f, 0.1f, 1e-30f, 0.5f, 0.99999994f};
  const std::vector<std::uint32_t> ids = {0, 1, 4294967295u, 4294967294u, 16777217, 3};
  const TemporaryPath depth_file("c.exr"), ids_file("d.exr");
  OutputFile depth_output = open_output(depth_file.path), ids_output = open_output(ids_file.path);
  write_depth(depth_output, ImageFormat::exr, {3, 2}, depths);
  write_ids(ids_output, ImageFormat::exr, {1, 3}, ids);
  depth_output.close();
  ids_output.close();
  EXPECT_EQ(read_back<float>(depth_file.path, OIIO::TypeDesc::FLOAT, {"Z"}), depths);
  EXPECT_EQ(read_back<std::uint32_t>(ids_file.path, OIIO::TypeDesc::UINT32, {"draw", "primitive"}), ids);
}

TEST(ImageFile, FloatColoursKeepTheirBits) {
  const std::vector<glm::vec4> colors = {{0.25f, -1.0f, 1e10f, 0.5f}, {3.0f, 1e-30f, 0.0f, 1.0f}};
  const TemporaryPath exr("e.exr"), npy("e.npy");
  OutputFile exr_output = open_output(exr.path), npy_output = open_output(npy.path);
  write_color(exr_output, ImageFormat::exr, {2, 1}, colors);
  write_color(npy_output, ImageFormat::npy, {2, 1}, colors);
  exr_output.close();
  npy_output.close();
  EXPECT_EQ(read_back<float>(exr.path, OIIO::TypeDesc::FLOAT, {"R", "G", "B", "A"}),
            (std::vector<float>{0.25f, -1.0f, 1e10f, 0.5f, 3.0f, 1e-30f, 0.0f, 1.0f}));
  EXPECT_EQ(bytes_of(npy.path).substr(128), std::string(reinterpret_cast<const char*>(colors.data()), 32));
  OutputFile png_output = open_output(npy.path);
  EXPECT_THROW(write_color(png_output, ImageFormat::png, {2, 1}, colors), Error);
}

TEST(ImageFile, FilesDependOnThePictureAlone) {
  const std::vector<glm::u8vec4> colors(6, glm::u8vec4(1, 2, 3, 4));
  for (const ImageFormat format : {ImageFormat::png, ImageFormat::exr}) {
    const TemporaryPath file("f");
    OutputFile output = open_output(file.path);
    write_color(output, format, {3, 2}, colors);
    output.close();
    // A date would be the only text that begins with the century.
    EXPECT_EQ(bytes_of(file.path).find("20"), std::string::npos);
    EXPECT_EQ(bytes_of(file.path).find("tIME"), std::string::npos);
  }
}

TEST(ImageFile, AFullDiskIsReportedByItsName) {
  for (const ImageFormat format : {ImageFormat::png, ImageFormat::exr, ImageFormat::npy}) {
    OutputFile full(std::fopen("/dev/full", "wb"), "full.image");
    const std::vector<glm::u8vec4> colors(1, glm::u8vec4(0));
    try {
      write_color(full, format, {1, 1}, colors);
      full.close();
      ADD_FAILURE() << "no error";
    } catch (const Error& error) {
      EXPECT_EQ(error.kind(), ErrorKind::machine);
      EXPECT_STREQ(error.what(), "full.image: cannot be written: No space left on device");
    }
  }
}

}  // namespace
}  // namespace lode::geometry
