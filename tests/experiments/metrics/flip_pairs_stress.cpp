/// FLIP of the pairs of pictures in the folder that LODESTONE_ASSETS names, against the means and the maps of errors
/// that NVIDIA's FLIP 1.6 gave.

#include <gtest/gtest.h>

#include <cmath>
#include <cstdlib>
#include <cstring>
#include <fstream>
#include <iomanip>
#include <iostream>
#include <sstream>
#include <string>

#include "experiments/metrics/flip/flip.h"
#include "experiments/metrics/magma.h"
#include "geometry/image_file/read_picture.h"

namespace lode::experiments {
namespace {

/// The program computes in single precision: this much is its own noise. A pixel where the pictures are equal has up to
/// 1.1e-4 there: 2e-4 of noise in L*a*b*, of a hundred, to the power of 0.7.
constexpr double kMeanTolerance = 2e-5, kPixelTolerance = 1.2e-4;

/// One row of EXPECTED.tsv.
struct Expected {
  std::string reference, test;
  double mean = 0.0;
  [[nodiscard]] static std::string stem(const std::string& path) {
    return path.substr(path.find('/') + 1, path.rfind('.') - path.find('/') - 1);
  }
  [[nodiscard]] std::string map_name(const std::string& between) const {
    return stem(reference) + between + stem(test);
  }
};

std::vector<Expected> read_expected(const std::string& path) {
  std::ifstream file(path);
  std::vector<Expected> rows;
  std::string line, skip;
  std::getline(file, line);  // titles
  while (std::getline(file, line)) {
    Expected row;
    std::istringstream words(line);
    words >> row.reference >> row.test;
    for (int i = 0; i < 8; ++i) words >> skip;  // size … max
    words >> row.mean;
    rows.push_back(row);
  }
  return rows;
}

/// The largest difference of any pixel from the file's float; infinity if the file is no such map.
double farthest_pixel(const ErrorMap& map, const std::string& path) {
  std::ifstream file(path, std::ios::binary);
  const std::string bytes{std::istreambuf_iterator<char>(file), {}};
  if (bytes.size() != map.errors.size() * sizeof(float)) return HUGE_VAL;
  std::vector<float> expected(map.errors.size());
  std::memcpy(expected.data(), bytes.data(), bytes.size());
  double farthest = 0.0;
  for (std::size_t i = 0; i < expected.size(); ++i) {
    farthest = std::fmax(farthest, std::fabs(double{expected[i]} - double{map.errors[i]}));
  }
  return farthest;
}

/// Pixels whose colour is not the picture's or, the error being on the border of two of the map's colours, a
/// neighbour's.
int wrong_colors(const ErrorMap& map, const std::string& path) {
  const geometry::Picture picture = geometry::read_picture(path);
  EXPECT_EQ(picture.size_px, map.size_px) << path;
  int wrong = 0;
  for (std::size_t i = 0; i < map.errors.size(); ++i) {
    const auto is = [&](float error) { return glm::u8vec3(picture.texels[i]) == glm::u8vec3(magma(error)); };
    const float e = map.errors[i], d = float(kPixelTolerance);
    wrong += !is(e) && !is(e - d) && !is(e + d);
  }
  return wrong;
}

TEST(FlipPairs, HaveTheirPublishedMeansAndMaps) {
  const char* const assets = std::getenv("LODESTONE_ASSETS");
  if (assets == nullptr) GTEST_SKIP() << "LODESTONE_ASSETS names no folder";
  const std::string folder = std::string(assets) + "/flip/";
  const std::vector<Expected> rows = read_expected(folder + "EXPECTED.tsv");
  ASSERT_FALSE(rows.empty()) << folder;
  std::cout << std::setprecision(9);
  for (const Expected& row : rows) {
    const geometry::Picture a = geometry::read_picture(folder + row.reference);
    const geometry::Picture b = geometry::read_picture(folder + row.test);
    const ErrorMap map = flip_map({a.size_px, a.texels, b.texels}, {.threads = 0});
    const double mean = mean_error(map.errors);
    const double farthest = farthest_pixel(map, folder + "expected-float/" + row.map_name(".vs.") + ".f32");
    std::cout << Expected::stem(row.reference) << ": published " << row.mean << ", ours " << mean
              << "; the pixel that differs most by " << farthest << "\n";
    EXPECT_NEAR(mean, row.mean, kMeanTolerance) << row.reference;
    EXPECT_LE(farthest, kPixelTolerance) << row.reference;
    EXPECT_EQ(wrong_colors(map, folder + "expected-maps/flip." + row.map_name(".") + ".67ppd.ldr.png"), 0);
  }
}

}  // namespace
}  // namespace lode::experiments
