/// What `render` writes: planes, statistics, and which options go together.

#include "raster/render.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <cstring>
#include <nlohmann/json.hpp>
#include <span>

#include "experiments/scene_options.h"
#include "experiments/sha256.h"
#include "raster/srgb.h"
#include "techniques/scene_draws.h"
#include "tests/experiments/run_program.h"

namespace lode::tests {
namespace {

using testing::ElementsAre;
using testing::HasSubstr;
using testing::IsEmpty;

Outcome render(const Arguments& arguments) {
  Arguments all = {"render"};
  all.insert(all.end(), arguments.begin(), arguments.end());
  return run_lodestone(all);
}

nlohmann::json stats_of(const Arguments& arguments) {
  Arguments all = arguments;
  all.insert(all.end(), {"--stats", "-"});
  const Outcome run = render(all);
  EXPECT_EQ(run.status, 0) << run.err;
  return nlohmann::json::parse(run.out);
}

void expect_wrong_usage(const Arguments& arguments, const std::string& message) {
  const Outcome run = render(arguments);
  EXPECT_EQ(run.status, 2) << message;
  EXPECT_TRUE(is_one_error_line(run.err)) << run.err;
  EXPECT_THAT(run.err, HasSubstr(message));
  EXPECT_EQ(run.out, "");
}

void expect_bad_input(const Arguments& arguments, const std::string& message) {
  const Outcome run = render(arguments);
  EXPECT_EQ(run.status, 3) << message;
  EXPECT_TRUE(is_one_error_line(run.err)) << run.err;
  EXPECT_THAT(run.err, HasSubstr(message));
}

template <class Element>
std::string bytes_of(const raster::PixelPlane<Element>& plane) {
  return {reinterpret_cast<const char*>(plane.data()), plane.size() * sizeof(Element)};
}

TEST(Render, IsTheFrameOfTheScenesDraws) {
  const TemporaryDirectory directory;
  const Outcome run = render({"alpha", "--size", "64x36", "--clear", "1,0,0,0.5", "--out", directory / "c.npy",
                              "--depth", directory / "z.npy", "--ids", directory / "i.npy"});
  ASSERT_EQ(run.status, 0) << run.err;
  EXPECT_EQ(run.out + run.err, "");

  const experiments::SceneView view = experiments::open_view({.scene = "alpha", .camera = {}, .size_px = {64, 36}});
  const techniques::SceneDraws scene_draws(view.scene, {});
  const std::vector<raster::Draw> draws = scene_draws.draws(view.camera, view.size_px);
  raster::Image image = raster::make_image({64, 36}, raster::ColorFormat::rgba32f);
  raster::render({.draws = draws, .clear = {0.5f, 0, 0, 0.5f}, .viewport = {}, .scissor = {}}, image);

  const NpyArray color = read_npy(directory / "c.npy");
  EXPECT_EQ(color.header, "{'descr': '<f4', 'fortran_order': False, 'shape': (36, 64, 4, ), }");
  EXPECT_TRUE(color.bytes == bytes_of(image.rgba32f));
  EXPECT_TRUE(read_npy(directory / "z.npy").bytes == bytes_of(image.depth));
  EXPECT_TRUE(read_npy(directory / "i.npy").bytes == bytes_of(image.ids));
}

TEST(Render, RawPicturesAreBytesAndTheClearColorIsTakenAsItIs) {
  // 0.05 · 255 = 12.75, 0.06 · 255 = 15.3, 0.1 · 255 = 25.5.
  const TemporaryDirectory directory;
  ASSERT_EQ(render({"cube:side=0.001", "--eye", "9,9,9", "--look-at", "19,9,9", "--size", "1x1", "--clear",
                    "0.05,0.06,0.1,0.5", "--color-space", "raw", "--out", directory / "c.npy"})
                .status,
            0);
  const NpyArray color = read_npy(directory / "c.npy");
  EXPECT_EQ(color.header, "{'descr': '|u1', 'fortran_order': False, 'shape': (1, 1, 4, ), }");
  EXPECT_EQ(color.bytes, std::string("\x0D\x0F\x1A\x80"));
}

TEST(Render, TheClearColorIsDisplayValuesAndComesBackFromPng) {
  // Encoded once: 0.2 · 255 = 51, 0.6 · 255 = 153, 1: straight in the file, with alpha 0.4 · 255 = 102.
  const TemporaryDirectory directory;
  ASSERT_EQ(render({"cube", "--eye", "9,9,9", "--look-at", "19,9,9", "--size", "1x1", "--clear", "0.2,0.6,1,0.4",
                    "--out", directory / "c.npy"})
                .status,
            0);
  glm::vec4 linear;
  std::memcpy(&linear, read_npy(directory / "c.npy").bytes.data(), sizeof linear);
  EXPECT_EQ(linear, glm::vec4(raster::srgb_decode(51) * 0.4f, raster::srgb_decode(153) * 0.4f, 0.4f, 0.4f));
  EXPECT_EQ(raster::srgb8_from_linear(linear), glm::u8vec4(51, 153, 255, 102));
}

TEST(Render, StatisticsAreOfTheFirstFrameWithHashesOfAllPlanes) {
  const TemporaryDirectory directory;
  const Outcome run = render({"torus", "--size", "40x30", "--out", directory / "c.npy", "--depth", directory / "z.npy",
                              "--ids", directory / "i.npy", "--stats", directory / "stats.json", "--repeat", "3",
                              "--orbit", "90", "--threads", "2"});
  ASSERT_EQ(run.status, 0) << run.err;
  const auto stats = nlohmann::json::parse(file_text(directory / "stats.json"));
  EXPECT_EQ(stats["scene"], "torus");
  EXPECT_EQ(stats["size"], nlohmann::json::parse("[40, 30]"));
  EXPECT_EQ(stats["threads"], 2);
  EXPECT_EQ(stats["target"], raster::name_of(raster::best_target()));
  EXPECT_EQ(stats["pipeline"], "fast");
  EXPECT_EQ(stats["pixel_contract"], 1);
  EXPECT_GE(stats["prepare_ms"], 0.0);
  EXPECT_EQ(stats["frame_ms"]["n"], 3);
  EXPECT_LE(stats["frame_ms"]["min"], stats["frame_ms"]["median"]);
  EXPECT_LE(stats["frame_ms"]["median"], stats["frame_ms"]["max"]);
  EXPECT_EQ(stats["counters"]["draws_in"], 1);
  EXPECT_EQ(stats["counters"]["primitives_in"], 2 * 64 * 32);
  const auto hash = [&](const char* file) {
    const std::string bytes = read_npy(directory / file).bytes;
    return experiments::sha256_hex(std::as_bytes(std::span(bytes)));
  };
  EXPECT_EQ(stats["sha256"]["color"], hash("c.npy"));
  EXPECT_EQ(stats["sha256"]["depth"], hash("z.npy"));
  EXPECT_EQ(stats["sha256"]["ids"], hash("i.npy"));
}

TEST(Render, StatisticsNameThePipelineAndTheTargetThatRan) {
  const auto ran = [](Arguments more) {
    more.insert(more.begin(), {"cube", "--size", "8x8"});
    const nlohmann::json stats = stats_of(more);
    return stats["pipeline"].get<std::string>() + " " + stats["target"].get<std::string>();
  };
  EXPECT_EQ(ran({}), std::string("fast ") + raster::name_of(raster::best_target()));
  EXPECT_EQ(ran({"--target", "scalar"}), "fast scalar");
  EXPECT_EQ(ran({"--pipeline", "reference"}), "reference scalar");
}

TEST(Render, OptionsOfTheMachineMoveNoBytes) {
  const auto hashes = [](Arguments more) {
    more.insert(more.begin(), {"spheres:side=3", "--size", "70x50"});
    return stats_of(more)["sha256"];
  };
  const auto expected = hashes({"--threads", "1"});
  EXPECT_EQ(hashes({"--threads", "5", "--repeat", "2", "--orbit", "10"}), expected);
  EXPECT_EQ(hashes({"--pipeline", "reference"}), expected);
  using raster::Target;
  for (const Target target : {Target::scalar, Target::sse4, Target::avx2, Target::avx512, Target::neon, Target::wasm}) {
    if (!raster::can_run(target)) continue;
    for (const char* skips : {"all", "none", "frustum", "facing,samples", "occlusion,blocks"}) {
      EXPECT_EQ(hashes({"--target", raster::name_of(target), "--skip", skips}), expected)
          << raster::name_of(target) << " " << skips;
    }
  }
  EXPECT_EQ(hashes({"--technique", "plain"}), expected);
}

TEST(Render, SamplesAreAveragedInLinearLightAndHaveNoDepth) {
  // The cube's right side at x = 3 cuts the view [2, 4] x [-1, 1] in two: two of the four samples lie in it.
  const TemporaryDirectory directory;
  const Arguments view = {"cube:side=6", "--eye", "3,0,9",     "--look-at", "3,0,0",     "--ortho", "2",
                          "--size",      "1x1",   "--shading", "unlit",     "--samples", "4"};
  Arguments arguments = view;
  arguments.insert(arguments.end(), {"--out", directory / "c.npy"});
  ASSERT_EQ(render(arguments).status, 0);
  glm::vec4 average;
  std::memcpy(&average, read_npy(directory / "c.npy").bytes.data(), sizeof average);
  EXPECT_EQ(average, glm::vec4(0.375f, 0.3f, 0.125f, 0.5f));  // half of the material (0.75, 0.6, 0.25)
  EXPECT_EQ(stats_of(view)["sha256"].size(), 1u);
  for (const char* option : {"--depth", "--ids"}) {
    arguments = view;
    arguments.insert(arguments.end(), {option, directory / "no.npy"});
    expect_wrong_usage(arguments, "--samples 4: several samples a pixel have no depth and no ids");
  }
}

TEST(Render, WithoutColorThereIsDepthAndThereAreIds) {
  const auto all = stats_of({"cube", "--size", "9x9"}), less = stats_of({"cube", "--size", "9x9", "--no-color"});
  EXPECT_FALSE(less["sha256"].contains("color"));
  EXPECT_EQ(less["sha256"]["depth"], all["sha256"]["depth"]);
  EXPECT_EQ(less["sha256"]["ids"], all["sha256"]["ids"]);
  EXPECT_EQ(less["counters"]["fragments_shaded"], 0);
  expect_wrong_usage({"cube", "--no-color", "--out", "x.png"}, "--no-color and --out");
}

TEST(Render, OptionsOutOfRangeAreWrongUsage) {
  for (const char* size : {"0x9", "9x0", "32769x1", "9", "9x", "9x9x9", "-9x9", "1e1x5"}) {
    expect_wrong_usage({"cube", "--size", size},
                       "--size: expected WIDTHxHEIGHT, each 1 to 32768, found \"" + std::string(size));
  }
  for (const char* n : {"0", "3", "256", "-1", "1.5", "many"}) {
    expect_wrong_usage({"cube", "--samples", n}, "--samples: expected a power of two up to 128");
  }
  for (const char* clear : {"0,0,0", "0,0,0,2", "-0.1,0,0,0", "0,0,0,nan", "red"}) {
    expect_wrong_usage({"cube", "--clear", clear}, "--clear: expected four numbers r,g,b,a from 0 to 1");
  }
  expect_wrong_usage({"cube", "--shading", "phong"}, "--shading: expected material, lambert or unlit, found \"phong\"");
  expect_wrong_usage({"cube", "--color-space", "linear"}, "--color-space: expected srgb or raw, found \"linear\"");
  expect_wrong_usage({"cube", "--technique", "surfels"}, "--technique: expected plain");
  expect_bad_input({"cube", "--technique", "predicted_reuse:fade=3,fade=4"}, "fade: expected once, found twice");
  expect_bad_input({"cube", "--technique", "plain:k=1"}, "\"k=1\": expected nothing, as there are no parameters");
  for (const char* n : {"0", "-3", "1000001", "x"}) expect_wrong_usage({"cube", "--repeat", n}, "--repeat: expected");
  expect_wrong_usage({"cube", "--orbit", "fast"}, "--orbit: expected a number");
  expect_wrong_usage({}, "SCENE");
}

TEST(Render, OutputsAreCheckedBeforeTheSceneIsRead) {
  expect_wrong_usage({"none.glb", "--out", "picture.jpg"},
                     "--out picture.jpg: expected a file ending in .png, .exr or .npy");
  expect_wrong_usage({"none.glb", "--depth", "d.png"}, "--depth d.png: expected a file ending in .exr or .npy");
  expect_wrong_usage({"none.glb", "--out", "a.npy", "--depth", "./a.npy"}, "named twice");
  expect_bad_input({"sphere", "--out", "no/such/folder/a.png"}, "no/such/folder/a.png: cannot be written");
}

TEST(Render, ScenesThatAreNoneSayWhatIsKnown) {
  expect_bad_input(
      {"sphre"},
      "scene sphre: no such scene: expected a model file (.gltf, .glb, .obj, .ply, .stl) or one of sphere, torus");
  expect_bad_input({"sphere:r=1"}, "\"r=1\": expected NAME=VALUE with one of radius, segments, rings, x, y, z");
  expect_bad_input({"sphere:"}, "expected NAME=VALUE");
  expect_bad_input({"sphere:segments=2.5"}, "segments: expected a whole number 3 to 2048, found \"2.5\"");
  expect_bad_input({"sphere:segments=4096"}, "segments: expected a whole number 3 to 2048");
  expect_bad_input({"sphere:radius=nan"}, "radius: expected a number");
  expect_bad_input({"cube", "--camera", "0"}, "cube: no camera \"0\": the scene has none");
}

TEST(Render, AFailureLeavesNothingBehind) {
  const TemporaryDirectory directory;
  EXPECT_EQ(render({"sphere:radius=x", "--out", directory / "a.png", "--stats", directory / "s.json"}).status, 3);
  EXPECT_THAT(directory.names(), IsEmpty());
  EXPECT_EQ(render({"sphere", "--size", "8x8", "--out", directory / "a.png", "--stats", directory / "s.json"}).status,
            0);
  EXPECT_THAT(directory.names(), ElementsAre("a.png", "s.json"));
}

TEST(Render, NeverReplacesWhatTheSceneIsReadFrom) {
  const TemporaryDirectory directory;
  write_text(directory / "a.obj", "mtllib a.mtl\nv 0 0 0\nv 1 0 0\nv 0 1 0\nusemtl m\nf 1 2 3\n");
  write_text(directory / "a.mtl", "newmtl m\nKd 1 0 0\n");
  for (const char* file : {"a.obj", "a.mtl"}) {
    const Outcome run = render({directory / "a.obj", "--size", "8x8", "--stats", directory / file});
    EXPECT_EQ(run.status, 2) << file;
    EXPECT_TRUE(is_one_error_line(run.err)) << run.err;
  }
  EXPECT_EQ(file_text(directory / "a.mtl"), "newmtl m\nKd 1 0 0\n");
  EXPECT_THAT(directory.names(), ElementsAre("a.mtl", "a.obj"));
}

TEST(Render, ViewsBeyondTheRenderersRangeAreRefused) {
  // 1/tan of half the angle is 1e200 times a coordinate of 1: beyond 2^300, where clip coordinates end.
  expect_bad_input({"cube", "--eye", "0,0,3", "--look-at", "0,0,0", "--fov", "1e-200"}, "cube: with this camera");
  expect_bad_input({"cube", "--eye", "0,0,3", "--look-at", "0,0,0", "--near", "1e-50"}, "expected a larger --near");
}

TEST(Render, AScenesDefaultViewStandsFarFromTheOriginAndAtAnySize) {
  const TemporaryDirectory directory;
  for (const char* size : {"1e17", "1e30", "1e-30"}) {
    const std::string s(size);
    write_text(directory / "a.obj", "v " + s + " 0 0\nv 0 " + s + " 0\nv 0 0 " + s + "\nf 1 2 3\n");
    const Outcome run = render({directory / "a.obj", "--size", "16x16", "--ids", directory / "ids.npy"});
    EXPECT_EQ(run.status, 0) << size << ": " << run.err;
    const std::string ids = read_npy(directory / "ids.npy").bytes;
    EXPECT_EQ(ids[8 * (16 * 8 + 8)], '\0') << size;  // the middle of the picture shows it
  }
}

TEST(Render, HelpHasExamplesThatRun) {
  const Outcome run = render({"--help"});
  EXPECT_EQ(run.status, 0);
  EXPECT_THAT(run.out,
              HasSubstr("lodestone render sphere:segments=200 --eye 3,2,4 --look-at 0,0,0 --fov 30 --out sphere.png"));
  const TemporaryDirectory directory;
  EXPECT_EQ(render({"sphere:segments=200", "--eye", "3,2,4", "--look-at", "0,0,0", "--fov", "30", "--size", "16x9",
                    "--out", directory / "sphere.png"})
                .status,
            0);
}

}  // namespace
}  // namespace lode::tests
