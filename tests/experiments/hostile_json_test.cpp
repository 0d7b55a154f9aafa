/// Whatever the JSON holds, `draw` ends with 0 or 3, and says at most one line.

#include <gtest/gtest.h>

#include <nlohmann/json.hpp>
#include <string>

#include "tests/experiments/run_program.h"

namespace lode::tests {
namespace {

using nlohmann::json;

/// Every key there is.
const char* const kEverything = R"({
 "size": [8, 8], "unit": "1/256", "clear": [0, 0, 0, 255], "samples": 1,
 "clip_from_world": [1,0,0,0, 0,1,0,0, 0,0,1,0, 0,0,0,1], "scissor": [0, 0, 8, 8],
 "draws": [
  {"triangles": [[0,0,0.5], [0,1024,0.5], [1024,0,0.25]], "color": [255,0,0,128], "cull": "none", "blend": "over",
   "colors": [[255,0,0,255], [0,255,0,255], [0,0,255,255]], "depth_test": true, "depth_write": false},
  {"lines": [[0,0,0.5], [2048,2048,0.5]], "stipple": {"pattern": 13107, "factor": 1}},
  {"points": [[1152,1152,0.5]], "point_size": 768},
  {"discs": [{"center": [1152,1152,0.5], "radius": 256, "color": [1,2,3,4]}]},
  {"clip": [[-1,-1,0.5,1], [3,-1,0.5,1], [-1,3,0.5,1]], "uv": [[0,0],[2,0],[0,2]], "scissor": [1, 1, 3, 3],
   "texture": {"size": [2,1], "rgba": [255,0,0,255, 0,255,0,255], "filter": "anisotropic", "wrap": "mirror",
               "wrap_u": "clamp", "wrap_v": "border", "max_anisotropy": 8, "mips": true, "border": [1,2,3,4]},
   "alpha_test": 0.5},
  {"surfels": [{"center": [0,0,0.5], "normal": [0,0,1], "radius": 0.5}]}]})";

/// Draws it and checks the claim. What it was made from is printed only when it fails.
void expect_done_or_bad_input(const std::string& text, const std::string& what) {
  const Outcome run = run_lodestone({"draw", "-", "--stats", "-", "--threads", "1"}, text);
  EXPECT_TRUE(run.status == 0 || run.status == 3) << what << ": status " << run.status << ": " << run.err;
  if (run.status == 0) {
    EXPECT_EQ(run.err, "") << what;
  } else {
    EXPECT_TRUE(is_one_error_line(run.err)) << what << ": " << run.err;
    EXPECT_LT(run.err.size(), 600u) << what;
    EXPECT_EQ(run.out, "") << what;
  }
}

TEST(HostileJson, TheSampleItselfIsFine) {
  EXPECT_EQ(run_lodestone({"draw", "-", "--stats", "-"}, kEverything).status, 0);
}

TEST(HostileJson, AnythingInAnyPlace) {
  const json sample = json::parse(kEverything);
  const json flat = sample.flatten();
  std::vector<json::json_pointer> places = {json::json_pointer("")};
  // Every scalar, and every container on the way to it.
  for (const auto& [pointer, value] : flat.items()) {
    for (json::json_pointer place(pointer); !place.empty(); place = place.parent_pointer()) {
      if (std::find(places.begin(), places.end(), place) == places.end()) places.push_back(place);
    }
  }
  EXPECT_GT(places.size(), 150u);
  for (const json::json_pointer& place : places) {
    for (const char* replacement :
         {"null", "true", "\"x\"", "-1", "0", "1e308", "-1e308", "1e-320", "0.3", "[]", "{}"}) {
      json hostile = sample;
      hostile[place] = json::parse(replacement);
      expect_done_or_bad_input(hostile.dump(), place.to_string() + " = " + replacement);
    }
  }
}

TEST(HostileJson, ATruncatedPictureIsBadInputAtEveryByte) {
  const std::string text = json::parse(kEverything).dump();
  for (std::size_t n = 0; n < text.size(); ++n) {
    const Outcome run = run_lodestone({"draw", "-", "--stats", "-"}, text.substr(0, n));
    EXPECT_EQ(run.status, 3) << n;
    EXPECT_TRUE(is_one_error_line(run.err)) << n << ": " << run.err;
  }
}

TEST(HostileJson, AnyByteAnywhere) {
  const std::string text = json::parse(kEverything).dump();
  for (std::size_t i = 0; i < text.size(); ++i) {
    for (const char byte : {'\0', '\n', '"', '-', '9', '[', '}', '\xFF'}) {
      std::string hostile = text;
      hostile[i] = byte;
      expect_done_or_bad_input(hostile, "byte " + std::to_string(i) + " = " + std::to_string(int(byte)));
    }
  }
}

TEST(HostileJson, DeepNestingIsRefusedNotFollowed) {
  const std::string deep(100000, '[');
  const Outcome run = run_lodestone({"draw", "-", "--stats", "-"}, deep);
  EXPECT_EQ(run.status, 3);
  EXPECT_TRUE(is_one_error_line(run.err));
  expect_done_or_bad_input(R"({"size": )" + deep + std::string(100000, ']') + "}", "deep arrays");
  // The object is one level; 31 arrays in it are 32.
  const auto error_of = [](int n) {
    const std::string arrays = std::string(std::size_t(n), '[') + std::string(std::size_t(n), ']');
    return run_lodestone({"draw", "-", "--stats", "-"}, R"({"size": )" + arrays + "}").err;
  };
  EXPECT_EQ(error_of(31).find("nested deeper"), std::string::npos);
  EXPECT_NE(error_of(32).find("nested deeper than 32 levels"), std::string::npos);
  std::string objects;
  for (int i = 0; i < 100000; ++i) objects += R"({"draws":)";
  expect_done_or_bad_input(objects, "deep objects");
}

TEST(HostileJson, HugeNumbersAndStringsFitIntoOneLine) {
  expect_done_or_bad_input(R"({"size": [)" + std::string(100000, '9') + ", 1]}", "100,000 digits");
  expect_done_or_bad_input(R"({"size": [1, 1], "draws": [], ")" + std::string(100000, 'k') + R"(": 1})", "long key");
  expect_done_or_bad_input(R"({"size": [1, 1], "unit": ")" + std::string(100000, 'u') + R"(", "draws": []})",
                           "long word");
  expect_done_or_bad_input("{\"size\": [1, 1], \"a\\nb\\u0000\": []}", "control characters in a key");
}

TEST(HostileJson, AMillionElementsAreNoTrouble) {
  std::string zeros = "0";
  for (int i = 1; i < 1000000; ++i) zeros += ",0";
  expect_done_or_bad_input(R"({"size": [)" + zeros + R"(], "draws": []})", "a size of a million");
  expect_done_or_bad_input(
      R"({"size": [1, 1], "draws": [{"points": [], "texture": {"size": [500, 500], "rgba": [)" + zeros + "]}}]}",
      "a texture of a million bytes");
  std::string vertices = "[1,1,0]";
  for (int i = 1; i < 99999; ++i) vertices += ",[1,1,0]";
  EXPECT_EQ(
      run_lodestone({"draw", "-", "--stats", "-"}, R"({"size": [2, 2], "draws": [{"triangles": [)" + vertices + "]}]}")
          .status,
      0);
}

}  // namespace
}  // namespace lode::tests
