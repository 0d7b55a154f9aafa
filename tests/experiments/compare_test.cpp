/// `compare`: what it reads, prints and decides.

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <nlohmann/json.hpp>

#include "tests/experiments/run_program.h"

namespace lode::tests {
namespace {

using testing::HasSubstr;
using testing::IsEmpty;

/// Two pictures of 12 x 11 px: grey, and the same with a white triangle in it.
class Compare : public testing::Test {
 protected:
  Compare() {
    draw("a", "");
    draw("b", R"({"triangles": [[2, 2, 0.5], [2, 8, 0.5], [8, 2, 0.5]]})");
  }
  void draw(const std::string& name, const std::string& draws) {
    const std::string json = R"({"size": [12, 11], "clear": [100, 100, 100, 255], "draws": [)" + draws + "]}";
    const Outcome run = run_lodestone(
        {"draw", "-", "--out", path(name + ".png"), "--depth", path(name + "_z.npy"), "--ids", path(name + "_i.npy")},
        json);
    EXPECT_EQ(run.status, 0) << run.err;
    EXPECT_EQ(run_lodestone({"draw", "-", "--out", path(name + ".npy")}, json).status, 0);
  }
  std::string path(const std::string& name) const { return directory_ / name; }
  Outcome compare(const std::string& a, const std::string& b, const Arguments& more = {}) const {
    Arguments arguments = {"compare", path(a), path(b)};
    arguments.insert(arguments.end(), more.begin(), more.end());
    return run_lodestone(arguments);
  }
  nlohmann::json metrics(const std::string& a, const std::string& b, const Arguments& more = {}) const {
    const Outcome run = compare(a, b, more);
    EXPECT_EQ(run.status, 0) << run.err;
    return nlohmann::json::parse(run.out);
  }
  TemporaryDirectory directory_;
};

TEST_F(Compare, PrintsTheMetricsOfTwoPictures) {
  // The triangle has 5 + 4 + 3 + 2 + 1 = 15 samples left of its diagonal, and the 6 on it belong to a neighbour.
  const auto m = metrics("a.png", "b.png");
  EXPECT_EQ(m["max"], 155);
  EXPECT_EQ(m["differing"], 15);
  EXPECT_DOUBLE_EQ(m["rmse"], std::sqrt(15.0 * 155 * 155 / (12 * 11)));
  EXPECT_NEAR(m["psnr"], 20.0 * std::log10(255.0 / m["rmse"].get<double>()), 1e-12);
  EXPECT_LT(m["ssim"], 1.0);
  EXPECT_TRUE(m["ms-ssim"].is_null());
  EXPECT_GT(m["flip"], 15.0 / 132.0);  // the eye's blur carries a difference beyond its pixels
  EXPECT_LT(m["flip"], 1.0);
  EXPECT_EQ(m.size(), 7u);
}

TEST_F(Compare, ArraysAndFilesOfOnePictureAreEqual) {
  const auto m = metrics("b.png", "b.npy");
  EXPECT_EQ(m["max"], 0);
  EXPECT_EQ(m["rmse"], 0.0);
  EXPECT_TRUE(m["psnr"].is_null());
  EXPECT_EQ(m["ssim"], 1.0);
}

TEST_F(Compare, OnlyTheMetricsAskedForArePrinted) {
  EXPECT_EQ(compare("a.png", "b.png", {"--metrics", "max,differing"}).out, "{\"max\":155,\"differing\":15}\n");
  EXPECT_EQ(compare("a.png", "b.png", {"--metrics", "differing,max"}).out, "{\"max\":155,\"differing\":15}\n");
}

TEST_F(Compare, DepthAndIdsHaveTheirOwn) {
  EXPECT_EQ(compare("a_z.npy", "b_z.npy").out, "{\"max\":0.5,\"differing\":15}\n");
  EXPECT_EQ(compare("a_i.npy", "b_i.npy").out, "{\"differing\":15}\n");
  const Outcome run = compare("a_i.npy", "b_i.npy", {"--metrics", "psnr"});
  EXPECT_EQ(run.status, 3);
  EXPECT_THAT(run.err, HasSubstr("ids has no psnr"));
}

TEST_F(Compare, ConditionsThatHoldFailTheComparison) {
  EXPECT_EQ(compare("a.png", "b.png", {"--fail-if", "max>154"}).status, 1);
  EXPECT_EQ(compare("a.png", "b.png", {"--fail-if", "max>155"}).status, 0);
  EXPECT_EQ(compare("a.png", "b.png", {"--fail-if", "max>155", "--fail-if", "ssim<1"}).status, 1);
  EXPECT_EQ(compare("a.png", "b.png", {"--metrics", "max", "--fail-if", "differing<16"}).status, 1);
  EXPECT_EQ(compare("a.png", "a.npy", {"--fail-if", "psnr<99"}).status, 0);  // equal: above every limit
  EXPECT_EQ(compare("a.png", "a.npy", {"--fail-if", "psnr>99"}).status, 1);
  EXPECT_EQ(compare("a.png", "b.png", {"--fail-if", "ms-ssim<0.5"}).status, 3);
}

TEST_F(Compare, TheMapIsBlackWhereThePicturesAreEqual) {
  // Differing pixels are 64 + 155 · 191 / 255 = 180.
  ASSERT_EQ(compare("a.png", "b.png", {"--map", path("map.png")}).status, 0);
  draw("black", "");
  const std::string json = R"({"size": [12, 11], "clear": [0, 0, 0, 255], "draws": [
      {"triangles": [[2, 2, 0.5], [2, 8, 0.5], [8, 2, 0.5]], "color": [180, 180, 180, 255]}]})";
  ASSERT_EQ(run_lodestone({"draw", "-", "--out", path("expected.png")}, json).status, 0);
  EXPECT_EQ(metrics("map.png", "expected.png")["max"], 0);
}

TEST_F(Compare, TheMapOfFlipAloneIsItsErrorsInMagma) {
  // Magma begins with (0, 0, 4): equal pictures are all of it. The eye's blur shows the triangle beyond its 15 pixels.
  ASSERT_EQ(compare("a.png", "b.png", {"--metrics", "flip", "--map", path("map.png")}).status, 0);
  const std::string json = R"({"size": [12, 11], "clear": [0, 0, 4, 255], "draws": []})";
  ASSERT_EQ(run_lodestone({"draw", "-", "--out", path("nothing.png")}, json).status, 0);
  ASSERT_EQ(compare("a.png", "a.npy", {"--metrics", "flip", "--map", path("none.png")}).status, 0);
  EXPECT_EQ(metrics("none.png", "nothing.png")["max"], 0);
  EXPECT_GT(metrics("map.png", "nothing.png")["differing"], 15);
  // With another metric beside it, the map shows differences by channel.
  ASSERT_EQ(compare("a.png", "a.npy", {"--metrics", "flip,max", "--map", path("black.png")}).status, 0);
  EXPECT_EQ(metrics("black.png", "nothing.png")["max"], 4);
}

TEST_F(Compare, HdrFlipIsOfLinearArraysAndOnlyByName) {
  for (const char* clear : {"0.2,0.4,0.6,1", "0.2,0.4,0.5,1"}) {
    const std::string out = path(clear[10] == '6' ? "p.npy" : "q.npy");
    ASSERT_EQ(run_lodestone({"render", "cube", "--size", "12x11", "--clear", clear, "--out", out}).status, 0);
  }
  EXPECT_FALSE(metrics("p.npy", "q.npy").contains("hdr-flip"));
  EXPECT_GT(metrics("p.npy", "q.npy", {"--metrics", "hdr-flip", "--map", path("map.png")})["hdr-flip"], 0.0);
  EXPECT_EQ(compare("p.npy", "p.npy", {"--metrics", "hdr-flip"}).out, "{\"hdr-flip\":0.0}\n");
  EXPECT_EQ(compare("p.npy", "q.npy", {"--fail-if", "hdr-flip>0"}).status, 1);
  const Outcome run = compare("p.npy", "a.png", {"--metrics", "hdr-flip"});
  EXPECT_EQ(run.status, 3);
  EXPECT_THAT(run.err, HasSubstr("a.png: colour of 8 bits has no hdr-flip"));
}

TEST_F(Compare, HdrFlipOfColorsThatAreNotFiniteIsNullAndHasNoMap) {
  const Arguments render = {"render", "cube", "--size", "12x11", "--clear", "0.2,0.4,0.6,1", "--out", path("p.npy")};
  ASSERT_EQ(run_lodestone(render).status, 0);
  std::string bytes = file_text(path("p.npy"));
  bytes.replace(bytes.size() - 16, 4, std::string("\0\0\x80\x7f", 4));  // the last pixel's red: infinity
  write_text(path("q.npy"), bytes);
  EXPECT_EQ(compare("p.npy", "q.npy", {"--metrics", "hdr-flip"}).out, "{\"hdr-flip\":null}\n");
  for (const Arguments& more : {Arguments{"--map", path("map.png")}, Arguments{"--fail-if", "hdr-flip>0"}}) {
    Arguments arguments = {"--metrics", "hdr-flip"};
    arguments.insert(arguments.end(), more.begin(), more.end());
    const Outcome run = compare("p.npy", "q.npy", arguments);
    EXPECT_EQ(run.status, 3);
    EXPECT_TRUE(is_one_error_line(run.err)) << run.err;
    EXPECT_THAT(run.err, HasSubstr("finite"));
  }
}

TEST_F(Compare, LinearPicturesAreComparedAsTheyWouldBeStored) {
  const Arguments scene = {"render", "cube", "--size", "12x11", "--clear", "0.2,0.4,0.6,0.5", "--out"};
  for (const char* name : {"linear.npy", "stored.png"}) {
    Arguments arguments = scene;
    arguments.push_back(path(name));
    ASSERT_EQ(run_lodestone(arguments).status, 0);
  }
  EXPECT_EQ(metrics("linear.npy", "stored.png")["max"], 0);
}

TEST_F(Compare, PicturesOfOtherSizesOrKindsAreBadInput) {
  ASSERT_EQ(run_lodestone({"render", "cube", "--size", "11x12", "--out", path("c.png")}).status, 0);
  const auto expect_bad = [&](const std::string& b, const std::string& message, const Arguments& more = {}) {
    const Outcome run = compare("a.png", b, more);
    EXPECT_EQ(run.status, 3);
    EXPECT_TRUE(is_one_error_line(run.err)) << run.err;
    EXPECT_THAT(run.err, HasSubstr(message));
    EXPECT_THAT(run.out, IsEmpty());
  };
  expect_bad("c.png", "c.png: 11 x 12 px: expected 12 x 11 px");
  expect_bad("a_z.npy", "a_z.npy: has depth: expected colour");
  expect_bad("none.png", "none.png: ");
  write_text(path("text.npy"), "text");
  expect_bad("text.npy", "text.npy: expected a NumPy array");
  write_text(path("cut.npy"), file_text(path("b.npy")).substr(0, 200));
  expect_bad("cut.npy", "cut.npy: expected as many elements as the array's shape has");
  expect_bad("b.npy", "cannot be written", {"--map", path("no/map.png")});
}

TEST_F(Compare, WhatCannotBeMeantIsWrongUsage) {
  const auto expect_wrong = [&](const Arguments& more, const std::string& message) {
    const Outcome run = compare("a.png", "b.png", more);
    EXPECT_EQ(run.status, 2);
    EXPECT_TRUE(is_one_error_line(run.err)) << run.err;
    EXPECT_THAT(run.err, HasSubstr(message));
  };
  expect_wrong({"--metrics", "flop"},
               "--metrics: expected max, differing, rmse, psnr, ssim, ms-ssim, flip or hdr-flip, found \"flop\"");
  expect_wrong({"--metrics", ""}, "--metrics: expected");
  expect_wrong({"--fail-if", "max=3"}, "--fail-if: expected METRIC<VALUE or METRIC>VALUE, found \"max=3\"");
  expect_wrong({"--fail-if", "max>"}, "--fail-if: expected METRIC<VALUE");
  expect_wrong({"--fail-if", "mse>3"}, "--fail-if: expected max, differing");
  expect_wrong({"--map", "map.exr"}, "--map map.exr: expected a file ending in .png");
}

}  // namespace
}  // namespace lode::tests
