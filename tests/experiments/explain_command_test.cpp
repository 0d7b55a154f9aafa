/// `explain`: its answers are render's pictures, in words and in JSON.

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <cstring>
#include <nlohmann/json.hpp>

#include "experiments/explain/explained_scene.h"
#include "geometry/random.h"
#include "raster/render.h"
#include "tests/experiments/run_program.h"

namespace lode::tests {
namespace {

using experiments::view_distance;
using testing::HasSubstr;

Outcome explain(const Arguments& arguments) {
  Arguments all = {"explain"};
  all.insert(all.end(), arguments.begin(), arguments.end());
  return run_lodestone(all);
}

void expect_wrong_usage(const Arguments& arguments, const std::string& message) {
  const Outcome run = explain(arguments);
  EXPECT_EQ(run.status, 2) << message;
  EXPECT_TRUE(is_one_error_line(run.err)) << run.err;
  EXPECT_THAT(run.err, HasSubstr(message));
}

TEST(ExplainCommand, AgreesWithRenderedScenesBitForBit) {
  constexpr glm::ivec2 kSize(96, 64);
  for (const char* name :
       {"alpha", "ground", "spheres:side=3,segments=12", "torus:segments=9,sides=5", "terrain:cells=6"}) {
    for (const techniques::ColorSpace space : {techniques::ColorSpace::srgb, techniques::ColorSpace::raw}) {
      const experiments::SceneView view = experiments::open_view({.scene = name, .camera = {}, .size_px = kSize});
      const techniques::SceneDraws scene_draws(view.scene, {.color_space = space});
      const std::vector<raster::Draw> draws = scene_draws.draws(view.camera, kSize);
      const raster::Frame frame{.draws = draws, .clear = {0.1f, 0.2f, 0.3f, 1.0f}, .viewport = {}, .scissor = {}};
      raster::Image image = raster::make_image(kSize, techniques::color_format(space));
      raster::render(frame, image, {.threads = 1});
      geometry::Random random(7, 0);
      for (int k = 0; k < 60; ++k) {
        const glm::ivec2 pixel(random.below(96), random.below(64));
        const auto i = std::size_t(pixel.y * kSize.x + pixel.x);
        const auto e = raster::explain_pixel(frame, kSize, image.format, pixel, 1);
        ASSERT_EQ(e.samples[0].ids, image.ids[i]) << name << " " << pixel.x << "," << pixel.y;
        ASSERT_EQ(e.samples[0].depth, image.depth[i]) << name << " " << pixel.x << "," << pixel.y;
        const glm::vec4 color = space == techniques::ColorSpace::raw ? glm::vec4(image.rgba8[i]) : image.rgba32f[i];
        ASSERT_EQ(e.color, color) << name << " " << pixel.x << "," << pixel.y;
      }
    }
  }
}

TEST(ExplainCommand, JsonHasTheWinnerAndItsReasons) {
  const TemporaryDirectory directory;
  const Arguments view = {"sphere", "--size", "33x33", "--out", directory / "c.npy", "--ids", directory / "i.npy"};
  Arguments render = view;
  render.insert(render.begin(), "render");
  ASSERT_EQ(run_lodestone(render).status, 0);
  const std::string color = read_npy(directory / "c.npy").bytes, ids = read_npy(directory / "i.npy").bytes;
  const std::size_t place = 16 * 33 + 17;
  std::uint32_t id[2];
  float rgba[4];
  std::memcpy(id, &ids[place * sizeof id], sizeof id);
  std::memcpy(rgba, &color[place * sizeof rgba], sizeof rgba);

  Arguments arguments = view;
  arguments.insert(arguments.begin() + 1, {"17,16", "--json"});
  const Outcome run = explain(arguments);
  ASSERT_EQ(run.status, 0) << run.err;
  const auto json = nlohmann::json::parse(run.out);
  EXPECT_EQ(json["pixel"], nlohmann::json::parse("[17, 16]"));
  const auto sample = json["samples"][0];
  EXPECT_EQ(sample["position_fx8"], nlohmann::json::parse("[4480, 4224]"));
  EXPECT_EQ(sample["ids"][0], id[0]);
  EXPECT_EQ(sample["ids"][1], id[1]);
  for (std::size_t c = 0; c < 4; ++c) EXPECT_EQ(json["color"][c].get<float>(), rgba[c]);
  const auto winner = sample["pieces"][0];
  EXPECT_EQ(winner["fate"], "shown");
  EXPECT_EQ(winner["primitive"], id[1]);
  EXPECT_EQ(winner["edges"].size(), 3u);
  EXPECT_EQ(winner["weights"].size(), 3u);
  EXPECT_TRUE(winner["shading"].contains("shaded"));
  EXPECT_EQ(winner["after"], json["color"]);
  bool back_culled = false;
  for (const auto& piece : sample["pieces"]) back_culled = back_culled || piece["fate"] == "facing";
  EXPECT_TRUE(back_culled);
}

TEST(ExplainCommand, TextIsForPeople) {
  const Outcome shown = explain({"cube", "640,360"});
  EXPECT_EQ(shown.status, 0) << shown.err;
  for (const char* words :
       {"pixel 640,360 of 1280 x 720: cube", "1. SHOWN, nearest of the solid ones: draw 0", "edges  ", "weights  ",
        "shaded  ", "culled: shows its back", "The whole frame: 12 primitives"}) {
    EXPECT_THAT(shown.out, HasSubstr(words));
  }
  EXPECT_THAT(explain({"cube", "0,0"}).out, HasSubstr("nothing covers it: the clear colour is what is seen"));
  const std::string glass = explain({"alpha", "700,360"}).out;
  EXPECT_THAT(glass, HasSubstr("DRAWN over it, strictly nearer than"));
  EXPECT_THAT(glass, HasSubstr("level of detail"));
}

TEST(ExplainCommand, SeveralSamplesAreListedAndOneIsTold) {
  const std::string text = explain({"cube", "640,360", "--samples", "4", "--sample", "2"}).out;
  EXPECT_THAT(text, HasSubstr("the mean of 4 samples:"));
  EXPECT_THAT(text, HasSubstr("3 at (640.875, 360.875)"));
  EXPECT_THAT(text, HasSubstr("At the sample (640.625, 360.375):"));
  expect_wrong_usage({"cube", "1,1", "--samples", "4", "--sample", "4"}, "--sample: expected a whole number below 4");
}

TEST(ExplainCommand, APixelThatIsNoneIsWrongUsage) {
  expect_wrong_usage({"cube", "10,10", "--size", "10x10"}, "X,Y: expected a pixel inside 10x10, found \"10,10\"");
  for (const char* pixel : {"1", "1,2,3", "-1,2", "a,b"}) {
    expect_wrong_usage({"cube", pixel}, "X,Y: expected X,Y in whole pixels");
  }
  expect_wrong_usage({"cube"}, "PIXEL");
}

TEST(ExplainCommand, DepthIsToldAsADistance) {
  geometry::Camera camera;
  camera.near = 0.5;
  EXPECT_DOUBLE_EQ(view_distance(camera, 0.05), 10.0);  // n/z
  camera.far = 100.0;
  EXPECT_DOUBLE_EQ(view_distance(camera, 0.5 * 90.0 / (10.0 * 99.5)), 10.0);
  camera.projection = geometry::Projection::orthographic;
  EXPECT_DOUBLE_EQ(view_distance(camera, 90.0 / 99.5), 10.0);
}

}  // namespace
}  // namespace lode::tests
