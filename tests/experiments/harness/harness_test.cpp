// The laboratory's floor: rows, what is kept from run to run, and what a culling case says of a technique.
#include <gmock/gmock.h>
#include <sys/stat.h>

#include <cmath>
#include <filesystem>
#include <fstream>

#include "experiments/error.h"
#include "experiments/harness/culling_case.h"
#include "experiments/harness/scene_hash.h"
#include "experiments/harness/true_error.h"
#include "experiments/harness/visible_samples.h"
#include "geometry/procedural.h"
#include "tests/geometry/temporary_folder.h"

namespace lode::experiments {
namespace {

using testing::HasSubstr;
using tests::TemporaryFolder;

TEST(Row, MakesCsvWithAColumnForEveryName) {
  std::vector<Row> rows(2);
  rows[0].add("name", std::string("a, \"b\"")).add("n", std::int64_t(3));
  rows[1].add("n", std::int64_t(-4)).add("ms", 0.1);
  EXPECT_EQ(csv_text(rows), "name,n,ms\n\"a, \"\"b\"\"\",3,\n,-4,0.1\n");
}

TEST(Row, ReadsBackWhatItWrote) {
  std::vector<Row> rows(1), read;
  rows[0].add("text", std::string("x")).add("whole", std::int64_t(1) << 60).add("third", 1.0 / 3.0);
  ASSERT_TRUE(rows_of(rows_json(rows), read));
  EXPECT_EQ(csv_text(read), csv_text(rows));
  EXPECT_EQ(read[0].number("third"), 1.0 / 3.0);
  for (const char* damaged : {"", "{}", "[1]", "[{\"a\": [1]}]", "[{\"a\": 1}"}) EXPECT_FALSE(rows_of(damaged, read));
}

TEST(KeptResults, AreMadeOnceAndAgainWhenDamaged) {
  const TemporaryFolder folder;
  const KeptResults kept(folder.path("kept"));
  int n_made = 0;
  const auto make = [&] { return "value " + std::to_string(++n_made); };
  EXPECT_EQ(kept.get("key", make), "value 1");
  EXPECT_EQ(kept.get("key", make), "value 1");
  EXPECT_EQ(kept.get("another key", make), "value 2");
  const std::string path = kept.path_of("key");
  const auto size = std::filesystem::file_size(path);
  std::fstream(path, std::ios::in | std::ios::out | std::ios::binary).seekp(std::streamoff(size) - 1).put('?');
  EXPECT_EQ(kept.get("key", make), "value 3");
  std::filesystem::resize_file(path, size / 2);
  EXPECT_EQ(kept.get("key", make), "value 4");
  std::filesystem::copy_file(kept.path_of("another key"), path, std::filesystem::copy_options::overwrite_existing);
  EXPECT_EQ(kept.get("key", make), "value 5");  // what is there belongs to another key
  std::filesystem::remove(path);
  ASSERT_EQ(::mkfifo(path.c_str(), 0600), 0);
  EXPECT_FALSE(kept.find("key"));  // nobody writes there: to open it would wait for ever
}

TEST(KeptResults, WithoutAFolderAreMadeEveryTime) {
  const KeptResults kept("");
  kept.keep("key", "value");
  EXPECT_FALSE(kept.find("key"));
}

/// A wall that hides a ball; another ball beside it.
geometry::Scene wall_and_balls() {
  geometry::Scene scene;
  geometry::add_instance(scene, geometry::box({-2.0, -2.0, 0.0}, {2.0, 2.0, 0.2}));
  geometry::add_instance(scene, geometry::sphere({0.0, 0.0, -3.0}, 0.5, 12, 6));
  geometry::add_instance(scene, geometry::sphere({4.0, 0.0, -3.0}, 0.5, 12, 6));
  scene.name = "wall and balls";
  return scene;
}

geometry::Camera front_camera() {
  geometry::Camera camera;
  geometry::look_at(camera, {0.0, 0.0, 8.0}, {0.0, 0.0, 0.0});
  return camera;
}

TEST(VisibleSamples, AreThoseThatEachObjectOwns) {
  const geometry::Scene scene = wall_and_balls();
  const techniques::World world(scene, {}, true, 1);
  const techniques::View view{.camera = front_camera(), .size_px = {80, 60}};
  const VisibleSamples samples = visible_samples(world, view, 1, 0, {.threads = 1});
  EXPECT_EQ(samples.centre[1] + samples.grid[1] + samples.random[1], 0u);  // hidden
  // The wall's front is 4 of 2 · 7.8 · tan(22.5°) = 6.46 units high: 60 · 4 / 6.46 = 37.1 px a side.
  const auto side_of = [](std::uint32_t n_samples, int n_places) { return std::sqrt(double(n_samples) / n_places); };
  EXPECT_NEAR(side_of(samples.centre[0], 1), 37.1, 1.0);
  EXPECT_NEAR(side_of(samples.grid[0], 16), 37.1, 0.3);
  EXPECT_NEAR(side_of(samples.random[0], kRandomOffsets), 37.1, 0.6);
  EXPECT_GT(samples.centre[2], 0u);
  VisibleSamples read;
  ASSERT_TRUE(read_visible_samples(text_of(samples), 3, read));
  EXPECT_EQ(text_of(read), text_of(samples));
  EXPECT_FALSE(read_visible_samples(text_of(samples), 4, read));
  EXPECT_FALSE(read_visible_samples("1 2\n", 3, read));
}

TEST(SceneHash, ChangesWithWhatIsSeen) {
  const geometry::Scene scene = wall_and_balls();
  geometry::Scene other = scene;
  EXPECT_EQ(hash_of(other), hash_of(scene));
  other.instances[1].world_from_object[3].x = 1e-9;
  EXPECT_NE(hash_of(other), hash_of(scene));
}

const Row& row_of(const std::vector<Row>& rows, const std::string& method) {
  for (const Row& row : rows) {
    if (row.text("method") == method) return row;
  }
  throw std::logic_error("no such method");
}

TEST(CullingCase, TellsWhatIsCulledLostAndTaken) {
  const geometry::Scene scene = wall_and_balls();
  const techniques::World world(scene, {}, true, 1);
  const raster::RenderOptions options{.threads = 1};
  std::vector<std::unique_ptr<PreparedMethod>> methods;
  std::vector<PreparedMethod*> pointers;
  for (const char* name : {"plain", "frustum_culling + skips", "hierarchical_z", "inner_boxes", "oracle"}) {
    methods.push_back(std::make_unique<PreparedMethod>(make_method(name), world, options));
    pointers.push_back(methods.back().get());
  }
  CullingCase one;
  one.scene = scene.name, one.scene_hash = hash_of(scene), one.path = "front";
  one.frames = {0}, one.cameras = {front_camera()}, one.size_px = {80, 60}, one.n_rounds = 1;
  int n_steps = 0;
  const CaseResult result = run_culling_case(one, world, pointers, KeptResults(""), options, [&] { ++n_steps; });
  ASSERT_EQ(result.results.size(), 5u);
  ASSERT_EQ(result.times.size(), 5u);
  EXPECT_EQ(n_steps, 1 + 1);  // the results, and one round
  for (const Row& row : result.results) {
    EXPECT_EQ(row.number("visible"), 2.0) << row.text("method");
    EXPECT_EQ(row.number("could_be_culled"), 1.0) << row.text("method");
    EXPECT_EQ(row.number("false_px") + row.number("false_samples_4x4") + row.number("false_samples_random"), 0.0);
    EXPECT_EQ(row.number("same_picture"), 1.0) << row.text("method");
  }
  EXPECT_EQ(row_of(result.results, "plain").number("objects"), 3.0);
  EXPECT_EQ(row_of(result.results, "oracle").number("objects"), 2.0);
  EXPECT_EQ(row_of(result.results, "hierarchical_z").number("culled"), 1.0);
  EXPECT_EQ(row_of(result.results, "inner_boxes").number("culled"), 1.0);
  EXPECT_GT(row_of(result.times, "plain").number("frame_ms"), 0.0);
}

// One sample a pixel makes steps at the wall's sides, which 64 do not: everything is off the truth, and what draws the
// same picture just as far.
TEST(TrueErrors, OfAMethodThatLosesNothingAreThoseOfThePictureOfEverything) {
  const geometry::Scene scene = wall_and_balls();
  const techniques::World world(scene, {}, true, 1);
  const raster::RenderOptions options{.threads = 1};
  PreparedMethod plain(make_method("plain"), world, options), oracle(make_method("oracle"), world, options);
  PreparedMethod* methods[] = {&plain, &oracle};
  CullingCase one;
  one.frames = {7}, one.cameras = {front_camera()}, one.size_px = {80, 60};
  CaseResult result;
  for (const char* method : {"plain", "oracle", "hierarchical_z"}) {
    result.results.emplace_back().add("frame", std::int64_t(7)).add("method", method);
  }
  add_true_errors(one, 0, world, look_hash_of(scene), methods, KeptResults(""), options, result);
  const Row &everything = result.results[0], &same = result.results[1];
  EXPECT_GT(everything.number("flip_true"), 0.0);
  EXPECT_LT(everything.number("psnr_true_db"), 60.0);
  for (const char* column : {"flip_true", "psnr_true_db"}) EXPECT_EQ(same.number(column), everything.number(column));
  EXPECT_EQ(same.text("flip_whole"), "0");
  EXPECT_EQ(same.find("psnr_whole_db"), nullptr);           // of equal pictures there is none
  EXPECT_EQ(result.results[2].find("flip_true"), nullptr);  // it was not asked
}

TEST(Method, IsATechniqueWithOrWithoutTheRenderersSkips) {
  EXPECT_FALSE(make_method("convex_culling:mode=safe").renderer_skips);
  EXPECT_TRUE(make_method("plain + skips").renderer_skips);
  EXPECT_THROW(static_cast<void>(make_method("plane")), Error);
}

}  // namespace
}  // namespace lode::experiments
