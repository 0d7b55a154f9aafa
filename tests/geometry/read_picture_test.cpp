/// Pictures are read as their files have them, and damaged or hostile ones are one Error.

#include "geometry/image_file/read_picture.h"

#include <OpenImageIO/imageio.h>
#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <sys/stat.h>

#include <fstream>
#include <functional>
#include <sstream>
#include <string>
#include <vector>

#include "geometry/error.h"
#include "tests/geometry/png_bytes.h"
#include "tests/geometry/temporary_folder.h"

namespace lode::geometry {
namespace {

using testing::ElementsAre;
using testing::EndsWith;
using testing::HasSubstr;
using testing::StartsWith;
using tests::png_bytes;
using tests::png_chunk;
using tests::TemporaryFolder;
using Texels = std::vector<glm::u8vec4>;

Picture decoded(const std::string& bytes) {
  MemoryBudget budget;
  budget.add_file(bytes.size());
  return decode_picture(std::as_bytes(std::span(bytes)), "p", budget);
}

/// The error's text; a test failure if there is none, or if it is more than one line.
std::string error_of(const std::function<void()>& read) {
  try {
    read();
  } catch (const Error& error) {
    const std::string text = error.what();
    EXPECT_EQ(error.kind(), ErrorKind::bad_input) << text;
    EXPECT_EQ(text.find('\n'), std::string::npos) << text;
    return text;
  }
  ADD_FAILURE() << "no error";
  return "";
}
std::string error_of(const std::string& bytes) {
  return error_of([&] { (void)decoded(bytes); });
}

std::string written_jpeg(int w, int h, int n_channels, const std::vector<std::uint8_t>& pixels) {
  const TemporaryFolder folder;
  const std::string path = folder.path("a.jpg");
  const auto output = OIIO::ImageOutput::create(path);
  OIIO::ImageSpec spec(w, h, n_channels, OIIO::TypeDesc::UINT8);
  spec.attribute("Compression", "jpeg:95");
  spec.attribute("ImageDescription", "a comment");
  EXPECT_TRUE(output->open(path, spec) && output->write_image(OIIO::TypeDesc::UINT8, pixels.data()));
  output->close();
  std::ostringstream bytes;
  bytes << std::ifstream(path, std::ios::binary).rdbuf();
  return bytes.str();
}

TEST(ReadPicture, EveryNumberOfChannelsBecomesRgbaAsItIs) {
  // Colour types 0 grey, 4 grey + alpha, 2 RGB, 6 RGBA; alpha 0 and colours above their alpha stay as they are.
  const auto texels = [](char color_type, const std::string& row) {
    return decoded(png_bytes({.width = 2, .color_type = color_type, .before_data = {}, .rows = row})).texels;
  };
  EXPECT_EQ(texels(0, {0, 7, char(200)}), (Texels{{7, 7, 7, 255}, {200, 200, 200, 255}}));
  EXPECT_EQ(texels(4, {0, 7, 0, char(200), 9}), (Texels{{7, 7, 7, 0}, {200, 200, 200, 9}}));
  EXPECT_EQ(texels(2, {0, 1, 2, 3, 4, 5, 6}), (Texels{{1, 2, 3, 255}, {4, 5, 6, 255}}));
  EXPECT_EQ(texels(6, {0, 1, 2, 3, 0, char(255), 5, 6, 4}), (Texels{{1, 2, 3, 0}, {255, 5, 6, 4}}));
}

TEST(ReadPicture, HasAlphaTellsWhetherAnyTexelIsNotOpaque) {
  EXPECT_FALSE(decoded(png_bytes({.color_type = 6, .before_data = {}, .rows = {0, 1, 2, 3, char(255)}})).has_alpha);
  EXPECT_TRUE(decoded(png_bytes({.color_type = 6, .before_data = {}, .rows = {0, 1, 2, 3, char(254)}})).has_alpha);
}

TEST(ReadPicture, SixteenBitsAreRoundedToTheNearest) {
  // round(v / 257): 128 -> 0, 129 -> 1 (128.5 lies between), 0x7FFF = 127.498 · 257 -> 127, 0x8000 -> 128.
  const std::string row = {0, 0, char(128), 0, char(129), 0x7F, char(0xFF), char(0x80), 0, char(0xFF), char(0xFF)};
  const Picture picture =
      decoded(png_bytes({.width = 5, .bit_depth = 16, .color_type = 0, .before_data = {}, .rows = row}));
  std::vector<int> grey;
  for (const auto& t : picture.texels) grey.push_back(t.r);
  EXPECT_THAT(grey, ElementsAre(0, 1, 127, 128, 255));
}

TEST(ReadPicture, PalettesAndTransparentColoursBecomeRgba) {
  // Two bits a pixel: indices 0, 1, 2, 1 = 0b00011001.
  const std::string palette = png_chunk("PLTE", "\1\2\3\4\5\6\7\x8\x9") + png_chunk("tRNS", std::string{0, char(128)});
  const Picture picture =
      decoded(png_bytes({.width = 4, .bit_depth = 2, .color_type = 3, .before_data = palette, .rows = {0, 0x19}}));
  EXPECT_EQ(picture.texels, (Texels{{1, 2, 3, 0}, {4, 5, 6, 128}, {7, 8, 9, 255}, {4, 5, 6, 128}}));
}

TEST(ReadPicture, InterlacedRowsComeInTheirOrder) {
  // Adam7 of 2 x 2: pass 1 has (0, 0), pass 6 has (1, 0), pass 7 has row 1; the other passes are empty.
  const Picture picture = decoded(png_bytes({.width = 2,
                                             .height = 2,
                                             .color_type = 0,
                                             .interlace = 1,
                                             .before_data = {},
                                             .rows = {0, 10, 0, 20, 0, 30, 40}}));
  EXPECT_EQ(picture.texels, (Texels{{10, 10, 10, 255}, {20, 20, 20, 255}, {30, 30, 30, 255}, {40, 40, 40, 255}}));
}

TEST(ReadPicture, GammaProfilesAndCommentsChangeNothing) {
  // A gamma of 1, a profile that is no profile, and text: none of it reaches the decoder.
  const std::string rows = {0, 50, 100, char(150)};
  const std::string chunks =
      png_chunk("gAMA", tests::big_endian(100000)) + png_chunk("iCCP", "not a profile") + png_chunk("tEXt", "hello");
  EXPECT_EQ(decoded(png_bytes({.color_type = 2, .before_data = chunks, .rows = rows})).texels,
            (Texels{{50, 100, 150, 255}}));
}

TEST(ReadPicture, JpegEqualsWhatOpenImageIOReads) {
  for (const int n_channels : {1, 3}) {
    std::vector<std::uint8_t> pixels;
    for (int i = 0; i < 70 * 65 * n_channels; ++i) pixels.push_back(std::uint8_t(i * i / 50));
    const std::string bytes = written_jpeg(70, 65, n_channels, pixels);
    const Picture picture = decoded(bytes);
    EXPECT_EQ(picture.size_px, glm::ivec2(70, 65));
    EXPECT_FALSE(picture.has_alpha);

    const TemporaryFolder folder;
    const auto input = OIIO::ImageInput::open(folder.write("a.jpg", bytes));
    ASSERT_TRUE(input && input->read_image(0, 0, 0, n_channels, OIIO::TypeDesc::UINT8, pixels.data()));
    for (std::size_t i = 0; i < picture.texels.size(); ++i) {
      const std::uint8_t* const c = &pixels[i * std::size_t(n_channels)];
      ASSERT_EQ(picture.texels[i], glm::u8vec4(c[0], c[n_channels == 3 ? 1 : 0], c[n_channels == 3 ? 2 : 0], 255)) << i;
    }
  }
}

TEST(ReadPicture, JpegOfOneGreyIsThatGrey) {
  // A constant block has no AC coefficients, and its DC, 8 · (grey − 128), is a multiple of any fine quantizer's step
  // for grey = 128: every texel is exact.
  const Picture picture = decoded(written_jpeg(16, 8, 1, std::vector<std::uint8_t>(128, 128)));
  EXPECT_EQ(picture.texels, Texels(128, {128, 128, 128, 255}));
}

TEST(ReadPicture, ClaimsThatTheDataCannotHoldAreRefused) {
  // One row of one pixel; the header says more.
  const auto claim = [](std::uint32_t w, std::uint32_t h) {
    return error_of(png_bytes({.width = w, .height = h, .before_data = {}, .rows = {0, 1, 2, 3, 4}}));
  };
  EXPECT_EQ(claim(32768, 32768), "p: 32768 x 32768 px: expected 1 to 16384 a side");
  EXPECT_EQ(claim(4294967295u, 4294967295u), "p: 4294967295 x 4294967295 px: expected 1 to 16384 a side");
  EXPECT_EQ(claim(0, 4), "p: 0 x 4 px: expected 1 to 16384 a side");
  EXPECT_EQ(claim(16384, 16384), "p: claims 16384 x 16384 px: its 16 bytes of data cannot hold them");

  std::string jpeg = written_jpeg(8, 8, 1, std::vector<std::uint8_t>(64, 128));
  const std::size_t frame = jpeg.find("\xFF\xC0");
  ASSERT_NE(frame, std::string::npos);
  jpeg.replace(frame + 5, 4, "\x3F\xFF\x3F\xFF");  // height, width
  EXPECT_THAT(error_of(jpeg), HasSubstr("p: claims 16383 x 16383 px: its "));
  jpeg.replace(frame + 5, 4, "\xFF\xFF\xFF\xFF");
  EXPECT_EQ(error_of(jpeg), "p: 65535 x 65535 px: expected 1 to 16384 a side");
}

TEST(ReadPicture, WhatIsCutOffAnywhereIsAnError) {
  std::vector<std::uint8_t> pixels(33 * 17);
  for (std::size_t i = 0; i < pixels.size(); ++i) pixels[i] = std::uint8_t(i * i);
  const std::string jpeg = written_jpeg(33, 17, 1, pixels);
  const std::string png = png_bytes({.width = 2, .color_type = 0, .before_data = {}, .rows = {0, 7, 8}});
  for (const std::string& whole : {jpeg, png}) {
    for (std::size_t n = 0; n < whole.size(); ++n) EXPECT_THAT(error_of(whole.substr(0, n)), StartsWith("p: "));
  }
}

TEST(ReadPicture, DamagedDataIsAnErrorInTheDecodersWords) {
  std::string png = png_bytes({.width = 2, .color_type = 0, .before_data = {}, .rows = {0, 7, 8}});
  png[png.find("IDAT") + 8] ^= 1;
  testing::internal::CaptureStderr();
  EXPECT_THAT(error_of(png), StartsWith("p: a damaged PNG picture: IDAT: "));
  EXPECT_EQ(testing::internal::GetCapturedStderr(), "");

  std::string jpeg = written_jpeg(64, 64, 1, std::vector<std::uint8_t>(64 * 64, 77));
  jpeg.erase(jpeg.size() - 8, 6);  // what remains is too short for the blocks that the frame promises
  EXPECT_THAT(error_of(jpeg), StartsWith("p: a damaged JPEG picture: Corrupt JPEG data"));
}

TEST(ReadPicture, FilesThatCannotBeReadAreNamed) {
  const TemporaryFolder folder;
  const auto error = [&](const std::string& path) {
    const std::string text = error_of([&] { (void)read_picture(path); });
    EXPECT_THAT(text, StartsWith(path + ": "));
    return text.substr(path.size() + 2);
  };
  EXPECT_EQ(error(folder.path("none.png")), "cannot be read: No such file or directory");
  EXPECT_EQ(error(folder.path()), "is a directory: expected a file");
  EXPECT_EQ(error(folder.write("empty.png", "")), "is empty");
  EXPECT_EQ(error(folder.write("text.png", "hello")), "expected a PNG or JPEG picture");
  ASSERT_EQ(::mkfifo(folder.path("pipe.png").c_str(), 0600), 0);
  EXPECT_EQ(error(folder.path("pipe.png")), "is a device or pipe: expected a file");
  if (::geteuid() != 0) {  // root may read everything
    const std::string path = folder.write("secret.png", "x");
    ::chmod(path.c_str(), 0);
    EXPECT_EQ(error(path), "cannot be read: Permission denied");
  }
}

TEST(ReadPicture, ItsNameIsItsPath) {
  const TemporaryFolder folder;
  const std::string path = folder.write("a.png", png_bytes({.before_data = {}, .rows = {0, 1, 2, 3, 4}}));
  EXPECT_EQ(read_picture(path).name, path);
}

}  // namespace
}  // namespace lode::geometry
