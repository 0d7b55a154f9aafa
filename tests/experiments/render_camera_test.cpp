/// Cameras on the command line, and the depth that they give.

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <cstring>

#include "experiments/camera_options.h"
#include "experiments/error.h"
#include "geometry/trigonometry.h"
#include "tests/experiments/run_program.h"

namespace lode::tests {
namespace {

using experiments::CameraOptions;
using testing::HasSubstr;

constexpr double kInf = std::numeric_limits<double>::infinity();

/// Depth of the middle pixel, whose sample looks straight ahead.
float middle_depth(const Arguments& camera) {
  const TemporaryDirectory directory;
  Arguments arguments = {"render", "cube:side=2", "--size", "3x3", "--depth", directory / "z.npy"};
  arguments.insert(arguments.end(), camera.begin(), camera.end());
  const Outcome run = run_lodestone(arguments);
  EXPECT_EQ(run.status, 0) << run.err;
  const NpyArray array = read_npy(directory / "z.npy");
  EXPECT_EQ(array.header, "{'descr': '<f4', 'fortran_order': False, 'shape': (3, 3, ), }");
  float depth = -1.0f;
  std::memcpy(&depth, &array.bytes[4 * sizeof depth], sizeof depth);
  return depth;
}

geometry::Camera camera_of(const CameraOptions& options, const geometry::Scene& scene = {}) {
  return choose_camera(read_camera_options(options), scene, scene.bounds(), {100, 100});
}

void expect_wrong_usage(const Arguments& camera, const std::string& message) {
  Arguments arguments = {"render", "sphere", "--size", "2x2"};
  arguments.insert(arguments.end(), camera.begin(), camera.end());
  const Outcome run = run_lodestone(arguments);
  EXPECT_EQ(run.status, 2) << message;
  EXPECT_TRUE(is_one_error_line(run.err)) << run.err;
  EXPECT_THAT(run.err, HasSubstr(message));
}

TEST(RenderCamera, DepthFollowsTheFormulas) {
  // The cube's face at z = 1 is at distance d = 10 from an eye at z = 11; n = 0.5, f = 100.
  const Arguments from_front = {"--eye", "0,0,11", "--look-at", "0,0,0", "--near", "0.5"};
  const auto with = [&](Arguments more) {
    more.insert(more.begin(), from_front.begin(), from_front.end());
    return middle_depth(more);
  };
  EXPECT_FLOAT_EQ(with({}), 0.5f / 10.0f);  // n/d
  EXPECT_FLOAT_EQ(with({"--far", "inf"}), 0.05f);
  EXPECT_FLOAT_EQ(with({"--far", "100"}), float(0.5 * 90.0 / (10.0 * 99.5)));   // n(f − d)/(d(f − n))
  EXPECT_FLOAT_EQ(with({"--ortho", "4", "--far", "100"}), float(90.0 / 99.5));  // (f − d)/(f − n)
  EXPECT_EQ(with({"--far", "9"}), 0.0f);                                        // all of it is beyond
}

TEST(RenderCamera, NearIsAThousandthOfTheDiagonalAndOrthographicFarIsBehindTheScene) {
  // The cube's diagonal is 2√3: near = 0.0034641.
  EXPECT_FLOAT_EQ(middle_depth({"--eye", "0,0,11", "--look-at", "0,0,0"}), float(0.0034641016151377544 / 10.0));
  // n = 0, f = 12 + 0.0034641: (f − 10)/f.
  EXPECT_FLOAT_EQ(middle_depth({"--eye", "0,0,11", "--look-at", "0,0,0", "--ortho", "4", "--near", "0"}),
                  float(2.0034641016151378 / 12.003464101615138));
  CameraOptions nothing_there;
  nothing_there.eye = "0,0,1";
  nothing_there.look_at = "0,0,0";
  EXPECT_EQ(camera_of(nothing_there).near, 0.001);
}

TEST(RenderCamera, TheFieldOfViewIsVerticalAndUpIsUp) {
  CameraOptions options;
  options.eye = "-1,-2,-3";
  options.look_at = "-1,-2,5";
  options.up = "-1,0,0";
  options.fov = "90";
  const geometry::Camera camera = camera_of(options);
  EXPECT_NEAR(camera.tan_half_fov_y, 1.0, 1e-15);
  EXPECT_EQ(camera.eye, glm::dvec3(-1, -2, -3));
  EXPECT_EQ(camera.back, glm::dvec3(0, 0, -1));
  EXPECT_EQ(camera.up, glm::dvec3(-1, 0, 0));
  EXPECT_EQ(camera.far, kInf);
  options.fov.reset();
  EXPECT_DOUBLE_EQ(camera_of(options).tan_half_fov_y, geometry::tangent(geometry::kPi / 8.0));
}

TEST(RenderCamera, TheScenesOwnCamerasGoByNameOrIndexAndTheFirstIsTheDefault) {
  geometry::Scene scene;
  scene.name = "two.gltf";
  scene.cameras.resize(3);
  scene.cameras[0] = {"front", {.eye = {0, 0, 1}}};
  scene.cameras[1] = {"back", {.eye = {0, 0, 2}}};
  scene.cameras[2] = {"0", {.eye = {0, 0, 3}}};
  const auto z_of = [&](std::optional<std::string> name) {
    CameraOptions options;
    options.camera = std::move(name);
    return camera_of(options, scene).eye.z;
  };
  EXPECT_EQ(z_of(std::nullopt), 1.0);
  EXPECT_EQ(z_of("back"), 2.0);
  EXPECT_EQ(z_of("1"), 2.0);
  EXPECT_EQ(z_of("0"), 3.0);  // a name comes before an index
  try {
    static_cast<void>(z_of("3"));
    FAIL();
  } catch (const experiments::Error& error) {
    EXPECT_EQ(error.status(), experiments::Status::bad_input);
    EXPECT_STREQ(error.what(), "two.gltf: no camera \"3\": expected one of 0 \"front\", 1 \"back\", 2 \"0\"");
  }
}

// Two points 6 apart, walked in 4 frames: frame 1 is a third of the way, 2 along.
TEST(RenderCamera, AnyFrameOfAWalkIsACamera) {
  geometry::Scene scene;
  scene.name = "walk";
  scene.paths = {{.name = "main street", .points = {{0, 0, 0}, {0, 0, -6}}, .n_frames = 4}};
  CameraOptions options;
  options.camera = "main street 1";
  EXPECT_EQ(camera_of(options, scene).eye, glm::dvec3(0, 0, -2));
  for (const char* none : {"main street 4", "main street", "main street -1", "street 1"}) {
    options.camera = none;
    try {
      static_cast<void>(camera_of(options, scene));
      ADD_FAILURE() << none;
    } catch (const experiments::Error& error) {
      EXPECT_EQ(error.what(),
                std::string("walk: no camera \"") + none + "\": expected one of \"main street FRAME\" up to 3");
    }
  }
}

TEST(RenderCamera, WithoutAnyCameraTheSceneIsFramed) {
  // The scene's middle is in the middle of the picture, and nothing touches its border.
  for (const char* scene : {"sphere:x=1000,y=-3,z=2,radius=5", "terrain:cells=4", "cube"}) {
    const TemporaryDirectory directory;
    const Outcome run = run_lodestone({"render", scene, "--size", "64x36", "--ids", directory / "ids.npy"});
    ASSERT_EQ(run.status, 0) << run.err;
    const std::string ids = read_npy(directory / "ids.npy").bytes;
    const auto covered = [&](int x, int y) { return ids[std::size_t(8 * (64 * y + x))] == '\0'; };
    EXPECT_TRUE(covered(32, 18)) << scene;
    for (int x = 0; x < 64; ++x) EXPECT_FALSE(covered(x, 0) || covered(x, 35)) << scene;
    for (int y = 0; y < 36; ++y) EXPECT_FALSE(covered(0, y) || covered(63, y)) << scene;
  }
}

TEST(RenderCamera, ContradictionsAreWrongUsage) {
  const Arguments placed = {"--eye", "0,0,5", "--look-at", "0,0,0"};
  const auto with = [&](Arguments more) {
    more.insert(more.begin(), placed.begin(), placed.end());
    return more;
  };
  expect_wrong_usage(with({"--camera", "0"}),
                     "--camera and --eye: expected one of the scene's cameras, or one placed by --eye");
  expect_wrong_usage({"--camera", "0", "--fov", "30"}, "--camera and --fov");
  expect_wrong_usage(with({"--fov", "30", "--ortho", "2"}), "--fov and --ortho: expected one of them");
  expect_wrong_usage(with({"--ortho", "2", "--far", "inf"}), "--ortho with --far inf: expected a finite far plane");
  expect_wrong_usage({"--eye", "0,0,5"}, "--eye: expected --eye and --look-at with it");
  expect_wrong_usage({"--near", "1"}, "--near: expected --eye and --look-at with it");
  expect_wrong_usage({"--eye", "1,2,3", "--look-at", "1,2,3"}, "expected two different points, found 1,2,3 twice");
  expect_wrong_usage(with({"--near", "2", "--far", "1"}), "far: expected a number above near");
}

TEST(RenderCamera, ValuesOutOfRangeAreWrongUsage) {
  const auto with = [](const char* option, const char* value) {
    return Arguments{"--eye", "0,0,5", "--look-at", "0,0,0", option, value};
  };
  expect_wrong_usage({"--eye", "0,0", "--look-at", "0,0,0"}, "--eye: expected three numbers x,y,z, found \"0,0\"");
  expect_wrong_usage({"--eye", "0,0,nan", "--look-at", "0,0,0"}, "--eye: expected three numbers x,y,z");
  for (const char* fov : {"0", "180", "-1", "inf", "wide"}) expect_wrong_usage(with("--fov", fov), "--fov: expected");
  for (const char* near : {"0", "-1", "nan"}) expect_wrong_usage(with("--near", near), "--near: expected");
  expect_wrong_usage(with("--far", "infinity"), "--far: expected a number or inf, found \"infinity\"");
  expect_wrong_usage(with("--ortho", "0"), "--ortho: expected a number above 0");
  expect_wrong_usage(with("--up", "0,0,0"), "--up: expected a direction, not 0,0,0");
}

}  // namespace
}  // namespace lode::tests
