#include "raster/golden.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <filesystem>
#include <fstream>

#include "raster/error.h"

namespace lode::raster {
namespace {

using ::testing::HasSubstr;
using ::testing::Not;

Image colors(glm::ivec2 size_px) {
  Image image = make_image(size_px, ColorFormat::rgba8, {.color = true, .depth = false, .ids = false});
  for (std::size_t i = 0; i < image.rgba8.size(); ++i) {
    image.rgba8[i] = {std::uint8_t(i * 7), std::uint8_t(10), std::uint8_t(13), std::uint8_t(255 - i)};  // 10, 13: line ends
  }
  return image;
}

/// A folder of the test's own, which is the working directory while it lives.
class Golden : public ::testing::Test {
 protected:
  void SetUp() override {
    const ::testing::TestInfo& test = *::testing::UnitTest::GetInstance()->current_test_info();
    folder_ = std::filesystem::path(::testing::TempDir()) / (std::string("lodestone_golden_") + test.name());
    std::filesystem::remove_all(folder_);
    std::filesystem::create_directories(folder_);
    before_ = std::filesystem::current_path();
    std::filesystem::current_path(folder_);
  }
  void TearDown() override {
    std::filesystem::current_path(before_);
    std::filesystem::remove_all(folder_);
  }

 private:
  std::filesystem::path folder_, before_;
};

TEST_F(Golden, AWrittenPictureReadsBackAndComparesEqual) {
  for (const glm::ivec2 size_px : {glm::ivec2{5, 3}, glm::ivec2{1, 1}, glm::ivec2{0, 0}, glm::ivec2{16, 16}}) {
    const Image image = colors(size_px);
    write_pam(image, "a.pam");
    const Image back = read_pam("a.pam");
    EXPECT_EQ(back.size_px, size_px);
    EXPECT_EQ(back.rgba8, image.rgba8);
    EXPECT_EQ(compare_golden(image, "a.pam"), "");
  }
  EXPECT_FALSE(std::filesystem::exists("a.actual.pam"));
}

TEST_F(Golden, AMissingReferenceIsADifferenceAndThePictureIsKept) {
  const Image image = colors({4, 2});
  EXPECT_THAT(compare_golden(image, "folder/none.pam"), HasSubstr("folder/none.pam: there is no such file"));
  EXPECT_EQ(read_pam("none.actual.pam").rgba8, image.rgba8);
}

TEST_F(Golden, OneBitOfAlphaIsADifferenceAtItsPixel) {
  Image image = colors({5, 3});
  write_pam(image, "a.pam");
  image.rgba8[2 * 5 + 4].a ^= 1;  // pixel 14: alpha 255 − 14 = 241, drawn 240; red 14·7 = 98
  const std::string report = compare_golden(image, "a.pam");
  EXPECT_THAT(report, HasSubstr("1 of 15 pixels differ"));
  EXPECT_THAT(report, HasSubstr("pixel (4, 2): expected (98, 10, 13, 241), drawn (98, 10, 13, 240)"));
}

TEST_F(Golden, TheFirstTenDifferencesAreListed) {
  Image image = colors({5, 3});
  write_pam(image, "a.pam");
  for (glm::u8vec4& pixel : image.rgba8) pixel.g = 0;
  const std::string report = compare_golden(image, "a.pam");
  EXPECT_THAT(report, HasSubstr("15 of 15 pixels differ"));
  EXPECT_THAT(report, HasSubstr("pixel (4, 1)"));      // the tenth
  EXPECT_THAT(report, Not(HasSubstr("pixel (0, 2)")));  // the eleventh
}

TEST_F(Golden, AnotherSizeIsADifference) {
  write_pam(colors({3, 5}), "a.pam");
  EXPECT_THAT(compare_golden(colors({5, 3}), "a.pam"), HasSubstr("expected 3 x 5 pixels, drawn 5 x 3"));
}

TEST_F(Golden, ADamagedReferenceIsADifference) {
  const Image image = colors({5, 3});
  write_pam(image, "short.pam");
  std::filesystem::resize_file("short.pam", std::filesystem::file_size("short.pam") - 1);
  EXPECT_THAT(compare_golden(image, "short.pam"), HasSubstr("expected 5 x 3 pixels of 4 bytes, found 59 bytes"));
  std::ofstream("other.pam") << "P6\n5 3\n255\n";
  EXPECT_THAT(compare_golden(image, "other.pam"), HasSubstr("expected a PAM file"));
  std::ofstream("huge.pam") << "P7\nWIDTH 32768\nHEIGHT 32768\nDEPTH 4\nMAXVAL 255\nENDHDR\n";  // 4 GiB, it says
  EXPECT_THAT(compare_golden(image, "huge.pam"), HasSubstr("expected 32768 x 32768 pixels of 4 bytes, found 0 bytes"));
  std::ofstream("negative.pam") << "P7\nWIDTH -5\nHEIGHT 3\nDEPTH 4\nMAXVAL 255\nENDHDR\n";
  EXPECT_THAT(compare_golden(image, "negative.pam"), HasSubstr("image size -5 x 3"));
}

TEST_F(Golden, AFloatImageIsTheCallersMistake) {
  const Image image = make_image({2, 2}, ColorFormat::rgba32f);
  EXPECT_THROW((void)compare_golden(image, "a.pam"), Error);
}

}  // namespace
}  // namespace lode::raster
