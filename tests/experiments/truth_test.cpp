/// What `truth` prints and writes, and which options go together.

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <nlohmann/json.hpp>

#include "tests/experiments/run_program.h"

namespace lode::tests {
namespace {

using testing::HasSubstr;
using testing::IsEmpty;

Outcome truth(const Arguments& arguments) {
  Arguments all = {"truth"};
  all.insert(all.end(), arguments.begin(), arguments.end());
  return run_lodestone(all);
}

void expect_wrong_usage(const Arguments& arguments, const std::string& message) {
  const Outcome run = truth(arguments);
  EXPECT_EQ(run.status, 2) << message;
  EXPECT_TRUE(is_one_error_line(run.err)) << run.err;
  EXPECT_THAT(run.err, HasSubstr(message));
  EXPECT_EQ(run.out, "");
}

TEST(Truth, CheckPrintsHowEveryPixelIsExplained) {
  const Outcome run = truth({"spheres:side=3,segments=16", "--check", "--size", "64x48"});
  EXPECT_EQ(run.status, 0) << run.err;
  EXPECT_THAT(run.err, IsEmpty());
  const nlohmann::json json = nlohmann::json::parse(run.out);
  EXPECT_EQ(json["pixels"], 64 * 48);
  EXPECT_EQ(json["unexplained"], 0);
  const nlohmann::json& explained = json["explained"];
  EXPECT_EQ(json["different"], explained["edge"].get<int>() + explained["depth_tie"].get<int>() +
                                   explained["range"].get<int>() + explained["embree"].get<int>());
  EXPECT_GT(json["visible_edge_px"], 64.0);
  EXPECT_TRUE(json["edge_bound_holds"]);
}

TEST(Truth, ScenesOfAnySizeAreTracedInASpaceOfSizeOne) {
  // Squares of 1e30 and of 1e-30 are beyond floats; no pixel may be lost to that.
  const TemporaryDirectory directory;
  for (const char* size : {"1e30", "1e-30"}) {
    const std::string s(size);
    write_text(directory / "a.obj", "v " + s + " 0 0\nv 0 " + s + " 0\nv 0 0 " + s + "\nf 1 2 3\n");
    const Outcome run = truth({directory / "a.obj", "--check", "--size", "48x48"});
    EXPECT_EQ(run.status, 0) << run.err;
    EXPECT_LE(nlohmann::json::parse(run.out)["different"], 2) << size;
  }
}

TEST(Truth, CheckOfEitherPipelineSaysTheSame) {
  const auto check = [](const Arguments& more) {
    Arguments arguments = {"spheres:side=2,segments=8", "--check", "--size", "48x36"};
    arguments.insert(arguments.end(), more.begin(), more.end());
    const Outcome run = truth(arguments);
    EXPECT_EQ(run.status, 0) << run.err;
    return run.out;
  };
  const std::string expected = check({"--pipeline", "reference"});
  EXPECT_EQ(check({}), expected);
  EXPECT_EQ(check({"--target", "scalar", "--skip", "none"}), expected);
}

TEST(Truth, CheckLeavesOutWhatBlends) {
  const Outcome run = truth({"alpha", "--check", "--size", "64x48"});
  EXPECT_EQ(run.status, 0) << run.err;
  const nlohmann::json left_out = nlohmann::json::parse(run.out)["left_out"];
  EXPECT_EQ(left_out["blended"], 1);
  EXPECT_EQ(left_out["lines"], 0);
  EXPECT_EQ(left_out["points"], 0);
}

TEST(Truth, TourChecksEightCamerasAndSumsThemUp) {
  const Outcome run = truth({"torus:segments=16,sides=8", "--tour", "--size", "48x48"});
  EXPECT_EQ(run.status, 0) << run.err;
  const nlohmann::json json = nlohmann::json::parse(run.out);
  ASSERT_EQ(json["cameras"].size(), 8u);
  EXPECT_EQ(json["pixels"], 8 * 48 * 48);
  int n_different = 0;
  for (const nlohmann::json& camera : json["cameras"]) n_different += camera["different"].get<int>();
  EXPECT_EQ(json["different"], n_different);
  EXPECT_EQ(json["cameras"][6]["camera"], "far_away");
}

/// Each stop of the tour can be gone to alone.
TEST(Truth, ToursOptionsGiveTheSameView) {
  const Arguments scene = {"torus:segments=16,sides=8", "--size", "48x48"};
  Arguments tour = scene;
  tour.push_back("--tour");
  const nlohmann::json toured = nlohmann::json::parse(truth(tour).out);
  for (const nlohmann::json& stop : toured["cameras"]) {
    Arguments alone = scene;
    alone.push_back("--check");
    std::istringstream words(stop["options"].get<std::string>());
    for (std::string word; words >> word;) alone.push_back(word);
    const nlohmann::json json = nlohmann::json::parse(truth(alone).out);
    EXPECT_EQ(json["explained"], stop["explained"]);
    EXPECT_EQ(json["visible_edge_px"], stop["visible_edge_px"]);
  }
}

TEST(Truth, WritesThePlanesOfARenderedPicture) {
  const TemporaryDirectory directory;
  const Outcome run = truth({"alpha", "--size", "32x24", "--out", directory / "t.png", "--depth", directory / "t.npy",
                             "--ids", directory / "t.exr", "--stats", "-"});
  EXPECT_EQ(run.status, 0) << run.err;
  for (const char* name : {"t.png", "t.npy", "t.exr"}) EXPECT_FALSE(file_text(directory / name).empty()) << name;
  const nlohmann::json json = nlohmann::json::parse(run.out);
  EXPECT_EQ(json["sha256"].size(), 3u);
}

TEST(Truth, MapShowsTheVerdicts) {
  const TemporaryDirectory directory;
  const Outcome run = truth({"torus", "--check", "--size", "32x24", "--map", directory / "map.npy"});
  EXPECT_EQ(run.status, 0) << run.err;
  EXPECT_EQ(file_text(directory / "map.npy").size(), 128u + 32u * 24u * 4u);
}

TEST(Truth, RefusesOptionsThatDoNotGoTogether) {
  expect_wrong_usage({"torus", "--check", "--samples", "4"}, "--samples 4");
  expect_wrong_usage({"torus", "--samples", "4", "--ids", "ids.npy"}, "--samples 4");
  expect_wrong_usage({"torus", "--check", "--stats", "-"}, "--stats -");
  expect_wrong_usage({"torus", "--map", "map.png"}, "--check");
  expect_wrong_usage({"torus", "--check", "--map", "map.txt"}, "map.txt");
  expect_wrong_usage({"torus", "--check", "--map", "a.png", "--out", "a.png"}, "named twice");
  expect_wrong_usage({"torus", "--tour", "--eye", "1,2,3", "--look-at", "0,0,0"}, "--tour");
  expect_wrong_usage({"torus", "--tour", "--out", "a.png"}, "--tour");
}

}  // namespace
}  // namespace lode::tests
