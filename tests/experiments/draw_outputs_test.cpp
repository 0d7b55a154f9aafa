/// What `draw` writes: arrays, statistics, hashes, and which outputs go together.

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <cstring>
#include <nlohmann/json.hpp>
#include <span>
#include <string>
#include <vector>

#include "experiments/sample_positions.h"
#include "experiments/sha256.h"
#include "raster/render.h"
#include "tests/experiments/run_program.h"

namespace lode::tests {
namespace {

using testing::HasSubstr;
using testing::IsEmpty;

// Row 0 of 3 x 2 px: a red square point on pixel 1, at depth 0.5; the rest is clear.
const std::string kPoint = R"({"size": [3, 2], "clear": [1, 2, 3, 4],
  "draws": [{"lines": []}, {"points": [[9, 9, 1], [1.5, 0.5, 0.5]], "color": [200, 0, 0, 100]}]})";

template <class T>
std::vector<T> values(const std::string& bytes) {
  std::vector<T> v(bytes.size() / sizeof(T));
  std::memcpy(v.data(), bytes.data(), v.size() * sizeof(T));
  return v;
}

std::string sha256_of(const std::string& text) { return experiments::sha256_hex(std::as_bytes(std::span(text))); }

TEST(DrawOutputs, ArraysHoldThePlanesAsTheyAre) {
  const TemporaryDirectory directory;
  const Outcome run = run_lodestone(
      {"draw", "-", "--out", directory / "c.npy", "--depth", directory / "z.npy", "--ids", directory / "i.npy"},
      kPoint);
  ASSERT_EQ(run.status, 0) << run.err;
  EXPECT_EQ(run.out + run.err, "");

  const NpyArray color = read_npy(directory / "c.npy");
  EXPECT_EQ(color.header, "{'descr': '|u1', 'fortran_order': False, 'shape': (2, 3, 4, ), }");
  using Bytes = std::vector<std::uint8_t>;
  EXPECT_EQ(values<std::uint8_t>(color.bytes),
            (Bytes{1, 2, 3, 4, 200, 0, 0, 100, 1, 2, 3, 4, 1, 2, 3, 4, 1, 2, 3, 4, 1, 2, 3, 4}));

  const NpyArray depth = read_npy(directory / "z.npy");
  EXPECT_EQ(depth.header, "{'descr': '<f4', 'fortran_order': False, 'shape': (2, 3, ), }");
  EXPECT_EQ(values<float>(depth.bytes), (std::vector<float>{0, 0.5f, 0, 0, 0, 0}));

  // Draw 1, its primitive 1.
  const NpyArray ids = read_npy(directory / "i.npy");
  EXPECT_EQ(ids.header, "{'descr': '<u4', 'fortran_order': False, 'shape': (2, 3, 2, ), }");
  constexpr std::uint32_t no = 4294967295u;
  EXPECT_EQ(values<std::uint32_t>(ids.bytes),
            (std::vector<std::uint32_t>{no, no, 1, 1, no, no, no, no, no, no, no, no}));
}

TEST(DrawOutputs, BlendedDrawsPrintButLeaveNoIds) {
  const TemporaryDirectory directory;
  const std::string blended = R"({"size": [2, 1], "draws": [{"points": [[0.5, 0.5, 1]], "blend": "over"}]})";
  const Outcome run = run_lodestone({"draw", "-", "--print", "--ids", directory / "i.npy"}, blended);
  EXPECT_EQ(run.out, "A.\n");
  EXPECT_EQ(read_npy(directory / "i.npy").bytes, std::string(16, '\xFF'));
}

TEST(DrawOutputs, StatisticsCountSamplesAndHashTheArrays) {
  // A triangle of 6 pixels before a quad of 16 (draw_pixels_test.cpp): 10 of the quad's are visible.
  const std::string json = R"({"size": [4, 4], "draws": [
    {"triangles": [[0,0,0.5], [0,4,0.5], [4,0,0.5]]},
    {"quads": [[0,0,0.25], [0,4,0.25], [4,4,0.25], [4,0,0.25]]}]})";
  const TemporaryDirectory directory;
  const Outcome run = run_lodestone({"draw", "-", "--out", directory / "c.npy", "--depth", directory / "z.npy", "--ids",
                                     directory / "i.npy", "--stats", directory / "stats", "--threads", "2"},
                                    json);
  ASSERT_EQ(run.status, 0) << run.err;
  const auto stats = nlohmann::json::parse(file_text(directory / "stats"));
  EXPECT_EQ(stats["picture"], "-");
  EXPECT_EQ(stats["size"], nlohmann::json::parse("[4, 4]"));
  EXPECT_EQ(stats["threads"], 2);
  EXPECT_EQ(stats["target"], raster::name_of(raster::best_target()));
  EXPECT_EQ(stats["pipeline"], "fast");
  EXPECT_EQ(stats["pixel_contract"], 1);
  EXPECT_EQ(stats["draws"], nlohmann::json::parse(R"([{"covered": 6, "visible": 6}, {"covered": 16, "visible": 10}])"));
  EXPECT_EQ(stats["counters"]["draws_in"], 2);
  EXPECT_EQ(stats["counters"]["fragments_covered"], 22);
  EXPECT_EQ(stats["sha256"]["color"], sha256_of(read_npy(directory / "c.npy").bytes));
  EXPECT_EQ(stats["sha256"]["depth"], sha256_of(read_npy(directory / "z.npy").bytes));
  EXPECT_EQ(stats["sha256"]["ids"], sha256_of(read_npy(directory / "i.npy").bytes));
}

TEST(DrawOutputs, HashesAreSha256) {
  // FIPS 180-2, appendix B.1.
  EXPECT_EQ(sha256_of("abc"), "ba7816bf8f01cfea414140de5dae2223b00361a396177a9cb410ff61f20015ad");
}

TEST(DrawOutputs, ThreadsAndOptionsMoveNoBytes) {
  const auto hashes = [](const Arguments& more) {
    Arguments arguments = {"draw", "-", "--stats", "-"};
    arguments.insert(arguments.end(), more.begin(), more.end());
    return nlohmann::json::parse(run_lodestone(arguments, kPoint).out)["sha256"];
  };
  const auto expected = hashes({"--threads", "1"});
  EXPECT_EQ(hashes({"--threads", "5"}), expected);
  EXPECT_EQ(hashes({"--pipeline", "reference"}), expected);
  EXPECT_EQ(hashes({"--target", "scalar", "--skip", "none"}), expected);
}

TEST(DrawOutputs, SamplesAreAveragedAndHaveNoDepthNorIds) {
  // Two samples, (0.25, 0.25) and (0.75, 0.75): the left half of the pixel holds one. (200 + 0) / 2 = 100.
  const std::string json = R"({"size": [1, 1], "samples": 2, "clear": [0, 0, 0, 0], "draws": [
    {"quads": [[0,0,1], [0,1,1], [0.5,1,1], [0.5,0,1]], "color": [200, 100, 50, 20]}]})";
  const TemporaryDirectory directory;
  ASSERT_EQ(run_lodestone({"draw", "-", "--out", directory / "c.npy"}, json).status, 0);
  EXPECT_EQ(values<std::uint8_t>(read_npy(directory / "c.npy").bytes), (std::vector<std::uint8_t>{100, 50, 25, 10}));
  for (const Arguments& extra :
       {Arguments{"--depth", directory / "z.npy"}, {"--ids", directory / "i.npy"}, {"--print"}}) {
    Arguments arguments = {"draw", "-"};
    arguments.insert(arguments.end(), extra.begin(), extra.end());
    EXPECT_EQ(run_lodestone(arguments, json).status, 2);
  }
  const auto stats = nlohmann::json::parse(run_lodestone({"draw", "-", "--stats", "-"}, json).out);
  EXPECT_EQ(stats["sha256"].size(), 1u);
  EXPECT_EQ(stats["draws"][0]["covered"], 1);
}

TEST(DrawOutputs, SamplePositionsFollowTheBitReversal) {
  // n = 4, in 1/256 px: x = 256 (k + ½)/4 = 32, 96, 160, 224; y = 64·{0, 2, 1, 3} + 32.
  using Positions = std::vector<glm::ivec2>;
  EXPECT_EQ(experiments::sample_positions_fx8(4), (Positions{{32, 32}, {96, 160}, {160, 96}, {224, 224}}));
  EXPECT_EQ(experiments::sample_positions_fx8(1), (Positions{{128, 128}}));
  EXPECT_EQ(experiments::sample_positions_fx8(128).back(), glm::ivec2(255, 255));
}

TEST(DrawOutputs, AnEmptyPictureFitsIntoArraysOnly) {
  const std::string empty = R"({"size": [0, 0], "draws": []})";
  const TemporaryDirectory directory;
  ASSERT_EQ(run_lodestone({"draw", "-", "--out", directory / "c.npy", "--print"}, empty).status, 0);
  EXPECT_THAT(read_npy(directory / "c.npy").header, HasSubstr("(0, 0, 4, )"));
  const auto stats = nlohmann::json::parse(run_lodestone({"draw", "-", "--stats", "-"}, empty).out);
  EXPECT_EQ(stats["sha256"]["ids"], sha256_of(""));
  for (const char* name : {"c.png", "c.exr"}) {
    const Outcome run = run_lodestone({"draw", "-", "--out", directory / name}, empty);
    EXPECT_EQ(run.status, 3);
    EXPECT_TRUE(is_one_error_line(run.err)) << run.err;
    EXPECT_THAT(run.err, HasSubstr("an empty picture (0 x 0): expected a .npy file"));
  }
}

TEST(DrawOutputs, TextIsAtMost200ColumnsWide) {
  EXPECT_EQ(run_lodestone({"draw", "-", "--print"}, R"({"size": [200, 1], "draws": []})").out,
            std::string(200, '.') + "\n");
  const Outcome run = run_lodestone({"draw", "-", "--print"}, R"({"size": [201, 1], "draws": []})");
  EXPECT_EQ(run.status, 3);
  EXPECT_EQ(run.err, "lodestone: standard input: size: --print takes at most 200 columns, found 201\n");
}

TEST(DrawOutputs, WhatCannotGoTogetherIsWrongUsage) {
  const TemporaryDirectory directory;
  write_text(directory / "p.json", kPoint);
  const std::string p = directory / "p.json";
  const Arguments wrong[] = {{"--print", "--stats", "-"},
                             {"--out", directory / "a.npy", "--depth", directory / "a.npy"},
                             {"--out", directory / "a.npy", "--ids", directory / "./a.npy"},
                             {"--out", directory / "a.npy", "--out", directory / "b.npy"},
                             {"--stats", p},
                             {"--out", directory / "a.bmp"},
                             {"--out", directory / "png"},
                             {"--depth", directory / "a.png"},
                             {"--ids", directory / "a.png"}};
  for (const Arguments& extra : wrong) {
    Arguments arguments = {"draw", p};
    arguments.insert(arguments.end(), extra.begin(), extra.end());
    const Outcome run = run_lodestone(arguments);
    EXPECT_EQ(run.status, 2) << run.err;
    EXPECT_TRUE(is_one_error_line(run.err)) << run.err;
    EXPECT_EQ(run.out, "");
  }
  EXPECT_THAT(directory.names(), testing::ElementsAre("p.json"));
}

TEST(DrawOutputs, WithoutAnOutputThePictureIsOnlyChecked) {
  const Outcome good = run_lodestone({"draw", "-"}, kPoint);
  EXPECT_EQ(good.status, 0);
  EXPECT_EQ(good.out, "");
  EXPECT_EQ(good.err, "");
  EXPECT_EQ(run_lodestone({"draw", "-"}, R"({"size": [3, 2]})").status, 3);
}

TEST(DrawOutputs, ReadsAFileOrStandardInput) {
  const TemporaryDirectory directory;
  write_text(directory / "p.json", kPoint);
  EXPECT_EQ(run_child({"draw", directory / "p.json", "--print"}).out, ".B.\n...\n");
  EXPECT_EQ(run_child({"draw", "-", "--print"}, kPoint).out, ".B.\n...\n");
  const Outcome none = run_lodestone({"draw", directory / "q.json", "--print"});
  EXPECT_EQ(none.status, 3);
  EXPECT_THAT(none.err, HasSubstr("q.json: cannot be read: No such file or directory"));
  EXPECT_EQ(run_lodestone({"draw", directory / "", "--print"}).status, 3);
}

}  // namespace
}  // namespace lode::tests
