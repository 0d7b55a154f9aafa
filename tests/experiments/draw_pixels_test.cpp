/// Each geometry and each state key of a picture reaches the renderer: tiny pictures, printed.

#include <gtest/gtest.h>

#include <string>

#include "tests/experiments/run_program.h"

namespace lode::tests {
namespace {

/// The picture as `--print` shows it, or the error.
std::string printed(const std::string& json) {
  const Outcome run = run_lodestone({"draw", "-", "--print"}, json);
  return run.status == 0 ? "\n" + run.out : run.err;
}

/// A picture of 4 x 4 px with these draws.
std::string picture(const std::string& draws) { return R"({"size": [4, 4], "draws": [)" + draws + "]}"; }

// Centres (i + ½, j + ½) with i + j + 1 < 4; those on the slanted edge, a right one, are not covered.
const std::string kCorner = R"({"triangles": [[0,0,0.5], [0,4,0.5], [4,0,0.5]])";
const char* const kCornerPrinted = R"(
AAA.
AA..
A...
....
)";
// Behind it, over the whole picture.
const std::string kGround = R"({"quads": [[0,0,0.25], [0,4,0.25], [4,4,0.25], [4,0,0.25]])";

TEST(DrawPixels, TrianglesAndQuadsPrintALetterADraw) {
  EXPECT_EQ(printed(picture(kCorner + "}")), kCornerPrinted);
  EXPECT_EQ(printed(picture(kCorner + "}," + kGround + "}")), R"(
AAAB
AABB
ABBB
BBBB
)");
}

TEST(DrawPixels, LettersGoFromCapitalsToSmallOnesAndRound) {
  // One point a pixel of one row; draw 0 is A, 25 Z, 26 a, 51 z, 52 A again.
  std::string points;
  for (int i = 0; i < 53; ++i) {
    points += std::string(i ? "," : "") + R"({"points": [[)" + std::to_string(i) + ".5,0.5,1]]}";
  }
  EXPECT_EQ(printed(R"({"size": [53, 1], "draws": [)" + points + "]}"),
            "\nABCDEFGHIJKLMNOPQRSTUVWXYZabcdefghijklmnopqrstuvwxyzA\n");
}

TEST(DrawPixels, SubPixelsAreTakenAsTheyAre) {
  // 128/256 is the first pixel's centre: a corner there, with the top and left edges through it, covers it.
  const std::string triangle = R"("draws": [{"triangles": [[128,128,0.5], [128,640,0.5], [640,128,0.5]]}]})";
  EXPECT_EQ(printed(R"({"size": [3, 3], "unit": "1/256", )" + triangle), "\nAA.\nA..\n...\n");
  // One sub-pixel further right: the left edge has passed column 0, the slanted one (1, 1) and (2, 0).
  const std::string moved = R"("draws": [{"triangles": [[129,128,0.5], [129,640,0.5], [641,128,0.5]]}]})";
  EXPECT_EQ(printed(R"({"size": [3, 3], "unit": "1/256", )" + moved), "\n.AA\n.A.\n...\n");
}

TEST(DrawPixels, LinesLeaveTheirLastDiamond) {
  // Through the centres of row 0: the diamond of pixel 3 holds the end and is never left.
  EXPECT_EQ(printed(picture(R"({"lines": [[0.5,0.5,0.5], [3.5,0.5,0.5]]})")), "\nAAA.\n....\n....\n....\n");
  // The strip turns down at (3.5, 0.5): that pixel belongs to the second segment.
  EXPECT_EQ(printed(picture(R"({"line_strip": [[0.5,0.5,0.5], [3.5,0.5,0.5], [3.5,2.5,0.5]]})")),
            "\nAAAA\n...A\n....\n....\n");
}

TEST(DrawPixels, StippleTakesTheLowestBitFirst) {
  // 5 = 101 in binary, then zeros: fragments 0 and 2; with factor 2, fragments 0, 1, 4, 5.
  EXPECT_EQ(printed(R"({"size": [7, 1], "draws": [{"lines": [[0.5,0.5,0], [6.5,0.5,0]], "stipple": {"pattern": 5}}]})"),
            "\nA.A....\n");
  EXPECT_EQ(printed(R"({"size": [7, 1], "draws": [{"lines": [[0.5,0.5,0], [6.5,0.5,0]],
                        "stipple": {"pattern": 5, "factor": 2}}]})"),
            "\nAA..AA.\n");
}

TEST(DrawPixels, PointsAreSquaresAndDiscsAreRound) {
  // Side 3 about (2.5, 2.5): [1, 4) both ways. Radius 1: the centre and its neighbours, which lie at exactly 1.
  const std::string end = "]}";
  EXPECT_EQ(printed(R"({"size": [5, 5], "draws": [{"points": [[2.5,2.5,0.5]], "point_size": 3})" + end),
            "\n.....\n.AAA.\n.AAA.\n.AAA.\n.....\n");
  EXPECT_EQ(printed(R"({"size": [5, 5], "draws": [{"discs": [{"center": [2.5,2.5,0.5], "radius": 1}]})" + end),
            "\n.....\n..A..\n.AAA.\n..A..\n.....\n");
  // The same in 1/256 px: 640 = 2.5 px, 768 = 3 px, 256 = 1 px.
  EXPECT_EQ(
      printed(R"({"size": [5, 5], "unit": "1/256", "draws": [{"points": [[640,640,0.5]], "point_size": 768})" + end),
      "\n.....\n.AAA.\n.AAA.\n.AAA.\n.....\n");
  EXPECT_EQ(
      printed(R"({"size": [5, 5], "unit": "1/256", "draws": [{"discs": [{"center": [640,640,0.5], "radius": 256}]})" +
              end),
      "\n.....\n..A..\n.AAA.\n..A..\n.....\n");
}

TEST(DrawPixels, SurfelsGoThroughTheirMatrix) {
  // Clip space is world space: pixel centres lie at ±0.25 and ±0.75; 0.25·√2 < 0.5 < 0.75.
  const std::string surfel = R"({"surfels": [{"center": [0,0,0.5], "normal": [0,0,1], "radius": 0.5}])";
  const char* const small = "\n....\n.AA.\n.AA.\n....\n";
  EXPECT_EQ(printed(picture(surfel + "}")), small);
  // Twice as large, by the draw's own matrix: 2·0.5 reaches (0.75, 0.25), not (0.75, 0.75).
  const char* const large = "\n.AA.\nAAAA\nAAAA\n.AA.\n";
  const std::string twice = R"("clip_from_world": [2,0,0,0, 0,2,0,0, 0,0,1,0, 0,0,0,1])";
  EXPECT_EQ(printed(picture(surfel + ", " + twice + "}")), large);
  EXPECT_EQ(printed(R"({"size": [4, 4], )" + twice + R"(, "draws": [)" + surfel + "}]}"), large);
}

TEST(DrawPixels, ClipSpaceHasYUp) {
  // The upper left quarter: x from −1 to 0, y from 0 to 1.
  EXPECT_EQ(printed(picture(R"({"clip_quads": [[-1,0,0.5,1], [0,0,0.5,1], [0,1,0.5,1], [-1,1,0.5,1]]})")),
            "\nAA..\nAA..\n....\n....\n");
  EXPECT_EQ(printed(picture(R"({"clip": [[-1,-1,0.5,1], [3,-1,0.5,1], [-1,3,0.5,1]]})")), "\nAAAA\nAAAA\nAAAA\nAAAA\n");
  EXPECT_EQ(printed(picture(R"({"clip_points": [[0.25,0.25,0.5,1]]})")), "\n....\n..A.\n....\n....\n");
  EXPECT_EQ(printed(picture(R"({"clip_lines": [[-0.75,0.75,0.5,1], [0.75,0.75,0.5,1]]})")),
            "\nAAA.\n....\n....\n....\n");
  EXPECT_EQ(printed(picture(R"({"clip_line_strip": [[-0.75,0.75,0.5,1], [0.75,0.75,0.5,1], [0.75,-0.25,0.5,1]]})")),
            "\nAAAA\n...A\n....\n....\n");
}

TEST(DrawPixels, CullingGoesByTheWindingOnScreen) {
  // (0−0)(0−0) − (4−0)(4−0) = −16 < 0: counter-clockwise, a front face.
  EXPECT_EQ(printed(picture(kCorner + R"(, "cull": "back"})")), kCornerPrinted);
  EXPECT_EQ(printed(picture(kCorner + R"(, "cull": "front"})")), "\n....\n....\n....\n....\n");
}

TEST(DrawPixels, ScissorsLimitAPictureAndADraw) {
  EXPECT_EQ(printed(R"({"size": [4, 4], "scissor": [1, 0, 9, 3], "draws": [)" + kGround + "}," +
                    R"({"points": [[0.5,0.5,1], [3.5,3.5,1]]}]})"),
            "\n.AAA\n.AAA\n.AAA\n....\n");
  EXPECT_EQ(printed(picture(kGround + R"(, "scissor": [2, 2, 1, 1]}, {"points": [[0.5,0.5,1]]})")),
            "\nB...\n....\n..A.\n....\n");
  EXPECT_EQ(printed(picture(kGround + R"(, "scissor": [-9, -9, 3, 0]})")), "\n....\n....\n....\n....\n");
}

TEST(DrawPixels, DepthTestAndDepthWriteAreSwitches) {
  // Without its test the far quad, ordered after the order-free triangle, hides it and leaves its ids.
  EXPECT_EQ(printed(picture(kCorner + "}," + kGround + R"(, "depth_test": false})")), "\nBBBB\nBBBB\nBBBB\nBBBB\n");
  // Printed though it writes no depth and no ids; tested all the same.
  EXPECT_EQ(printed(picture(kCorner + "}," + kGround + R"(, "depth_write": false})")), "\nAAAB\nAABB\nABBB\nBBBB\n");
}

TEST(DrawPixels, AlphaTestCutsByTheTexel) {
  // Left column of texels transparent, right one opaque; the quad shows each in a half.
  EXPECT_EQ(printed(picture(kGround + R"(, "uv": [[0,0],[0,1],[1,1],[1,0]], "alpha_test": 0.5,
    "texture": {"size": [2,1], "rgba": [255,255,255,0, 255,255,255,255]}})")),
            "\n..AA\n..AA\n..AA\n..AA\n");
}

}  // namespace
}  // namespace lode::tests
