/// What is wrong with a picture is said in one line, with its place.

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "tests/experiments/run_program.h"

namespace lode::tests {
namespace {

/// Bad input, status 3, nothing on standard output, and exactly this line.
void expect_error(const std::string& json, const std::string& message) {
  const Outcome run = run_lodestone({"draw", "-", "--stats", "-"}, json);
  EXPECT_EQ(run.status, 3) << json;
  EXPECT_EQ(run.err, "lodestone: standard input: " + message + "\n") << json;
  EXPECT_EQ(run.out, "") << json;
}

/// A picture with this one draw.
std::string with_draw(const std::string& draw) { return R"({"size": [8, 8], "draws": [)" + draw + "]}"; }

const std::string kTriangle = R"("triangles": [[0,0,0], [0,4,0], [4,0,0]])";

TEST(DrawErrors, SyntaxGivesLineAndColumn) {
  expect_error("{\"size\": [1,\n  x]}",
               "line 2, column 3: syntax error while parsing value - invalid literal; last read: '1,<U+000A>  x'");
  expect_error("{\"size\": [1, 2]",
               "line 1, column 16: syntax error while parsing object - unexpected end of input; expected '}'");
  expect_error(
      "",
      "line 1, column 1: syntax error while parsing value - unexpected end of input; expected '[', '{', or a literal");
  expect_error(std::string("{\n \0}", 5), "line 2, column 2: a NUL byte: expected JSON text");
  expect_error("{\"size\": [1e999, 1]}", "line 1, column 15: number overflow parsing '1e999'");
}

TEST(DrawErrors, UnknownAndDoubledKeysAreNamed) {
  expect_error(R"({"size": [1, 1], "draws": [], "siez": 1})",
               "unknown key \"siez\": expected one of size, unit, clear, samples, clip_from_world, scissor, draws");
  expect_error(with_draw(R"({"discs": [{"center": [1,1,0], "radios": 2}]})"),
               "draws[0].discs[0]: unknown key \"radios\": expected one of center, radius, color");
  expect_error(R"({"size": [1, 1], "draws": [{"points": [], "points": []}]})", "draws[0]: key \"points\" occurs twice");
}

TEST(DrawErrors, ADrawHasExactlyOneGeometry) {
  expect_error(with_draw(R"({"points": [], "lines": []})"),
               "draws[0]: expected one geometry, found \"lines\" and \"points\"");
  expect_error(with_draw(R"({"color": [1,1,1,1]})"),
               "draws[0]: expected a geometry: one of triangles, quads, lines, line_strip, points, discs, surfels, "
               "clip, clip_quads, clip_lines, clip_line_strip, clip_points");
}

TEST(DrawErrors, VerticesComeInThreesAndTwos) {
  expect_error(with_draw(R"({"triangles": [[0,0,0], [1,2,0], [3,4,0], [5,6,0]]})"),
               "draws[0].triangles: expected a multiple of 3 vertices, found 4");
  expect_error(with_draw(R"({"lines": [[0,0,0]]})"), "draws[0].lines: expected a multiple of 2 vertices, found 1");
  expect_error(with_draw(R"({"triangles": [[0,0,0], [1,2], [3,4,0]]})"),
               "draws[0].triangles[1]: expected [x, y, z], found [1,2]");
  expect_error(with_draw(R"({"clip": [[0,0,0], [1,2,0,1], [3,4,0,1]]})"),
               "draws[0].clip[0]: expected [x, y, z, w], found [0,0,0]");
}

TEST(DrawErrors, CoordinatesStayInsideTheGuardBand) {
  expect_error(with_draw(R"({"points": [[32768.5, 0, 0]]})"),
               "draws[0].points[0][0]: expected a number -32768.0 to 32768.0, found 32768.5");
  expect_error(R"({"size": [8, 8], "unit": "1/256", "draws": [{"points": [[0, -8388609, 0]]}]})",
               "draws[0].points[0][1]: expected a whole number -8388608 to 8388608, found -8388609");
  expect_error(with_draw(R"({"points": [[0, 0, 1.5]]})"),
               "draws[0].points[0][2]: expected a number 0.0 to 1.0, found 1.5");
}

TEST(DrawErrors, InSubPixelsCoordinatesAreWhole) {
  expect_error(R"({"size": [8, 8], "unit": "1/256", "draws": [{"points": [[0.5, 0, 0]]}]})",
               "draws[0].points[0][0]: expected a whole number -8388608 to 8388608, found 0.5");
}

TEST(DrawErrors, RangesAreCheckedBeforeAnythingIsAllocated) {
  expect_error(R"({"size": [32769, 1], "draws": []})", "size[0]: expected a whole number 0 to 32768, found 32769");
  expect_error(R"({"size": [1, -1], "draws": []})", "size[1]: expected a whole number 0 to 32768, found -1");
  expect_error(R"({"size": [1, 1], "samples": 3, "draws": []})", "samples: expected a power of two up to 128, found 3");
  expect_error(R"({"size": [1, 1], "scissor": [0, 0, -1, 1], "draws": []})",
               "scissor[2]: expected a whole number 0 to 1000000000, found -1");
  expect_error(with_draw("{" + kTriangle + R"(, "color": [256,0,0,0]})"),
               "draws[0].color[0]: expected a whole number 0 to 255, found 256");
  expect_error(with_draw("{" + kTriangle + R"(, "alpha_test": 1.01})"),
               "draws[0].alpha_test: expected a number 0.0 to 1.0, found 1.01");
  expect_error(with_draw(R"({"lines": [], "stipple": {"factor": 257}})"),
               "draws[0].stipple.factor: expected a whole number 1 to 256, found 257");
  expect_error(with_draw("{" + kTriangle + R"(, "cull": "both"})"),
               "draws[0].cull: expected \"none\", \"back\" or \"front\", found \"both\"");
}

TEST(DrawErrors, AttributesComeOneAVertex) {
  expect_error(with_draw("{" + kTriangle + R"(, "colors": [[1,1,1,1]]})"),
               "draws[0].colors: expected an array of 3, one a vertex, found an array of 1");
  expect_error(with_draw("{" + kTriangle + R"(, "uv": [[1,1,1],[0,0],[0,0]]})"),
               "draws[0].uv[0]: expected [u, v], found [1,1,1]");
  expect_error(with_draw(R"({"discs": [{"center": [0,0,0], "radius": 1, "color": [1,1,1,1]}], "colors": [[1,1,1,1]]})"),
               "draws[0].colors: expected colours here or in the elements, not both");
  expect_error(with_draw(R"({"surfels": [{"center": [0,0,0], "radius": 1}]})"),
               "draws[0].surfels[0]: expected a member \"normal\"");
}

TEST(DrawErrors, TexturesAreWholeAndHaveCoordinates) {
  expect_error(with_draw("{" + kTriangle + R"(, "texture": {"size": [1,1], "rgba": [1,2,3,4]}})"),
               "draws[0]: a texture without \"uv\": expected [u, v] for every vertex");
  const std::string uv = "{" + kTriangle + R"(, "uv": [[0,0],[0,1],[1,0]], "texture": )";
  expect_error(with_draw(uv + R"({"size": [2,1], "rgba": [1,2,3,4]}})"),
               "draws[0].texture.rgba: expected an array of 8 bytes, 4 a texel, found [1,2,3,4]");
  expect_error(with_draw(uv + R"({"size": [0,1], "rgba": []}})"),
               "draws[0].texture.size[0]: expected a whole number 1 to 16384, found 0");
  expect_error(with_draw(uv + R"({"size": [1,1], "rgba": [1,2,3,4], "max_anisotropy": 17}})"),
               "draws[0].texture.max_anisotropy: expected a whole number 1 to 16, found 17");
}

TEST(DrawErrors, StateThatAGeometryDoesNotHaveIsAnError) {
  using testing::HasSubstr;
  const Outcome run = run_lodestone({"draw", "-", "--print"}, with_draw("{" + kTriangle + R"(, "stipple": {}})"));
  EXPECT_EQ(run.status, 3);
  EXPECT_THAT(run.err, HasSubstr("draws[0]: unknown key \"stipple\": expected one of triangles, color"));
}

}  // namespace
}  // namespace lode::tests
